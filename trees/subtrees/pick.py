"""Pick the item up: order-picking paper, III-D.1, Fig. 5 and 6, eq. 1 and 2."""

from __future__ import annotations

import math

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from tandem.skills.grasping.item_frames import face, outward
from tandem.skills.grasping.tag_grasps import proximity_poses
from tandem.skills.ports.actions.gripper import Grip, GripGoal, GripResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName, Vector3
from tandem.skills.ports.shapes import solid
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.board import FetchBoard
from tandem.trees.branch import branch
from tandem.trees.context import TreeContext
from tandem.trees.fetch_notes import closes
from tandem.trees.item_failures import fallen_over
from tandem.trees.leaves.edit_scene import add_to_scene, attach
from tandem.trees.leaves.grip import grip_with
from tandem.trees.leaves.look_closely import look_closely
from tandem.trees.leaves.pre_grasp import grasp_candidates, grasp_turn, pre_grasp
from tandem.trees.leaves.reach import reach
from tandem.trees.leaves.retract import retract
from tandem.trees.leaves.survey import Reach
from tandem.trees.subtrees.arms_in import tuck
from tandem.trees.subtrees.stand import stand_near, unknown


def pick(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when the hand is full and tucked in."""
    width, open_width = board.site_item(context).size[1], board.open_width(context)

    def close() -> GripGoal:
        closes(context, board)
        return GripGoal(grip=Grip.GRASP, width=width)

    return Sequence(
        "pick item",
        memory=True,
        children=[
            approach_item(context, board),
            _ready_hand(context, board, open_width),
            add_to_scene(context, board),
            reach(context, board),
            grip_with("close", context, board, close),
            attach(context, board),
            retract(context, board),
            _verify(context, board, width),
            tuck(context, "after pick"),
        ],
    )


def _ready_hand(context: TreeContext, board: FetchBoard, width: float) -> Behaviour:
    """Open the hand while the arm brings it before the item: the way is planned for the open hand."""
    arm, hand = branch(context, "arm"), branch(context, "gripper")
    return SideBySide(
        "ready the hand",
        context,
        (
            (arm, pre_grasp(arm, board)),
            (hand, grip_with("open", hand, board, lambda: GripGoal(grip=Grip.OPEN, width=width))),
        ),
    )


def approach_item(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree that brings the base to the item's neighbourhood (order-picking paper, III-A.3)."""

    def reach(side: HandName, quarter_turns: int) -> Reach | Failure:
        fact, description = board.fact(context), context.knowledge.description
        if fact is None or fact.held is not None or description is None:
            return unknown(context, board.item)
        lies = fallen_over(context, fact)
        if lies is not None:
            return lies
        tag, hand = face(fact.tag_in_map, fact.size[0], quarter_turns), description.end_effector(side)
        out = outward(tag)
        facing = math.atan2(out[1], out[0])
        return Reach(
            bases=proximity_poses(tag.position, facing, hand.work_point, hand.work_heading),
            candidates=grasp_candidates(board, tag, solid(fact), hand.gripper.palm),
            facing=facing,
            hand_width=board.open_width(context),
            turn=grasp_turn(context, side, tag, solid(fact)),
        )

    def sight() -> Vector3 | Failure:
        fact = board.fact(context)
        return unknown(context, board.item) if fact is None else fact.tag_in_map.position

    return stand_near(
        "item",
        context,
        board,
        reach,
        faces=(0, 1, -1),
        look=lambda name: look_closely(name, context, board),
        sight=sight,
    )


def _verify(context: TreeContext, board: FetchBoard, width: float) -> Behaviour:
    def judge(result: GripResult) -> Failure | None:
        if result.full:
            return None
        return Failure(
            kind=FailureKind.GRASP_LOST,
            message=f"{context.called(board.item)} was attached, and the hand is empty",
            evidence={"width_m": result.width, "force_n": result.force},
        )

    return grip_with("hand is full?", context, board, lambda: GripGoal(grip=Grip.CHECK, width=width), judge)
