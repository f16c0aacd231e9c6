"""Open a hand for its item, close it around it, and ask whether it is there."""

from __future__ import annotations

from tandem.skills.ports.actions.gripper import Grip, GripGoal, GripResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.grip import Gripping, grip_with


def open_for_item(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: as wide as the item needs; a hand that presses on a side closes instead."""

    def goal() -> GripGoal:
        width = board.open_width(context)
        return GripGoal(grip=Grip.OPEN, width=width) if width > 0.0 else GripGoal(grip=Grip.CLOSE)

    return grip_with("ready hand", context, board, goal)


def close_on_item(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf."""
    width = board.site_item(context).size[1]
    return grip_with("close", context, board, lambda: GripGoal(grip=Grip.GRASP, width=width))


def hand_is_full(context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: FAILURE when what was attached is not between the pads."""
    width = board.site_item(context).size[1]

    def judge(result: GripResult) -> Failure | None:
        if result.full:
            return None
        return Failure(
            kind=FailureKind.GRASP_LOST,
            message=f"{context.called(board.item)} was attached, and the {board.side} hand is empty",
            evidence={"width_m": result.width, "force_n": result.force},
        )

    return grip_with("hand is full?", context, board, lambda: GripGoal(grip=Grip.CHECK, width=width), judge)


def let_go(what: str, context: TreeContext, board: HandBoard) -> Gripping:
    """Return the leaf: all the way open."""
    return grip_with(what, context, board, lambda: GripGoal(grip=Grip.OPEN))
