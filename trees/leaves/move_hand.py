"""Move the hand of the task's arm to a pose, or to the first of several that it can get to."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.conditions.arm_tucked import at_rest
from tandem.trees.context import TreeContext
from tandem.trees.hand_task import HandTask

Move = Act[MoveGoal, MoveFeedback, MoveResult]


def move_hand(
    what: str,
    context: TreeContext,
    board: HandTask,
    goal: Callable[[], MoveGoal | Failure],
    judge: Callable[[MoveResult], Failure | None] = accept,
) -> Move:
    """Return the leaf that does ``what``; which arm it is, may be known only when it starts."""
    return Act(
        board.node(what),
        context,
        lambda: move(f"arm_{board.chosen_side()}"),
        goal,
        resources=lambda: (f"arm_{board.chosen_side()}",),
        judge=judge,
        believed=lambda _: at_rest(context, board.chosen_side()),
    )
