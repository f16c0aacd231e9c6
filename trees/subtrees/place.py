"""Put the item down in its slot of the depot: document 000, III-D.2, Fig. 7, eq. 3."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from skills.ports.actions.gripper import Grip, GripGoal
from skills.ports.failure import Failure
from skills.ports.grasping import proximity_poses
from skills.ports.world import Side
from trees.board import FetchBoard
from trees.context import TreeContext
from trees.leaves.edit_scene import detach, remove_from_scene
from trees.leaves.grip import grip_with
from trees.leaves.look_at_slot import look_at_slot
from trees.leaves.place_above import place_above, place_candidates, ways_to_place
from trees.leaves.put_down import put_down
from trees.leaves.survey import Reach
from trees.leaves.withdraw import withdraw
from trees.subtrees.home import tuck
from trees.subtrees.stand import stand_near, unknown


def place(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when the item lies in its slot and the hand is closed and tucked in."""
    return Sequence(
        "place item",
        memory=True,
        children=[
            approach_slot(context, board),
            place_above(context, board),
            put_down(context, board),
            grip_with("let go", context, board, lambda: GripGoal(grip=Grip.OPEN)),
            detach(context, board),
            withdraw(context, board),
            grip_with("close empty", context, board, lambda: GripGoal(grip=Grip.CLOSE)),
            remove_from_scene(context, board),
            tuck(context, "after place"),
        ],
    )


def approach_slot(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree that brings the base into the slot's neighbourhood."""

    def reach(side: Side, _: int) -> Reach | Failure:
        ways, description = ways_to_place(context, board, side), context.knowledge.description
        if isinstance(ways, Failure) or description is None:
            return ways if isinstance(ways, Failure) else unknown(board.item)
        slot, hand = board.chosen_slot(context), description.end_effector(side)
        bases = proximity_poses(slot.position, slot.facing, hand.work_point, hand.work_heading)
        return Reach(bases=bases, candidates=place_candidates(ways))

    return stand_near(
        "slot",
        context,
        board,
        reach,
        touch_support=True,
        look=lambda name: look_at_slot(name, context, board),
    )
