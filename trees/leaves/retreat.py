"""Draw a hand straight back from whatever it is at, so that its arm can be tucked in."""

from __future__ import annotations

from typing import Final

from skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from skills.ports.world import Side
from trees.behaviours.act import Act
from trees.conditions.arm_tucked import at_rest
from trees.context import TreeContext

WAYS: Final = ((-0.12, 0.0, 0.0), (-0.07, 0.0, 0.0))
"""Metres in the tool's frame, x out of the hand: as far as from a grasp to its pre-grasp, or half of it."""


def retreat(name: str, context: TreeContext, side: Side) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf; with something in the hand the skill lifts it instead, when back is no way."""
    group = f"arm_{side}"
    return Act(
        name,
        context,
        move(group),
        lambda: MoveGoal(by=WAYS),
        resources=(group,),
        believed=lambda _: at_rest(context, side),
    )
