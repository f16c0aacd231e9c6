"""Open a hand, whatever it was at."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.gripper import Grip, GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext


def open_hand(
    name: str, context: TreeContext, side: Callable[[], HandName]
) -> Act[GripGoal, GripFeedback, GripResult]:
    """Return the leaf."""
    return Act(
        name,
        context,
        lambda: grip(side()),
        lambda: GripGoal(grip=Grip.OPEN),
        resources=lambda: (f"gripper_{side()}",),
    )
