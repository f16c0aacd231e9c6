"""Have the gripper of the task's arm do something."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.gripper import GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext


def grip_with(
    name: str,
    context: TreeContext,
    board: FetchBoard,
    goal: Callable[[], GripGoal],
    judge: Callable[[GripResult], Failure | None] = accept,
) -> Act[GripGoal, GripFeedback, GripResult]:
    """Return the leaf; which hand it is, is known only when it starts."""
    return Act(
        name,
        context,
        lambda: grip(board.chosen_side()),
        goal,
        resources=lambda: (f"gripper_{board.chosen_side()}",),
        judge=judge,
    )
