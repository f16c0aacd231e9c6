"""Drive, rotate and localise."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import Count, Message, RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType

ARM_MARGIN: Final = 0.04
"""Metres by which an arm, with what it holds, may reach beyond the footprint while the base moves."""


class BaseState(StrEnum):
    """What the base does, in the order-picking paper's words (III-B)."""

    BASE_IDLE = "BASE_IDLE"
    BASE_TO_GOAL = "BASE_TO_GOAL"
    BASE_GOAL_OK = "BASE_GOAL_OK"
    BASE_GOAL_FAIL = "BASE_GOAL_FAIL"


class BaseStatus(Message):
    """Published at 10 Hz and on each change."""

    stamp: RobotTime
    state: BaseState
    serves_item: Count | None = None


class DriveGoal(Message):
    """Drive to the first of ``poses`` (in the map) with a free path; planned and checked before driving.

    ``serves_item`` says for which item, if any (order-picking paper, III-B).
    """

    poses: Annotated[tuple[FloorPose, ...], Field(min_length=1)]
    position_tolerance: Annotated[float, Field(gt=0.0)] = 0.03
    yaw_tolerance: Annotated[float, Field(gt=0.0)] = 0.04
    serves_item: Count | None = None


class DriveFeedback(Message):
    """Where the base is and how far it still has to go."""

    base_in_map: FloorPose
    remaining: float
    """Metres left to drive."""
    progress: Annotated[float, Field(ge=0.0, le=1.0)]
    way: tuple[tuple[float, float], ...] = ()
    """Corners of the planned way in the map (m), from where it was planned to its end; empty: no plan yet."""


class DriveResult(Message):
    """Where it stopped. ``pose``: index of the goal pose taken."""

    pose: Count
    base_in_map: FloorPose
    position_error: float
    yaw_error: float
    replans: Count = 0


class RotateGoal(Message):
    """Turn on the spot by ``angle`` radians, counter-clockwise positive."""

    angle: float
    tolerance: Annotated[float, Field(gt=0.0)] = 0.05


class RotateFeedback(Message):
    """Radians left."""

    remaining: float


class RotateResult(Message):
    """Radians turned, from the localised pose."""

    turned: float


class LocaliseGoal(Message):
    """Localise the robot with the laser; near ``hint`` if given, else anywhere."""

    hint: FloorPose | None = None


class LocaliseFeedback(Message):
    """Progress of the search."""

    progress: Annotated[float, Field(ge=0.0, le=1.0)]


class LocaliseResult(Message):
    """The pose, and how well the scan fits the map there: fraction of beams within 10 cm."""

    base_in_map: FloorPose
    fit: float
    runner_up: float
    """The fit of the best pose elsewhere; close to ``fit`` means ambiguous."""


class GoGoal(Message):
    """Go straight to a place in the map; whatever stands in the way is left to the reflexes.

    For robots that know no obstacles beforehand (RoCS paper, 6.2). ``yaw`` (rad in the map) is turned to at
    the end; None: any heading will do.
    """

    x: float
    y: float
    yaw: float | None = None
    position_tolerance: Annotated[float, Field(gt=0.0)] = 0.10
    yaw_tolerance: Annotated[float, Field(gt=0.0)] = 0.10


class GoFeedback(Message):
    """Where the base is, how far it has to go, and what it does, the outermost action first."""

    base_in_map: FloorPose
    remaining: float
    """Metres."""
    doing: tuple[str, ...]


class GoResult(Message):
    """Where it stopped."""

    base_in_map: FloorPose
    position_error: float


class FollowSource(StrEnum):
    """How a robot that follows another one knows where that is."""

    SENSOR = "sensor"
    """It sees it."""
    BELIEF = "belief"
    """The other tells it, under ``world/robots``."""


class FollowGoal(Message):
    """Follow another robot at a distance between the two centres (m), for so many robot seconds."""

    robot: Annotated[str, Field(min_length=1, max_length=64)]
    distance: Annotated[float, Field(gt=0.0)] = 1.3
    seconds: Annotated[float, Field(gt=0.0)] = 60.0
    source: FollowSource = FollowSource.SENSOR


class FollowFeedback(Message):
    """Where the base is, how far the other robot, and what the base does, the outermost action first."""

    base_in_map: FloorPose
    distance: float | None
    """Metres between the centres; None while the other is not seen."""
    doing: tuple[str, ...]


class FollowResult(Message):
    """For how long the other robot was seen, of the seconds that it was followed."""

    seconds: float
    seen: float


GO: Final = ActionType("base/go", GoGoal, GoFeedback, GoResult, timeout=120.0)
FOLLOW: Final = ActionType("base/follow", FollowGoal, FollowFeedback, FollowResult, timeout=600.0)
DRIVE: Final = ActionType("base/drive", DriveGoal, DriveFeedback, DriveResult, timeout=120.0)
ROTATE: Final = ActionType("base/rotate", RotateGoal, RotateFeedback, RotateResult, timeout=30.0)
LOCALISE: Final = ActionType("base/localise", LocaliseGoal, LocaliseFeedback, LocaliseResult, timeout=30.0)
BASE_STATUS: Final = Topic("skill/base/state", BaseStatus)
