"""Lift the item off what it stands on, towards the robot: order-picking paper, eq. 2."""

from __future__ import annotations

from typing import Final

from tandem.skills.grasping.hand_grasps import lifted
from tandem.skills.grasping.turns import to_go_on
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.move_hand import Move, move_hand

AWAYS: Final = (0.10, 0.05, 0.0)
"""Metres by which it is drawn back while it rises by 10 cm, in the order in which they are tried."""


def lift_item(context: TreeContext, board: HandBoard) -> Move:
    """Return the leaf: while it rises, the item may touch what it stood on."""

    def goal() -> MoveGoal | Failure:
        if board.item_at is None:
            return Failure(kind=FailureKind.INVALID_GOAL, message="nothing was grasped that could be lifted")
        tool = board.tool_at(board.item_at)
        return MoveGoal(
            candidates=tuple(Candidate(pose=lifted(tool, away)) for away in AWAYS),
            straight=True,
            turn=to_go_on(tool),
            touch_item=board.item,
            touch_support=True,
        )

    return move_hand("lift", context, board, goal)
