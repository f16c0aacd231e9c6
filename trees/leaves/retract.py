"""Draw the item away from where it stood: order-picking paper, III-D.1 e and eq. 2."""

from __future__ import annotations

from tandem.skills.grasping.turns import to_go_on
from tandem.skills.ports.actions.arm import Candidate, MoveFeedback, MoveGoal, MoveResult
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.move_hand import move_hand


def retract(context: TreeContext, board: FetchBoard) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: while it is lifted, the item may touch what it stood on."""

    def goal() -> MoveGoal:
        pose = board.chosen_grasp().retraction
        return MoveGoal(
            candidates=(Candidate(pose=pose),),
            straight=True,
            touch_item=board.item,
            touch_support=True,
            turn=to_go_on(pose),
        )

    return move_hand("retract", context, board, goal)
