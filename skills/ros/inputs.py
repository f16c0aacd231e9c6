"""Each mapped topic to the key of the hardware that it tells."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final, Protocol, cast

from tandem.skills.ports import keys
from tandem.skills.ports.hardware import JointStates, Odometry
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import Bumpers, Cliffs, LaserScan, PoseReading, RangeReading, Ranges
from tandem.skills.ros import types
from tandem.skills.ros.frames import Frames
from tandem.skills.ros.poses import (
    OdometrySource,
    PoseSource,
    StampedSource,
    TfSource,
    stamped,
    velocity_between,
)
from tandem.skills.ros.readings import UnfitError, distance_of, measured, ranges_of
from tandem.skills.ros.stamps import Stamps, periods_in

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ports.robot_description import RobotDescription
    from tandem.skills.ports.sensors import CliffSensor, LaserSensor, RangeSensor
    from tandem.skills.ros.mapping import Input as MappedInput
    from tandem.skills.ros.mapping import RosMap
    from tandem.skills.ros.messages import JointState, RosBool, RosRange, RosScan
    from tandem.skills.ros.node import RosNode, RosSubscription

SILENT: Final = 3.0
"""Periods after which the last reading of a range sensor is told no more ..."""
SILENT_AT_LEAST: Final = 0.3
"""... and seconds, at the least: networks hold messages up."""
JOINTS_KEPT: Final = 0.5
"""Seconds for which a joint's state counts while others' come: several nodes tell of their own joints."""
BUMPERS_EVERY: Final = 0.2
"""Robot seconds between two messages of the bumpers when nothing changes."""


class Input(Protocol):
    """One part of the robot: hears its topics, and tells its key."""

    def step(self, now: RobotTime) -> None:
        """Take in what has come, and publish what is due."""
        ...


@dataclass(frozen=True)
class Hearing:
    """What the inputs are made with."""

    bus: Bus
    node: RosNode
    robot: RobotDescription

    def of(self, mapped: MappedInput) -> RosSubscription:
        """Subscribe to a mapped topic."""
        return self.node.subscription(mapped.topic, mapped.type)


@dataclass(eq=False)
class LaserInput:
    """A laser's scans."""

    bus: Bus
    topic: RosSubscription
    sensor: LaserSensor
    stamps: Stamps = field(default_factory=Stamps)

    def step(self, now: RobotTime) -> None:
        """Publish each scan."""
        for told in self.topic.each(lambda message: self._scan(cast("RosScan", message), now)):
            keys.laser(self.sensor.name).publish(self.bus, told)

    def _scan(self, scan: RosScan, now: RobotTime) -> LaserScan:
        ranges = ranges_of(scan, self.sensor)
        return LaserScan(stamp=stamped(self.stamps, scan.header, now), ranges=ranges)


@dataclass
class _Ranger:
    sensor: RangeSensor | CliffSensor
    distance: float | None = None
    at: RobotTime | None = None


@dataclass(eq=False)
class RangesInput:
    """All range sensors, or all cliff sensors: each has a topic, or its frame on a shared one."""

    bus: Bus
    topics: Sequence[tuple[RosSubscription, str | None]]
    sensors: Sequence[RangeSensor] | Sequence[CliffSensor]
    tell: Callable[[Bus, RobotTime, tuple[RangeReading, ...]], None]

    def __post_init__(self) -> None:
        """Know the sensors by name and by frame."""
        self._rangers = {each.name: _Ranger(each) for each in self.sensors}
        self._of_frame = {each.frame: each.name for each in self.sensors}
        self._stamps = {each.name: Stamps() for each in self.sensors}

    def step(self, now: RobotTime) -> None:
        """Publish the newest reading of each sensor when one has come."""
        came = 0
        for topic, name in self.topics:
            came += self._hear(topic, name, now)
        if not came:
            return
        told = tuple(
            RangeReading(sensor=name, distance=each.distance)
            for name, each in self._rangers.items()
            if each.distance is not None and each.at is not None and self._is_fresh(each, now)
        )
        self.tell(self.bus, now, told)

    def _is_fresh(self, ranger: _Ranger, now: RobotTime) -> bool:
        within = max(SILENT * ranger.sensor.period, SILENT_AT_LEAST)
        return ranger.at is not None and ranger.at.is_fresh(now, within)

    def _hear(self, topic: RosSubscription, name: str | None, now: RobotTime) -> int:
        return len(topic.each(lambda message: self._learn(cast("RosRange", message), name, now)))

    def _learn(self, told: RosRange, name: str | None, now: RobotTime) -> RobotTime:
        frame = told.header.frame_id.lstrip("/")
        of = self._of_frame.get(frame) if name is None else name
        if of is None:
            raise UnfitError(f"expected a sensor's frame: {', '.join(self._of_frame)}; found {frame!r}")
        ranger = self._rangers[of]
        ranger.distance = distance_of(told, ranger.sensor)
        ranger.at = stamped(self._stamps[of], told.header, now)
        return ranger.at


@dataclass(eq=False)
class BumpersInput:
    """All bumpers: each has a topic."""

    bus: Bus
    topics: Sequence[tuple[RosSubscription, str]]
    pressed: dict[str, bool] = field(default_factory=dict)
    told: RobotTime | None = None

    def step(self, now: RobotTime) -> None:
        """Publish which are pressed on each change, and now and then."""
        before = dict(self.pressed)
        for topic, name in self.topics:
            for pressed in topic.each(lambda message: bool(cast("RosBool", message).data)):
                self.pressed[name] = pressed
        due = self.told is None or not self.told.is_fresh(now, BUMPERS_EVERY)
        if self.pressed and (self.pressed != before or due):
            names = tuple(name for _, name in self.topics if self.pressed.get(name))
            keys.BUMPERS.publish(self.bus, Bumpers(stamp=now, pressed=names))
            self.told = now


@dataclass
class _Joint:
    position: float
    velocity: float
    effort: float
    at: RobotTime


@dataclass(eq=False)
class JointsInput:
    """The joints of groups and grippers; each message may tell of some."""

    bus: Bus
    topic: RosSubscription
    names: tuple[str, ...]
    stamps: Stamps = field(default_factory=Stamps)
    known: dict[str, _Joint] = field(default_factory=dict)

    def step(self, now: RobotTime) -> None:
        """Publish all joints when some have come, and none is missing."""
        heard = self.topic.each(lambda message: self._learn(cast("JointState", message), now))
        if not heard:
            return
        newest = heard[-1]
        fresh = [self.known[name] for name in self.names if name in self.known]
        fresh = [each for each in fresh if each.at.is_fresh(newest, JOINTS_KEPT)]
        if len(fresh) == len(self.names):
            states = JointStates(
                stamp=newest,
                names=self.names,
                positions=tuple(each.position for each in fresh),
                velocities=tuple(each.velocity for each in fresh),
                efforts=tuple(each.effort for each in fresh),
            )
            keys.JOINT_STATES.publish(self.bus, states)

    def _learn(self, told: JointState, now: RobotTime) -> RobotTime:
        positions = {
            name: measured(f"a position of {name}", told.position[index])[0]
            for index, name in enumerate(told.name)
            if name in self.names and index < len(told.position)
        }
        at = stamped(self.stamps, told.header, now)
        for index, name in enumerate(told.name):
            if name in positions:
                velocity, effort = _told(told.velocity, index), _told(told.effort, index)
                self.known[name] = _Joint(positions[name], velocity, effort, at)
        return at


def _told(values: NDArray[np.floating], index: int) -> float:
    """Return a joint's velocity or effort; 0 for one that isn't measured: ros2_control tells NaN."""
    value = float(values[index]) if index < len(values) else 0.0
    return 0.0 if math.isnan(value) else measured("velocities and efforts", value)[0]


@dataclass(eq=False)
class NoJoints:
    """Tells of a robot without joints that it has none: once a period, as of any robot."""

    bus: Bus
    period: float
    told: int = 0

    def step(self, now: RobotTime) -> None:
        """Publish once in each of the clock's periods."""
        passed = periods_in(now.seconds, self.period)
        if passed > self.told:
            self.told = passed
            states = JointStates(stamp=now, names=(), positions=(), velocities=(), efforts=())
            keys.JOINT_STATES.publish(self.bus, states)


@dataclass(eq=False)
class OdometryInput:
    """The base's odometry."""

    bus: Bus
    source: PoseSource
    last: Odometry | None = None

    def step(self, now: RobotTime) -> None:
        """Publish each pose with its velocities."""
        for placed in self.source.take(now):
            linear, angular = placed.velocity or _velocity(self.last, placed.stamp, placed.pose)
            told = Odometry(stamp=placed.stamp, base_in_odom=placed.pose, linear=linear, angular=angular)
            keys.ODOMETRY.publish(self.bus, told)
            self.last = told


@dataclass(eq=False)
class PoseInput:
    """What a pose sensor tells."""

    bus: Bus
    source: PoseSource
    sensor: str

    def step(self, now: RobotTime) -> None:
        """Publish each pose."""
        for placed in self.source.take(now):
            told = PoseReading(stamp=placed.stamp, sensor=self.sensor, base_in_map=placed.pose)
            keys.POSE_READING.publish(self.bus, told)


def inputs_of(made: RosMap, at: Hearing) -> tuple[Input, ...]:
    """Return the inputs of a map that has been checked."""
    found: list[Input] = [] if at.robot.joints else [NoJoints(at.bus, at.robot.period)]
    for each in made.inputs:
        maker = _MAKERS.get(each.to)
        if maker is not None:
            found.append(maker(at, each))
    ranges = [(at.of(each), each.sensor) for each in made.inputs if each.to == "range"]
    if ranges:
        found.append(RangesInput(at.bus, ranges, at.robot.range_sensors, _tell_ranges))
    cliffs = [(at.of(each), each.sensor) for each in made.inputs if each.to == "cliff"]
    if cliffs:
        found.append(RangesInput(at.bus, cliffs, at.robot.cliff_sensors, _tell_cliffs))
    bumpers = [(at.of(each), each.sensor or "") for each in made.inputs if each.to == "bumper"]
    if bumpers:
        found.append(BumpersInput(at.bus, bumpers))
    return (*found, *_cameras(made, at))


def _tell_ranges(bus: Bus, now: RobotTime, readings: tuple[RangeReading, ...]) -> None:
    keys.RANGES.publish(bus, Ranges(stamp=now, readings=readings))


def _tell_cliffs(bus: Bus, now: RobotTime, readings: tuple[RangeReading, ...]) -> None:
    keys.CLIFFS.publish(bus, Cliffs(stamp=now, readings=readings))


def _cameras(made: RosMap, at: Hearing) -> Iterator[Input]:
    from tandem.skills.ros.pictures import CameraInput  # noqa: PLC0415 - robots without a camera do without

    for camera in at.robot.cameras:
        topics = {each.to: at.of(each) for each in made.inputs if each.sensor == camera.name}
        if "colour" in topics:
            yield CameraInput(
                at.bus, camera, topics["colour"], topics.get("camera_info"), topics.get("depth")
            )


def _laser(at: Hearing, mapped: MappedInput) -> Input:
    (sensor,) = (each for each in at.robot.lasers if each.name == mapped.sensor)
    return LaserInput(at.bus, at.of(mapped), sensor)


def _joints(at: Hearing, mapped: MappedInput) -> Input:
    groups = [joint for group in at.robot.groups for joint in group.joints]
    fingers = [joint for hand in at.robot.end_effectors for joint in hand.gripper.joints]
    return JointsInput(at.bus, at.of(mapped), (*groups, *fingers))


def _odometry(at: Hearing, mapped: MappedInput) -> Input:
    return OdometryInput(at.bus, _source(at, mapped))


def _pose(at: Hearing, mapped: MappedInput) -> Input:
    return PoseInput(at.bus, _source(at, mapped), mapped.sensor or "")


def _source(at: Hearing, mapped: MappedInput) -> PoseSource:
    topic = at.of(mapped)
    if mapped.type == types.TF:
        return TfSource(topic, mapped.child, mapped.parent, Frames())
    return OdometrySource(topic) if mapped.type == types.ODOMETRY else StampedSource(topic)


_MAKERS: Final[dict[str, Callable[[Hearing, MappedInput], Input]]] = {
    "laser": _laser,
    "joints": _joints,
    "odometry": _odometry,
    "pose": _pose,
}


def _velocity(before: Odometry | None, stamp: RobotTime, pose: FloorPose) -> tuple[float, float]:
    """Return m/s ahead and rad/s between two poses; nothing where there is no earlier one."""
    passed = None if before is None else stamp.since(before.stamp)
    if before is None or passed is None or passed <= 0.0:
        return 0.0, 0.0
    return velocity_between(before.base_in_odom, pose, passed)
