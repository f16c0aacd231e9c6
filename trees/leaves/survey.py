"""Find out from where an arm could reach: the base is sent only where it helps."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.floor_plan import FloorPlan
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.actions.arm import (
    Candidate,
    SurveyFeedback,
    SurveyGoal,
    SurveyResult,
    TurnAbout,
    survey,
)
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.at_pose import POSITION_TOLERANCE
from tandem.trees.context import TreeContext


@dataclass(frozen=True)
class Reach:
    """Base poses to look at, and what the hand shall do from one of them.

    ``facing`` (rad) is the heading out of the item's face that the hand goes for, ``hand_width`` (m) how wide
    it is open then; None where the hand holds the item. ``turn`` is how far all may be turned, for an arm
    of few joints.
    """

    bases: tuple[FloorPose, ...]
    candidates: tuple[Candidate, ...]
    facing: float | None = None
    hand_width: float | None = None
    turn: TurnAbout | None = None


ENOUGH: Final = 4
"""Stands among which the base may choose the one it gets to."""
SAME_STAND: Final = POSITION_TOLERANCE
"""Metres within which two base poses are one stand. Were it less, a stand could count as new, and as reached:
the base would stay where it stood in vain."""
SAME_YAW: Final = 0.1
"""Radians, the same for headings: for the same reason no less than ``at_pose.YAW_TOLERANCE``."""


def survey_stands(
    name: str,
    context: TreeContext,
    board: FetchBoard,
    side: HandName,
    reach: Callable[[], Reach | Failure],
    *,
    touch_support: bool = False,
    unreachable: FailureKind = FailureKind.ITEM_UNREACHABLE,
    here_first: bool = False,
) -> Act[SurveyGoal, SurveyFeedback, SurveyResult]:
    """Return the leaf: SUCCESS binds the arm and the base poses from which it reaches, none tried in vain.

    ``reach`` says which poses are worth a look, and what is to be done. With ``here_first`` the
    place where the robot stands comes before them, and suffices.
    """
    asked: list[FloorPose] = []
    facing: list[float | None] = [None]

    def goal() -> SurveyGoal | Failure:
        found = reach()
        if isinstance(found, Failure):
            return found
        facing[0] = found.facing
        here = _here(context) if here_first or not _drives(context) else ()
        elsewhere = _where_there_is_room(context, found.bases) if _drives(context) else ()
        # Here stands for what the base would not be driven to from here: that may do where this does not.
        asked[:] = _untried(board, [*here, *(each for each in elsewhere if not _any_same(each, here))])
        if not asked:
            return Failure(kind=unreachable, message="nowhere near is untried room for the base")
        return SurveyGoal(
            bases=tuple(asked),
            candidates=found.candidates,
            hand_width=found.hand_width,
            touch_item=board.item,
            touch_support=touch_support,
            enough=1 if here else ENOUGH,
            turn=found.turn,
        )

    def judge(result: SurveyResult) -> Failure | None:
        if not result.bases:
            return Failure(
                kind=unreachable,
                message=f"the {side} arm reaches from none of {len(asked)} base poses",
                evidence={"side": side, "bases": len(asked)},
            )
        board.side, board.facing = side, facing[0]
        board.stands = tuple(asked[index] for index in result.bases)
        return None

    return Act(name, context, survey(f"arm_{side}"), goal, judge=judge)


def _drives(context: TreeContext) -> bool:
    robot = context.knowledge.description
    return robot is None or robot.drive is not None


def _untried(board: FetchBoard, bases: list[FloorPose]) -> list[FloorPose]:
    return [base for base in bases if not _any_same(base, board.avoid)]


def _any_same(one: FloorPose, others: Iterable[FloorPose]) -> bool:
    return any(_same(one, each) for each in others)


def _same(one: FloorPose, other: FloorPose) -> bool:
    return floor_distance(one, other) < SAME_STAND and abs(wrap(one.yaw - other.yaw)) < SAME_YAW


def _here(context: TreeContext) -> tuple[FloorPose, ...]:
    robot = context.knowledge.robot
    return () if robot is None else (robot.base_in_map,)


def _where_there_is_room(context: TreeContext, bases: tuple[FloorPose, ...]) -> list[FloorPose]:
    description = context.knowledge.description
    radius = 0.0 if description is None else description.footprint_radius
    plan = FloorPlan(context.site)
    return [pose for pose in bases if plan.has_room(pose.x, pose.y, radius + ARM_MARGIN)]
