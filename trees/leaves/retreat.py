"""Draw a hand straight back from whatever it is at, so that its arm can be tucked in."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from tandem.skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.act import Act
from tandem.trees.conditions.arm_tucked import at_rest
from tandem.trees.context import TreeContext

WAYS: Final = ((-0.12, 0.0, 0.0), (-0.07, 0.0, 0.0))
"""Metres in the tool's frame, x out of the hand: as far as from a grasp to its pre-grasp, or half of it."""


def retreat(
    name: str, context: TreeContext, side: Callable[[], HandName]
) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf; with something in the hand the skill lifts it instead, when back is no way."""
    return Act(
        name,
        context,
        lambda: move(f"arm_{side()}"),
        lambda: MoveGoal(by=WAYS),
        resources=lambda: (f"arm_{side()}",),
        believed=lambda _: at_rest(context, side()),
    )
