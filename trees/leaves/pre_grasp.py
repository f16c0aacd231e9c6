"""Bring the hand before the item: order-picking paper, III-D.1 a and eq. 1."""

from __future__ import annotations

from tandem.skills.grasping.item_frames import item_in_map
from tandem.skills.grasping.tag_grasps import PITCHES, Grasp, grasps_on
from tandem.skills.grasping.turns import to_grasp
from tandem.skills.ports.actions.arm import Candidate, MoveFeedback, MoveGoal, MoveResult, TurnAbout
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import Solid, extents, solid
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import fallen_over
from tandem.trees.leaves.move_hand import move_hand


def grasp_candidates(
    board: FetchBoard, tag_in_map: Pose, shape: Solid, palm: float | None
) -> tuple[Candidate, ...]:
    """Return the ways to grasp an item: from each direction, one for each pitch that has not failed.

    Args:
        board: what has failed.
        tag_in_map: the tag on the face that the hand goes for.
        shape: of the item, its x along the tag's z.
        palm: of the gripper (``Gripper.palm``).
    """
    return tuple(_candidate(each) for each in _grasps(board, tag_in_map, shape, palm))


def grasp_turn(context: TreeContext, side: HandName, tag_in_map: Pose, shape: Solid) -> TurnAbout | None:
    """Return by how much all of them may be turned; None while the robot is not known."""
    robot = context.knowledge.description
    if robot is None:
        return None
    widest = robot.end_effector(side).gripper.max_width
    return to_grasp(item_in_map(tag_in_map, extents(shape)[0]).position, shape, widest)


def _grasps(board: FetchBoard, tag_in_map: Pose, shape: Solid, palm: float | None) -> tuple[Grasp, ...]:
    untried = [pitch for pitch in PITCHES if pitch not in board.pitches_tried]
    return grasps_on(tag_in_map, shape, untried or PITCHES, palm)


def _candidate(way: Grasp) -> Candidate:
    return Candidate(pose=way.pre_grasp, followed_by=(way.grasp, way.retraction))


def pre_grasp(context: TreeContext, board: FetchBoard) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: offers a pre-grasp for each pitch of the hand; binds the grasp that was taken."""

    def goal() -> MoveGoal | Failure:
        fact = board.fact(context)
        if fact is None or fact.held is not None:
            return Failure(
                kind=FailureKind.ITEM_GONE, message=f"{context.called(board.item)} is not known to stand"
            )
        lies = fallen_over(context, fact)
        if lies is not None:
            return lies
        palm = board.palm(context)
        tag = board.face_in_map(fact)
        board.grasps = _grasps(board, tag, solid(fact), palm)
        return MoveGoal(
            candidates=tuple(_candidate(each) for each in board.grasps),
            touch_item=board.item,
            hand_width=board.open_width(context),
            turn=grasp_turn(context, board.chosen_side(), tag, solid(fact)),
        )

    def judge(result: MoveResult) -> Failure | None:
        board.grasp = board.grasps[result.candidate].turned(result.turned)
        return None

    return move_hand("pre-grasp", context, board, goal, judge)
