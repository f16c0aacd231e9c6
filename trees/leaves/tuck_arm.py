"""Bring an arm to its posture for driving."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.act import Act
from tandem.trees.conditions.arm_tucked import at_rest
from tandem.trees.context import TreeContext


def tuck_arm(
    name: str, context: TreeContext, side: Callable[[], HandName]
) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: the arm goes to its posture ``carry`` with something in the hand, else ``home``."""

    def goal() -> MoveGoal:
        return MoveGoal(posture="carry" if context.knowledge.may_hold(side()) else "home")

    return Act(
        name,
        context,
        lambda: move(f"arm_{side()}"),
        goal,
        resources=lambda: (f"arm_{side()}",),
        believed=lambda _: at_rest(context, side()),
    )
