"""The hardware interface: what a robot tells and takes, and no more. The sim implements it; so may a robot.

What a robot says it is (joints, hands, sensors) stands in ``robot_description``.
"""

from __future__ import annotations

from enum import StrEnum
from itertools import pairwise
from typing import Annotated, Final

from pydantic import Field, model_validator

from tandem.skills.ports.lease import Leased
from tandem.skills.ports.message import Count, HandName, Message, PlainText, Positive, RobotTime, Vector3
from tandem.skills.ports.pose import FloorPose

MAX_PIXELS: Final = 1 << 14
"""Pixels along one side of a picture."""


class Clock(Message):
    """The hardware's clock, once a period; of a robot that rests, once a resting period at least.

    ``tick`` counts the periods. With ``waits`` the hardware continues only after all registered
    followers have finished this tick (simulated time faster than real time).
    """

    stamp: RobotTime
    tick: Count
    waits: bool = False


class JointStates(Message):
    """All joints of groups and grippers, each once; no others."""

    stamp: RobotTime
    names: tuple[str, ...]
    positions: tuple[float, ...]
    velocities: tuple[float, ...]
    efforts: tuple[float, ...]

    @model_validator(mode="after")
    def _one_of_each(self) -> JointStates:
        lengths = {len(self.names), len(self.positions), len(self.velocities), len(self.efforts)}
        if len(lengths) > 1 or len(set(self.names)) != len(self.names):
            raise ValueError("expected a name, a position, a velocity and an effort of each joint")
        return self

    def position_of(self, joints: tuple[str, ...]) -> tuple[float, ...]:
        """Return the positions of the joints asked for, in their order."""
        index = {name: i for i, name in enumerate(self.names)}
        return tuple(self.positions[index[joint]] for joint in joints)


class TrajectoryPoint(Message):
    """Where the joints are ``time`` seconds after the start."""

    time: float
    positions: tuple[float, ...]
    velocities: tuple[float, ...]


class TrajectoryGoal(Leased):
    """A motion of a group, as cubic splines between points; the first point is where the group stands.

    The group aborts when a joint strays from the path by more than ``path_tolerance`` or is not within
    ``goal_tolerance`` of the end ``goal_time`` seconds after the last point (rad or m).

    ``keeper`` is the announced name of the process that supervises the motion. While this process stalls, the
    group halts on its path; it continues with the process. If the name disappears, the goal ABORTS. Empty: no
    supervision.
    """

    id: str
    keeper: str = ""
    points: Annotated[tuple[TrajectoryPoint, ...], Field(min_length=1)]
    path_tolerance: Positive = 0.15
    goal_tolerance: Positive = 0.02
    goal_time: Positive = 1.0

    @model_validator(mode="after")
    def _times_rise(self) -> TrajectoryGoal:
        times = [point.time for point in self.points]
        if any(b <= a for a, b in pairwise(times)):
            raise ValueError("expected rising times of the points")
        return self


class MotionState(StrEnum):
    """State of a trajectory goal."""

    ACTIVE = "ACTIVE"
    SUCCEEDED = "SUCCEEDED"
    ABORTED = "ABORTED"
    CANCELED = "CANCELED"


class GroupStatus(Message):
    """A group's last goal; published on each change and with each clock second."""

    stamp: RobotTime
    group: str
    goal_id: str
    state: MotionState
    joint: str = ""
    """The joint with the largest deviation, if ABORTED."""
    error: float = 0.0
    """Its deviation (rad or m)."""
    at_rest: bool = True
    held: float = 0.0
    """Seconds by which the motion is behind its plan, since its keeper was silent for a while."""


class Answer(Message):
    """The hardware's immediate answer to a goal or a command."""

    accepted: bool
    reason: str = ""


class CancelMotion(Leased):
    """Stop the group's goal ``id`` within its limits; the group then holds. An empty id means any goal.

    Stopping is always allowed: the lease is not checked.
    """

    id: str = ""


class SetPoint(Leased):
    """One streamed set-point of a group; without a new one for 0.1 s the group holds."""

    stamp: RobotTime
    positions: tuple[float, ...]
    velocities: tuple[float, ...]

    @model_validator(mode="after")
    def _as_many(self) -> SetPoint:
        if len(self.positions) != len(self.velocities):
            raise ValueError("expected as many velocities as positions")
        return self


class GripperCommand(Leased):
    """Move the pads to ``width`` metres, with at most ``force`` newtons and ``speed`` metres a second."""

    id: str
    width: Annotated[float, Field(ge=0.0)]
    speed: Positive
    force: Positive


class GripperMotion(StrEnum):
    """What the fingers do."""

    MOVING = "MOVING"
    AT_WIDTH = "AT_WIDTH"
    STALLED = "STALLED"
    """At rest before the commanded width: something is between the pads."""
    IDLE = "IDLE"


class GripperState(Message):
    """State of the gripper, from its controller."""

    stamp: RobotTime
    side: HandName
    command_id: str
    motion: GripperMotion
    width: float
    """Metres between the pads."""
    force: float
    """Newtons between the pads, from the motor's effort."""


class BaseVelocity(Leased):
    """m/s forward and rad/s to the left; a command older than the drive's dead-man time means stop."""

    linear: float
    angular: float


class Odometry(Message):
    """The base's pose from its wheels; drifts."""

    stamp: RobotTime
    base_in_odom: FloorPose
    linear: float
    angular: float


class Wrench(Message):
    """Force (N) and torque (Nm) at the wrist's sensor, in its frame."""

    stamp: RobotTime
    side: HandName
    force: Vector3
    torque: Vector3


class Stop(Message):
    """Bring everything to rest, and keep it there until an operator releases it."""

    by: PlainText
    reason: PlainText


class StopRelease(Message):
    """Release the stop, with the name of the person, as for setting it."""

    by: Annotated[PlainText, Field(min_length=1, max_length=80)]
    reason: Annotated[PlainText, Field(max_length=200)] = ""


class StopState(Message):
    """Whether the stop is set, by whom, and why."""

    stopped: bool
    by: PlainText = ""
    reason: PlainText = ""


class RgbdHeader(Message):
    """The header before the pixels of an RGB-D picture.

    Pinhole intrinsics in pixels, without distortion; colour is rgb8, depth is uint16 in millimetres along
    the optical axis (0: nothing measured), aligned with the colour.
    """

    stamp: RobotTime
    camera: str
    width: Annotated[int, Field(ge=1, le=MAX_PIXELS)]
    height: Annotated[int, Field(ge=1, le=MAX_PIXELS)]
    fx: Annotated[float, Field(gt=0.0)]
    fy: Annotated[float, Field(gt=0.0)]
    cx: float
    cy: float
