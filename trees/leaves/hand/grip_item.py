"""Open a hand for its item, close it around it, and ask whether it is there."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.gripper import Grip, GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard

Gripping = Act[GripGoal, GripFeedback, GripResult]


def open_for_item(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: as wide as the item needs; a hand that presses on a side closes instead."""

    def goal() -> GripGoal:
        width = board.open_width(context)
        return GripGoal(grip=Grip.OPEN, width=width) if width > 0.0 else GripGoal(grip=Grip.CLOSE)

    return _grip("ready hand", context, board, goal)


def close_on_item(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf."""
    width = board.site_item(context).size[1]
    return _grip("close", context, board, lambda: GripGoal(grip=Grip.GRASP, width=width))


def hand_is_full(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: FAILURE when what was attached is not between the pads."""
    width = board.site_item(context).size[1]

    def judge(result: GripResult) -> Failure | None:
        if result.full:
            return None
        return Failure(
            kind=FailureKind.GRASP_LOST,
            message=f"item {board.item} was attached, and the {board.side} hand is empty",
            evidence={"width_m": result.width, "force_n": result.force},
        )

    return _grip("hand is full?", context, board, lambda: GripGoal(grip=Grip.CHECK, width=width), judge)


def let_go(what: str, context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: all the way open."""
    return _grip(what, context, board, lambda: GripGoal(grip=Grip.OPEN))


def _grip(
    what: str,
    context: TreeContext,
    board: HandBoard,
    goal: Callable[[], GripGoal],
    judge: Callable[[GripResult], Failure | None] = accept,
) -> Gripping:
    return Act(
        f"{board.who}: {what}",
        context,
        grip(board.side),
        goal,
        resources=(f"gripper_{board.side}",),
        judge=judge,
    )
