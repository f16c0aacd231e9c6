"""Move the hand of the task's arm to a pose, or to the first of several that it can get to."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.arm_tucked import at_rest
from tandem.trees.context import TreeContext


def move_hand(
    name: str,
    context: TreeContext,
    board: FetchBoard,
    goal: Callable[[], MoveGoal | Failure],
    judge: Callable[[MoveResult], Failure | None] = accept,
) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf; which arm it is, is known only when it starts."""
    return Act(
        name,
        context,
        lambda: move(f"arm_{board.chosen_side()}"),
        goal,
        resources=lambda: (f"arm_{board.chosen_side()}",),
        judge=judge,
        believed=lambda _: at_rest(context, board.chosen_side()),
    )
