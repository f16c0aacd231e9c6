"""Have the gripper of the task's arm do something."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.gripper import GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.context import TreeContext
from tandem.trees.hand_task import HandTask

Gripping = Act[GripGoal, GripFeedback, GripResult]


def grip_with(
    what: str,
    context: TreeContext,
    board: HandTask,
    goal: Callable[[], GripGoal],
    judge: Callable[[GripResult], Failure | None] = accept,
) -> Gripping:
    """Return the leaf that does ``what``; which hand it is, may be known only when it starts."""
    return Act(
        board.node(what),
        context,
        lambda: grip(board.chosen_side()),
        goal,
        resources=lambda: (f"gripper_{board.chosen_side()}",),
        judge=judge,
    )
