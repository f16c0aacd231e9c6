"""Draw the empty hand back from the item put down: order-picking paper, III-D.2 c and eq. 3."""

from __future__ import annotations

from tandem.skills.grasping.turns import to_go_on
from tandem.skills.ports.actions.arm import Candidate, MoveFeedback, MoveGoal, MoveResult
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.move_hand import move_hand


def withdraw(context: TreeContext, board: FetchBoard) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: 10 cm back, and until then the hand may touch the item."""

    def goal() -> MoveGoal:
        pose = board.chosen_place().retraction
        return MoveGoal(
            candidates=(Candidate(pose=pose),), straight=True, touch_item=board.item, turn=to_go_on(pose)
        )

    return move_hand("withdraw", context, board, goal)
