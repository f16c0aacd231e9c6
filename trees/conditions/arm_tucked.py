"""Is an arm within the robot's footprint, and at rest?"""

from __future__ import annotations

from tandem.skills.ports.actions.arm import ArmState
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.check import Check
from tandem.trees.context import TreeContext


def at_rest(context: TreeContext, side: HandName) -> bool:
    """Say whether the arm tells that it stands still: the base waits for it (order-picking paper, III-C)."""
    status = context.knowledge.arm(side)
    return status is not None and status.state in {ArmState.ARM_IDLE, ArmState.ARM_SUCCESS}


def tucked(context: TreeContext, side: HandName) -> bool:
    """Say whether the arm is at rest and no farther out than the base allows when it moves."""
    status, description = context.knowledge.arm(side), context.knowledge.description
    if status is None or description is None:
        return False
    if description.drive is None:  # nothing carries the arm anywhere
        return at_rest(context, side)
    return at_rest(context, side) and status.extent <= description.footprint_radius + ARM_MARGIN


def arms_tucked(name: str, context: TreeContext) -> Check:
    """Return the condition "all arms are tucked in"."""
    return Check(name, lambda: all(tucked(context, side) for side in context.knowledge.hands))
