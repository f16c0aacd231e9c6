"""Move a hand, and believe it only once the arm tells that it stands still."""

from __future__ import annotations

from collections.abc import Callable

from skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from skills.ports.failure import Failure
from trees.behaviours.act import Act, accept
from trees.conditions.arm_tucked import at_rest
from trees.context import TreeContext
from trees.hand_board import HandBoard

Move = Act[MoveGoal, MoveFeedback, MoveResult]


def hand_move(
    what: str,
    context: TreeContext,
    board: HandBoard,
    goal: Callable[[], MoveGoal | Failure],
    judge: Callable[[MoveResult], Failure | None] = accept,
) -> Move:
    """Return the leaf; ``what`` becomes a part of its name."""
    return Act(
        f"{board.who}: {what}",
        context,
        move(board.group),
        goal,
        resources=(board.group,),
        judge=judge,
        believed=lambda _: at_rest(context, board.side),
    )
