"""Move a hand, and believe it only once the arm tells that it stands still."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.arm import MoveFeedback, MoveGoal, MoveResult, move
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.conditions.arm_tucked import at_rest
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard

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
