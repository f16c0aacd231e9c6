"""What is wrong with the hardware while faults last, worked out from all that are under way at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.sim.faults import (
    BumperPressed,
    CameraDark,
    CameraSilent,
    Fault,
    GripperStuck,
    GripperWeak,
    HandOpens,
    HardwareSilent,
    JointsSilent,
    JointStall,
    LaserSilent,
    OdometryJump,
    RangeSilent,
    RangeStuck,
)
from tandem.sim.gripper import HandDefects
from tandem.sim.lens import Freeze, darken
from tandem.sim.scenario import ScenarioError
from tandem.sim.sensor_nodes import RangesNode
from tandem.skills.ports import keys
from tandem.skills.ports.sources import Source

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from tandem.sim.faulty_link import FaultyLink
    from tandem.sim.hardware import Hardware
    from tandem.skills.ports.robot_description import RobotDescription

CUTS: Final[dict[type[Fault], str]] = {
    HardwareSilent: "hw/",
    CameraSilent: "hw/camera/",
    JointsSilent: "hw/joints/",
}
"""The keys that a fault cuts, by how they begin."""


@dataclass(frozen=True)
class Standing:
    """A fault under way: the sides that it means, and the picture that it keeps, where its kind has such."""

    fault: Fault
    sides: tuple[str, ...] = ()
    freeze: Freeze | None = None


def break_hardware(standing: Sequence[Standing], link: FaultyLink, hardware: Hardware) -> None:
    """Have the hardware broken in just these ways, and whole otherwise."""
    faults = [each.fault for each in standing]
    cut = {CUTS[type(fault)] for fault in faults if type(fault) in CUTS}
    if any(isinstance(fault, LaserSilent) for fault in faults):
        cut |= {keys.laser(each.name).key for each in hardware.description.lasers}
    link.cut = frozenset(cut)
    for node in hardware.sensors:
        if isinstance(node, RangesNode):
            node.silent = _ranges(RangeSilent, faults, hardware.description)
            node.stuck = _ranges(RangeStuck, faults, hardware.description)
    pictures = [keys.rgbd(each.name) for each in hardware.description.cameras]
    link.spoils = {key: spoil for key in pictures for spoil in _spoils(standing)}
    stalls = [stall for each in standing for stall in _stalls(each, hardware.description)]
    for name, group in hardware.groups.items():
        group.stalled = {
            joint: fault.limp
            for stalled, fault in stalls
            if stalled == name
            for joint in stalled_joints(fault, stalled, hardware.description)
        }
    for side, hand in hardware.hands.items():
        hand.defects = _hand([each.fault for each in standing if side in each.sides])
    for base in hardware.bases:
        base.jammed = frozenset(
            fault.bumper or hardware.description.bumpers[0].name
            for fault in faults
            if isinstance(fault, BumperPressed)
        )


def _ranges(
    kind: type[RangeSilent | RangeStuck], faults: Sequence[Fault], robot: RobotDescription
) -> frozenset[str]:
    """Return the range and cliff sensors that faults of a kind are about."""
    meant = [fault.sensor for fault in faults if isinstance(fault, kind)]
    return frozenset(name for name in _down_or_ahead(robot) if None in meant or name in meant)


def _down_or_ahead(robot: RobotDescription) -> list[str]:
    """Return the names of the range sensors and of the cliff sensors."""
    return [each.name for each in robot.range_sensors] + [each.name for each in robot.cliff_sensors]


def _stalls(each: Standing, robot: RobotDescription) -> list[tuple[str, JointStall]]:
    """Return the groups that a fault stalls, each with it."""
    if not isinstance(each.fault, JointStall):
        return []
    if each.fault.group is not None:
        return [(each.fault.group, each.fault)]
    return [(robot.end_effector(side).group, each.fault) for side in each.sides]


def _spoils(standing: Sequence[Standing]) -> list[Callable[[bytes], bytes]]:
    """Return what happens to each picture, if anything does."""
    if any(isinstance(each.fault, CameraDark) for each in standing):
        return [darken]
    kept: list[Callable[[bytes], bytes]] = [each.freeze for each in standing if each.freeze is not None]
    return kept[:1]


def _hand(faults: Sequence[Fault]) -> HandDefects:
    return HandDefects(
        stuck=any(isinstance(fault, GripperStuck) for fault in faults),
        opens=any(isinstance(fault, HandOpens) for fault in faults),
        force=min((fault.force for fault in faults if isinstance(fault, GripperWeak)), default=1.0),
    )


def stalled_joints(fault: JointStall, group: str, robot: RobotDescription) -> tuple[str, ...]:
    """Return the joints of a group that stall.

    Raises:
        KeyError: when the robot has no such group.
        LookupError: when the group has no such joint.
    """
    joints = robot.group(group).joints
    if fault.joint is None:
        return joints
    named = [joint for index, joint in enumerate(joints) if fault.joint in {joint, index}]
    if not named:
        there = f"0 to {len(joints) - 1} or one of {', '.join(joints)}"
        raise LookupError(f"joint: expected {there}, found {fault.joint}")
    return tuple(named)


def _bumper_misfit(fault: BumperPressed, robot: RobotDescription) -> str:
    there = [each.name for each in robot.bumpers]
    if not there:
        return f"kind: expected a robot with bumpers, found {robot.name}, which has none"
    if fault.bumper is None or fault.bumper in there:
        return ""
    return f"bumper: expected one of {', '.join(there)}, found {fault.bumper}"


def _range_misfit(fault: RangeSilent | RangeStuck, robot: RobotDescription) -> str:
    there = _down_or_ahead(robot)
    if not there:
        return (
            f"kind: expected a robot with range sensors or cliff sensors, found {robot.name}, which has none"
        )
    if fault.sensor is None or fault.sensor in there:
        return ""
    return f"sensor: expected one of {', '.join(there)}, found {fault.sensor}"


def _stall_misfit(fault: JointStall, robot: RobotDescription) -> str:
    groups = [group.name for group in robot.groups]
    if fault.group is not None and fault.group not in groups:
        return f"group: expected one of {', '.join(groups)}, found {fault.group}"
    arms = [effector.group for effector in robot.end_effectors]
    try:
        for group in arms if fault.group is None else [fault.group]:
            stalled_joints(fault, group, robot)
    except LookupError as error:
        return str(error.args[0])
    return ""


def misfit(fault: Fault, robot: RobotDescription) -> str:
    """Return what a fault names and the robot doesn't have, and what was expected; else nothing."""
    if isinstance(fault, OdometryJump | BumperPressed) and robot.drive is None:
        return f"kind: expected a robot that drives, found {robot.name}, whose base is fixed"
    if isinstance(fault, BumperPressed):
        return _bumper_misfit(fault, robot)
    if isinstance(fault, RangeSilent | RangeStuck):
        return _range_misfit(fault, robot)
    side = getattr(fault, "side", None)
    if side is not None and side not in robot.hands:
        return f"side: expected one of {', '.join(robot.hands) or 'none: it has no hands'}, found {side}"
    return _stall_misfit(fault, robot) if isinstance(fault, JointStall) else ""


def check_faults(faults: Iterable[Fault], robots: Mapping[str, RobotDescription], *, source: Source) -> None:
    """Check what the faults name of a robot.

    Args:
        faults: each is meant for one of the robots.
        robots: by their names in the scenario, the first one first.
        source: the file that is named.

    Raises:
        ScenarioError: with one line for each mistake.
    """
    problems = []
    for index, fault in enumerate(faults):
        meant = next(iter(robots)) if fault.robot is None else fault.robot
        field, _, expected = misfit(fault, robots[meant]).partition(": ")
        if expected:
            problems.append(f"{source.at(f'faults.{index}.{field}')}: {expected}")
    if problems:
        raise ScenarioError("\n".join(problems))
