"""Move an arm (or any other joint group, such as the torso or the head)."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import MOST, Count, Message, RobotTime, Vector3
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import ActionType

MOST_CORNERS: Final = 20
"""Corners of a hand's way in a move's feedback: half a kilobyte, at 10 Hz while the arm moves."""


class ArmState(StrEnum):
    """What the group does, in the order-picking paper's words (III-C)."""

    ARM_IDLE = "ARM_IDLE"
    ARM_RUNNING = "ARM_RUNNING"
    ARM_SUCCESS = "ARM_SUCCESS"
    ARM_FAIL = "ARM_FAIL"


class ArmStatus(Message):
    """At 10 Hz and on each change. The base moves only while all arms are ARM_IDLE and tucked in."""

    stamp: RobotTime
    group: str
    state: ArmState
    extent: float
    """Horizontal metres from the base's axis to the farthest point of the group, including what it holds."""


class Candidate(Message):
    """One way to do it: a pose of the tool frame, and where the hand must get straight from there."""

    pose: Pose
    followed_by: tuple[Pose, ...] = ()
    """Poses to reach one after the other in straight lines (pre-grasp: grasp, retraction)."""


class TurnAbout(Message):
    """How far poses may be turned, all alike, about the vertical through a point.

    An arm of fewer than six joints can't choose its hand's heading: it follows from where the hand is. Such
    an arm takes the turn that it needs, one of six joints or more none.
    """

    point: Vector3
    """In the goal's frame (m): what the hand is for. z does not matter."""
    most: Annotated[float, Field(ge=0.0, le=math.pi)]
    """Radians, to both sides."""


class MoveGoal(Message):
    """Move a group; exactly one of ``joints``, ``posture``, ``candidates``, ``by``, ``up``.

    Takes the first of the candidates that has a collision-free position and path. With
    ``straight`` the tool moves in a straight line. In straight lines the hand may touch
    ``touch_item``, and, with ``touch_support``, what it holds may touch what it stands on.

    ``by`` retreats from whatever the hand is at. It lists straight motions of the tool, in
    metres in its own frame ((-0.1, 0, 0) draws the hand back), tried in order; then 10 cm straight up in the
    map; then the longest part of any of them, at least 2 cm. The hand may touch every item meanwhile,
    what it holds may touch its support, and initial contacts, however deep, may remain as long as
    they get no deeper. The result's ``candidate`` is the number of the motion (``len(by)``: up); its error
    refers to the end of the motion or its part. ``up`` retreats straight up in the map by so many metres,
    away from anything unseen next to the hand. Neither needs ``frame``, ``straight``, or a localised
    robot.
    """

    joints: tuple[float, ...] | None = None
    posture: str | None = None
    candidates: tuple[Candidate, ...] = ()
    by: tuple[Vector3, ...] = ()
    up: Annotated[float, Field(gt=0.0, le=0.5)] | None = None
    frame: Literal["map", "base"] = "map"
    straight: bool = False
    touch_item: Count | None = None
    touch_support: bool = False
    hand_width: Annotated[float, Field(ge=0.0)] | None = None
    """Metres between the pads of an empty hand that are planned with; as they are unless given."""
    speed: Annotated[float, Field(gt=0.0, le=1.0)] = 1.0
    """Fraction of the joints' speed limits."""
    follows_item: Annotated[int, Field(ge=0, le=MOST)] | None = None
    """The item that the goal was made for: when it turns out to be elsewhere, the move stops and fails."""
    follow_tolerance: Annotated[float, Field(gt=0.0)] = 0.03
    """Metres by which that item may be found to have moved since the plan was made."""
    turn: TurnAbout | None = None
    """Of the candidates, with all that follows them."""

    @model_validator(mode="after")
    def _one_target(self) -> MoveGoal:
        targets = (self.joints is not None, self.posture is not None, bool(self.candidates), self.retreats)
        if sum(targets) != 1 or (self.by and self.up is not None):
            raise ValueError("expected exactly one of joints, posture, candidates, by and up")
        return self

    @property
    def retreats(self) -> bool:
        """Whether it leads away from whatever the hand is at."""
        return bool(self.by) or self.up is not None


class MovePhase(StrEnum):
    """The phase of a move."""

    PLANNING = "PLANNING"
    MOVING = "MOVING"
    STOPPING = "STOPPING"


class MoveFeedback(Message):
    """Progress of the move."""

    phase: MovePhase
    progress: Annotated[float, Field(ge=0.0, le=1.0)]
    way: Annotated[tuple[Vector3, ...], Field(max_length=MOST_CORNERS)] = ()
    """Where the hand's tool frame is along the planned motion (m, in the base's frame), from its begin to its
    end. Empty while it plans, and for a group without a hand."""


class MoveResult(Message):
    """Where it ended."""

    candidate: Count = 0
    """Index of the candidate taken."""
    positions: tuple[float, ...]
    error: float
    """Metres (candidates) or largest radians (joints, posture) between what was asked and reached."""
    planning_steps: Count
    """Slices that planning took."""
    duration: float
    """Robot seconds of the motion."""
    turned: float = 0.0
    """Radians by which the candidate was turned (``MoveGoal.turn``)."""


class SurveyGoal(Message):
    """Find the ``bases`` from which the hand can reach one of ``candidates`` (in the map). Moves nothing.

    Ends when ``enough`` have been found. Contacts, the hand's width and the turn are as in ``MoveGoal``.
    """

    bases: Annotated[tuple[FloorPose, ...], Field(min_length=1, max_length=100)]
    candidates: Annotated[tuple[Candidate, ...], Field(min_length=1)]
    touch_item: Count | None = None
    touch_support: bool = False
    hand_width: Annotated[float, Field(ge=0.0)] | None = None
    enough: Annotated[int, Field(ge=1, le=MOST)] = 4
    turn: TurnAbout | None = None


class SurveyFeedback(Message):
    """Bases looked at, and found good."""

    looked_at: Count
    found: Count


class SurveyResult(Message):
    """Indices of the suitable bases, in the order of the goal; may be empty."""

    bases: tuple[Count, ...]


def survey(group: str) -> ActionType[SurveyGoal, SurveyFeedback, SurveyResult]:
    """Return the action of a group with a hand: ``arm_left/survey``."""
    return ActionType(f"{group}/survey", SurveyGoal, SurveyFeedback, SurveyResult, timeout=30.0)


def move(group: str) -> ActionType[MoveGoal, MoveFeedback, MoveResult]:
    """Return the action of a group: ``arm_left/move``, ``torso/move``, ..."""
    return ActionType(f"{group}/move", MoveGoal, MoveFeedback, MoveResult, timeout=60.0)


def arm_status(group: str) -> Topic[ArmStatus]:
    """Return the topic on which the group's state is told."""
    return Topic(f"skill/{group}/state", ArmStatus)
