"""Move the hand straight to the item: order-picking paper, III-D.1 c."""

from __future__ import annotations

from tandem.skills.grasping.turns import to_go_on
from tandem.skills.ports.actions.arm import Candidate, MoveFeedback, MoveGoal, MoveResult
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.move_hand import move_hand


def reach(context: TreeContext, board: FetchBoard) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: the hand may touch the item, and nothing else."""

    def goal() -> MoveGoal:
        pose = board.chosen_grasp().grasp
        return MoveGoal(
            candidates=(Candidate(pose=pose),), straight=True, touch_item=board.item, turn=to_go_on(pose)
        )

    return move_hand("grasp", context, board, goal)
