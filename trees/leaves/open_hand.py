"""Open a hand, whatever it was at."""

from __future__ import annotations

from collections.abc import Callable

from skills.ports.actions.gripper import Grip, GripFeedback, GripGoal, GripResult, grip
from skills.ports.world import Side
from trees.behaviours.act import Act
from trees.context import TreeContext


def open_hand(
    name: str, context: TreeContext, side: Callable[[], Side]
) -> Act[GripGoal, GripFeedback, GripResult]:
    """Return the leaf."""
    return Act(
        name,
        context,
        lambda: grip(side()),
        lambda: GripGoal(grip=Grip.OPEN),
        resources=lambda: (f"gripper_{side()}",),
    )
