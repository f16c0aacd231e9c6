"""What a robot says it is: joints, hands, sensors, drive and postures. Skills learn the robot from this."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Literal, TypeVar

from pydantic import Field, model_validator

from tandem.skills.ports.message import HandName, Message, Positive, Vector3, repeated
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.sensors import (
    Bumper,
    CameraSensor,
    CliffSensor,
    LaserSensor,
    PoseSensor,
    RangeSensor,
    RobotSensor,
)

S = TypeVar("S")


class JointLimit(Message):
    """Limits of one joint: rad (or m), rad/s, rad/s2, rad/s3, Nm (or N)."""

    joint: str
    lower: float
    upper: float
    velocity: Positive
    acceleration: Positive
    jerk: Positive
    effort: Positive

    @model_validator(mode="after")
    def _ordered(self) -> JointLimit:
        if self.lower > self.upper:
            raise ValueError(
                f"joint {self.joint!r}: expected a lower limit of at most the upper one, "
                f"found {self.lower:g} and {self.upper:g}"
            )
        return self


class JointGroup(Message):
    """Joints that are moved together, in the order of every message about them."""

    name: str
    limits: tuple[JointLimit, ...]
    path_tolerance: Positive = 0.03
    """How far a joint of an arm may stray from its path (rad or m) before the motion aborts: some times what
    its controller strays when all is well. At 0.7 m from the hand, 0.03 rad are 21 mm; with more, a hand runs
    further into what it passes closely while a joint stalls."""

    @model_validator(mode="after")
    def _each_once(self) -> JointGroup:
        if twice := repeated(self.joints):
            raise ValueError(f"group {self.name!r}: expected each joint once, twice there: {twice}")
        return self

    @property
    def joints(self) -> tuple[str, ...]:
        """The joints' names, in order."""
        return tuple(limit.joint for limit in self.limits)


class Gripper(Message):
    """A parallel gripper: ``joints`` are its fingers, each opening with positive values (m)."""

    joints: tuple[str, ...]
    max_width: Positive
    """Metres between the pads when open."""
    speed: Positive
    """Speed of the width, in metres a second."""
    force: Positive
    """Maximum force between the pads, in newtons."""
    min_width: Annotated[float, Field(ge=0.0)] = 0.0
    """Metres between the pads when they are closed all the way."""
    palm: Positive | None = None
    """Metres from the palm to the tool frame's origin: nothing deeper fits between the fingers. None: no
    item is so deep."""

    @model_validator(mode="after")
    def _opens(self) -> Gripper:
        if self.min_width >= self.max_width:
            raise ValueError(
                f"expected a min_width below max_width, found {self.min_width:g} and {self.max_width:g} m"
            )
        return self


class EndEffector(Message):
    """The hand at the end of a group.

    Its tool ``frame`` lies between the finger pads: x out of the hand, y along the closing.
    ``touch_links`` may touch what is grasped.
    """

    side: HandName
    """The hand's name; its group is called ``arm_`` and this name."""
    group: str
    frame: str
    touch_links: tuple[str, ...]
    gripper: Gripper
    work_point: tuple[float, float] = (0.65, 0.0)
    """x and y in the base (m) around which the hand works best at table height."""
    work_heading: float = 0.0
    """Heading in the base (rad) in which the hand works best there."""
    safe_point: Vector3 | None = None
    """In the base (m): where the hand holds what it picked, clear of the other (two-arm thesis, 4.1.1)."""


class _DriveLimits(Message):
    """Limits of a drive that goes ahead and turns: m/s, m/s2, rad/s, rad/s2."""

    forward: Positive
    backward: Positive
    acceleration: Positive
    turn: Positive
    turn_acceleration: Positive
    dead_man: Positive
    """Seconds after which an old velocity command means stop."""
    braking: Positive | None = None
    """m/s2 at which it brakes when it is told to stand at once; None: as it slows down else."""

    @property
    def hardest(self) -> float:
        """m/s2 at which it stops when it must."""
        return self.braking or self.acceleration


class DifferentialDrive(_DriveLimits):
    """Two driven wheels, side by side."""

    kind: Literal["differential"] = "differential"


class SkidSteerDrive(_DriveLimits):
    """Driven wheels on both sides, some behind the others: they slip in a turn."""

    kind: Literal["skid_steer"] = "skid_steer"


Drive = DifferentialDrive | SkidSteerDrive
"""How a base is driven; each takes ``hw/base/velocity``."""


class Posture(Message):
    """A named position of one group."""

    name: str
    group: str
    positions: tuple[float, ...]


class ArmsCrossing(Message):
    """From when on two arms are said to come into each other's way, and how they give way (two-arm thesis).

    ``k``, ``gamma`` and ``mu`` are its Algorithm 2's: metres, and metres a radian. How they were found:
    docs/decisions/005-arms-crossing.md.
    """

    k: Positive
    gamma: float
    mu: float
    clearance: Positive
    """Metres between the arms' geometry below which there is a risk whatever Algorithm 2 says."""
    phi: Positive = 0.25
    """Seconds between two samples of an arm's record (Algorithm 3)."""
    safe_posture: str = "home"
    """The posture in which an arm is in its safe zone and in nobody's way."""


def _first(parts: tuple[S, ...], otherwise: str) -> S:
    if not parts:
        raise LookupError(otherwise)
    return parts[0]


class RobotDescription(Message):
    """Everything that a skill knows about a robot."""

    name: str
    urdf: str
    base_frame: str
    """Root of the URDF, on the floor between the wheels: "base" in the names of poses."""
    footprint_radius: Positive
    """Metres: no part of the robot in its driving posture is farther from the base's axis."""
    height: Positive
    groups: tuple[JointGroup, ...]
    end_effectors: tuple[EndEffector, ...]
    cameras: tuple[CameraSensor, ...] = ()
    """The first is the one that perception looks with."""
    lasers: tuple[LaserSensor, ...] = ()
    """The first is the one that the base localises with."""
    range_sensors: tuple[RangeSensor, ...] = ()
    cliff_sensors: tuple[CliffSensor, ...] = ()
    pose_sensors: tuple[PoseSensor, ...] = ()
    robot_sensors: tuple[RobotSensor, ...] = ()
    bumpers: tuple[Bumper, ...] = ()
    drive: Annotated[Drive, Field(discriminator="kind")] | None = None
    """None: the base is fixed."""
    search_tilts: Annotated[tuple[float, ...], Field(min_length=1, max_length=8)] = (-0.45,)
    """Radians of the head, down is negative, at which a search looks straight ahead, a picture each. A camera
    1.2 m up spans with 36 degrees what lies 0.6 to 4 m ahead on a table; a lower one looks less far down."""
    postures: tuple[Posture, ...]
    period: Positive
    """Seconds between two messages of the clock and of the joints' state."""
    resting_period: Positive | None = None
    """The same, at the most, while the robot rests: nothing moves, nor is to. None: no difference is made."""
    reflexes: tuple[ReflexSetting, ...] = ()
    """Reflexes with other parameters than their own, or switched off."""
    arms_crossing: ArmsCrossing | None = None
    """For robots with two arms that can meet; without it, nothing checks for crossing arms."""

    @model_validator(mode="after")
    def _each_sensor_once(self) -> RobotDescription:
        sensing = ("range_sensors", "cliff_sensors", "pose_sensors", "robot_sensors")
        for what in ("groups", "cameras", "lasers", *sensing, "bumpers"):
            if twice := repeated(each.name for each in getattr(self, what)):
                raise ValueError(f"{what}: expected unique names, several are called {', '.join(twice)}")
        # Not `hands`: what is cached here, a copy with other hands would have too.
        if twice := repeated(each.side for each in self.end_effectors):
            raise ValueError(f"end_effectors: expected unique sides, several are called {', '.join(twice)}")
        for posture in self.postures:
            joints = next((group.joints for group in self.groups if group.name == posture.group), None)
            if joints is not None and len(joints) != len(posture.positions):
                raise ValueError(
                    f"posture {posture.name!r} of {posture.group!r}: expected {len(joints)} positions, "
                    f"found {len(posture.positions)}"
                )
        return self

    @property
    def camera(self) -> CameraSensor:
        """The camera that perception looks with; LookupError when there is none."""
        return _first(self.cameras, f"{self.name} has no camera")

    @property
    def laser(self) -> LaserSensor:
        """The laser that the base localises with; LookupError when there is none."""
        return _first(self.lasers, f"{self.name} has no laser")

    @property
    def driven(self) -> Drive:
        """How the base is driven; LookupError when it is fixed."""
        return _first(() if self.drive is None else (self.drive,), f"{self.name} has a fixed base")

    @cached_property
    def hands(self) -> tuple[HandName, ...]:
        """The names of its hands, in order."""
        return tuple(hand.side for hand in self.end_effectors)

    @cached_property
    def joints(self) -> frozenset[str]:
        """The names of all joints that have a group or belong to a gripper."""
        of_groups = [joint for group in self.groups for joint in group.joints]
        return frozenset(of_groups + [joint for hand in self.end_effectors for joint in hand.gripper.joints])

    def group(self, name: str) -> JointGroup:
        """Return the group; KeyError names those that there are."""
        for group in self.groups:
            if group.name == name:
                return group
        raise KeyError(f"no group {name!r}; there are {', '.join(g.name for g in self.groups)}")

    def end_effector(self, side: str) -> EndEffector:
        """Return the hand of a side; KeyError names those that there are."""
        for hand in self.end_effectors:
            if hand.side == side:
                return hand
        raise KeyError(f"no end effector {side!r}; there are {', '.join(self.hands) or 'none'}")

    def posture(self, group: str, name: str) -> Posture:
        """Return a group's named posture; KeyError names those that there are."""
        named = [posture for posture in self.postures if posture.group == group]
        for posture in named:
            if posture.name == name:
                return posture
        raise KeyError(f"no posture {name!r} of {group!r}; there are {', '.join(p.name for p in named)}")
