"""What only the key, or the robot's description, can tell of a message: its joints, its sides, its sizes.

What a message can say about itself (lengths, ranges) stands in its model.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import singledispatch
from math import isfinite
from typing import Final

from tandem.skills.ports.hardware import GripperState, GroupStatus, JointStates, RgbdHeader, SetPoint, Wrench
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import Bumpers, Cliffs, LaserScan, PoseReading, Ranges, RobotsSeen

LARGEST: Final = 1e6
"""No length, angle, speed or force that a robot tells is larger, in its SI unit. Beyond it sums and products
of what was heard lose their digits, and then become infinite."""
LONGEST: Final = 1e9
"""Seconds: no robot's clock has run for 31 years."""
NAMED: Final = 3
"""Joints that an explanation names."""


@singledispatch
def misfit(message: Message, key: str, robot: RobotDescription | None) -> str:
    """Say what about a message does not fit its key or the robot; nothing when all does.

    Args:
        message: decoded, so it fits its model.
        key: on which it came.
        robot: None while it is not known; then only the key is compared.
    """
    del message, key, robot
    return ""


@misfit.register
def _joints(message: JointStates, key: str, robot: RobotDescription | None) -> str:
    del key
    if robot is None:
        return ""
    told, known = frozenset(message.names), robot.joints
    if strange := sorted(told - known):
        return f"joints that the robot does not have: {_names(strange)}"
    if missing := sorted(known - told):
        return f"joints are missing: {_names(missing)}"
    return ""


@misfit.register
def _group(message: GroupStatus, key: str, robot: RobotDescription | None) -> str:
    groups = () if robot is None else tuple(group.name for group in robot.groups)
    if robot is not None and message.group not in groups:
        return f"group: expected one of {', '.join(groups)}, found {message.group}"
    return _of_key(key, f"hw/group/{message.group}/status")


@misfit.register
def _setpoint(message: SetPoint, key: str, robot: RobotDescription | None) -> str:
    name = key.split("/")[2]
    group = None if robot is None else next((each for each in robot.groups if each.name == name), None)
    if group is not None and len(message.positions) != len(group.joints):
        return f"expected {len(group.joints)} joints of {name}, found {len(message.positions)}"
    return ""


@misfit.register
def _gripper(message: GripperState, key: str, robot: RobotDescription | None) -> str:
    del robot
    return _of_key(key, f"hw/gripper/{message.side}/state")


@misfit.register
def _wrench(message: Wrench, key: str, robot: RobotDescription | None) -> str:
    del robot
    return _of_key(key, f"hw/wrench/{message.side}")


@misfit.register
def _scan(message: LaserScan, key: str, robot: RobotDescription | None) -> str:
    if robot is None:
        return ""
    for laser in robot.lasers:
        if key == f"hw/{laser.name}/laser":
            found = len(message.ranges)
            return "" if found == laser.beams else f"expected {laser.beams} ranges, found {found}"
    return f"the scan of a laser that the robot does not have: it came on {key}"


@misfit.register
def _ranges(message: Ranges, key: str, robot: RobotDescription | None) -> str:
    del key
    if robot is None:
        return ""
    known = {each.name: each for each in robot.range_sensors}
    if strange := sorted({each.sensor for each in message.readings} - known.keys()):
        return f"range sensors that the robot does not have: {_names(strange)}"
    for reading in message.readings:
        least = known[reading.sensor].range_min
        if reading.distance < least:
            return f"{reading.sensor}: expected at least {least:g} m, found {reading.distance:g} m"
    return ""


@misfit.register
def _cliffs(message: Cliffs, key: str, robot: RobotDescription | None) -> str:
    del key
    known = None if robot is None else {each.name for each in robot.cliff_sensors}
    strange = [] if known is None else sorted({each.sensor for each in message.readings} - known)
    return f"cliff sensors that the robot does not have: {_names(strange)}" if strange else ""


@misfit.register
def _bumpers(message: Bumpers, key: str, robot: RobotDescription | None) -> str:
    del key
    known = None if robot is None else {each.name for each in robot.bumpers}
    strange = [] if known is None else sorted(set(message.pressed) - known)
    return f"bumpers that the robot does not have: {_names(strange)}" if strange else ""


@misfit.register
def _base_pose(message: PoseReading, key: str, robot: RobotDescription | None) -> str:
    del key
    return "" if robot is None else _strange_sensor(message.sensor, [s.name for s in robot.pose_sensors])


@misfit.register
def _robots(message: RobotsSeen, key: str, robot: RobotDescription | None) -> str:
    del key
    return "" if robot is None else _strange_sensor(message.sensor, [s.name for s in robot.robot_sensors])


def _strange_sensor(name: str, known: list[str]) -> str:
    return "" if name in known else f"sensor: expected one of {', '.join(known) or 'none'}, found {name}"


@misfit.register
def _picture(message: RgbdHeader, key: str, robot: RobotDescription | None) -> str:
    if robot is None:
        return ""
    for camera in robot.cameras:
        if key == f"hw/camera/{camera.name}/rgbd":
            expected = (camera.name, camera.width, camera.height)
            if (message.camera, message.width, message.height) == expected:
                return ""
            return (
                f"expected a picture of {camera.name}, {camera.width} x {camera.height}, "
                f"found {message.camera}, {message.width} x {message.height}"
            )
    return f"the picture of a camera that the robot does not have: it came on {key}"


def strange_hands(named: Iterable[str | None], robot: RobotDescription | None) -> str:
    """Say which hands a message names that the robot does not have; nothing when it has all."""
    known = None if robot is None else {None, *robot.hands}
    strange = [] if known is None else sorted({str(each) for each in named if each not in known})
    return f"hands that the robot does not have: {_names(strange)}" if strange else ""


def _of_key(key: str, expected: str) -> str:
    return "" if key == expected else f"sent on {key}, expected on {expected}"


def _names(joints: list[str]) -> str:
    more = len(joints) - NAMED
    return ", ".join(joints[:NAMED]) + (f" and {more} more" if more > 0 else "")


def too_large(value: object) -> bool:
    """Say whether a message holds a number that no robot tells."""
    if isinstance(value, float):
        return not -LARGEST <= value <= LARGEST
    if isinstance(value, tuple):
        if set(map(type, value)) == {float}:  # of a laser: hundreds, many times a second
            return not (min(value) >= -LARGEST and max(value) <= LARGEST and isfinite(sum(value)))
        return any(map(too_large, value))
    if isinstance(value, RobotTime):
        return not -LONGEST <= value.seconds <= LONGEST
    return isinstance(value, Message) and any(map(too_large, value.__dict__.values()))
