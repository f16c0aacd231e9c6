"""The file that says which ROS topics a robot is made of: YAML, checked against the robot's description."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Final, Literal

from pydantic import Field

from tandem.skills.ports.message import Message, PartName
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sources import DocumentError, Source
from tandem.skills.ros import types
from tandem.skills.ros.types import Distro
from tandem.skills.yaml_file import read_document, validate

Part = Literal[
    "joints", "odometry", "pose", "laser", "range", "cliff", "bumper", "colour", "depth", "camera_info"
]
Topic = Annotated[str, Field(pattern=r"^(/[A-Za-z_][A-Za-z0-9_]*)+$", max_length=200)]
"""A topic's full name, such as ``/base/cmd_vel``."""

TAKES: Final[Mapping[Part, tuple[str, ...]]] = MappingProxyType(
    {
        "joints": (types.JOINT_STATE,),
        "odometry": (types.ODOMETRY, types.TF),
        "pose": (types.POSE_STAMPED, types.TF),
        "laser": (types.LASER_SCAN,),
        "range": (types.RANGE,),
        "cliff": (types.RANGE,),
        "bumper": (types.BOOL,),
        "colour": (types.IMAGE,),
        "depth": (types.IMAGE,),
        "camera_info": (types.CAMERA_INFO,),
    }
)
"""The types that each part is told by."""
_SENSORS: Final[Mapping[Part, str]] = MappingProxyType(
    {
        "pose": "pose_sensors",
        "laser": "lasers",
        "range": "range_sensors",
        "cliff": "cliff_sensors",
        "bumper": "bumpers",
        "colour": "cameras",
        "depth": "cameras",
        "camera_info": "cameras",
    }
)
"""Where a part's sensor stands in the description."""
SHARED: Final[tuple[Part, ...]] = ("range", "cliff")
"""Parts whose sensors may share a topic: each is then known by its frame."""
VELOCITIES: Final = (types.TWIST, types.TWIST_STAMPED)


class Input(Message):
    """A topic that tells of a part of the robot."""

    topic: Topic
    type: str
    to: Part
    sensor: PartName | None = None
    """Which one, by its name in the description. Without it, those of ``SHARED`` parts are known by frame."""
    parent: str = ""
    """With tf: the frame in which ``child`` is looked for, such as ``map``."""
    child: str = ""


class CmdVel(Message):
    """The topic that moves the base."""

    topic: Topic
    type: str


class RosMap(Message):
    """A robot out of ROS topics."""

    robot: str | None = None
    """A robot that Tandem knows (``tandem.robots``), whose description is served."""
    description: str | None = None
    """Or a file with a ``RobotDescription``, beside this one."""
    urdf: str | None = None
    """A file whose text is that description's ``urdf``."""
    domain: Annotated[int, Field(ge=0, le=232)] = 0
    """``ROS_DOMAIN_ID``."""
    distro: Distro = "jazzy"
    node: Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_]*$")] = "tandem"
    """What the node is called in ROS."""
    inputs: Annotated[tuple[Input, ...], Field(min_length=1)]
    cmd_vel: CmdVel | None = None


def load_map(path: Path, known: Callable[[str], RobotDescription]) -> tuple[RosMap, RobotDescription]:
    """Return a map and the description of its robot.

    Args:
        path: the file.
        known: gives the description of a robot by its name; raises LookupError or ValueError.

    Raises:
        DocumentError: with a line for each mistake: file, path and line, what was expected, what was found.
    """
    data, source = read_document(path)
    made = validate(data, source, RosMap)
    description = _description(made, source, path, known)
    if wrong := [f"{source.at(where)}: {reason}" for where, reason in mistakes_of(made, description)]:
        raise DocumentError("\n".join(wrong))
    return made, description


def _description(
    made: RosMap, source: Source, path: Path, known: Callable[[str], RobotDescription]
) -> RobotDescription:
    if (made.robot is None) == (made.description is None):
        raise DocumentError(f"{source.at('')}: expected either robot or description")
    if made.robot is not None:
        try:
            return known(made.robot)
        except (LookupError, ValueError) as error:
            raise DocumentError(f"{source.at('robot')}: {error}") from error
    assert made.description is not None, "one of the two is there"
    told, where = read_document(path.parent / made.description)
    if made.urdf is not None and isinstance(told, dict):
        urdf = path.parent / made.urdf
        try:
            told = {**told, "urdf": urdf.read_text("utf-8")}
        except (OSError, UnicodeDecodeError) as error:
            raise DocumentError(f"{source.at('urdf')}: cannot read {urdf}: {error}") from error
    return validate(told, where, RobotDescription)


def mistakes_of(made: RosMap, robot: RobotDescription) -> Iterator[tuple[str, str]]:
    """Give the path of each mistake in a map that its model can't see, and what was expected."""
    parts: dict[tuple[str, str | None], str] = {}
    typed: dict[str, tuple[str, str]] = {}
    for index, each in enumerate(made.inputs):
        here = f"inputs.{index}"
        yield from _unfit_type(here, each.type, TAKES[each.to], f"of {each.to}")
        yield from _unfit_part(here, each, robot)
        yield from _unfit_frames(here, each)
        first = parts.setdefault((each.to, each.sensor), here)
        if first != here:
            yield f"{here}.to", f"{_words(each)} is mapped already, in {first}"
        told, by = typed.setdefault(each.topic, (each.type, here))
        if told != each.type:
            yield f"{here}.topic", f"{each.topic} has the type {told} in {by}"
    for part in SHARED:
        yield from _mixed(part, made.inputs)
    if made.cmd_vel is not None:
        yield from _unfit_type("cmd_vel", made.cmd_vel.type, VELOCITIES, "of cmd_vel")
        if robot.drive is None:
            yield "cmd_vel", f"{robot.name} has no drive"


def missing(made: RosMap, robot: RobotDescription) -> tuple[str, ...]:
    """Return the parts of the robot that nothing is mapped to, in words: these stay silent."""
    told = {(each.to, each.sensor) for each in made.inputs}
    every = {part for part, sensor in told if part in SHARED and sensor is None}
    wanted: list[tuple[Part, str | None]] = [("joints", None)] if robot.joints else []
    if robot.drive is not None:
        wanted.append(("odometry", None))
    for part in ("pose", "laser", "range", "cliff", "bumper", "colour", "camera_info"):
        wanted += [(part, name) for name in _names(robot, part) if part not in every]
    lacks = [part if name is None else f"{part} {name}" for part, name in wanted if (part, name) not in told]
    return (*lacks, "cmd_vel") if robot.drive is not None and made.cmd_vel is None else tuple(lacks)


def _names(robot: RobotDescription, part: Part) -> tuple[str, ...]:
    return tuple(each.name for each in getattr(robot, _SENSORS[part]))


def _words(each: Input) -> str:
    return each.to if each.sensor is None else f"{each.to} of {each.sensor}"


def _unfit_type(here: str, found: str, takes: Sequence[str], of: str) -> Iterator[tuple[str, str]]:
    if found not in types.HASHES:
        yield f"{here}.type", f"expected one of {', '.join(sorted(types.HASHES))}; found {found}"
    elif found not in takes:
        yield f"{here}.type", f"expected {' or '.join(takes)}, the type {of}; found {found}"


def _unfit_part(here: str, each: Input, robot: RobotDescription) -> Iterator[tuple[str, str]]:
    if each.to == "joints" and not robot.joints:
        yield f"{here}.to", f"{robot.name} has no joints in groups and grippers"
    if each.to == "odometry" and robot.drive is None:
        yield f"{here}.to", f"{robot.name} has no drive"
    if each.to not in _SENSORS:
        if each.sensor is not None:
            yield f"{here}.sensor", f"expected none: {each.to} has no sensors"
        return
    names = _names(robot, each.to)
    kind = _SENSORS[each.to].replace("_", " ")
    if not names:
        yield f"{here}.to", f"{robot.name} has no {kind}"
    elif each.sensor is None and each.to not in SHARED:
        yield f"{here}.sensor", f"expected one of {robot.name}'s {kind}: {', '.join(names)}; found none"
    elif each.sensor is not None and each.sensor not in names:
        yield (
            f"{here}.sensor",
            f"expected one of {robot.name}'s {kind}: {', '.join(names)}; found {each.sensor}",
        )


def _unfit_frames(here: str, each: Input) -> Iterator[tuple[str, str]]:
    for name, frame in (("parent", each.parent), ("child", each.child)):
        if each.type == types.TF and not frame:
            yield f"{here}.{name}", "expected a frame: tf tells of many"
        elif each.type != types.TF and frame:
            yield f"{here}.{name}", f"expected none: only {types.TF} has frames to choose from"


def _mixed(part: Part, inputs: Sequence[Input]) -> Iterator[tuple[str, str]]:
    these = [(index, each) for index, each in enumerate(inputs) if each.to == part]
    every = next((index for index, each in these if each.sensor is None), None)
    for index, each in these:
        if every is not None and each.sensor is not None:
            yield f"inputs.{index}.to", f"inputs.{every} maps all {part} sensors already, by their frames"


def described(made: RosMap, robot: RobotDescription) -> tuple[str, ...]:
    """Return a map in lines for people: what flows from where to where, and what is missing."""
    head = f"{robot.name}: ROS domain {made.domain}, {made.distro}, node /{made.node}"
    flows = [f"{each.topic} ({each.type}) -> {_words(each)}" for each in made.inputs]
    if made.cmd_vel is not None:
        flows.append(f"velocity -> {made.cmd_vel.topic} ({made.cmd_vel.type})")
    lacks = missing(made, robot)
    return (head, *flows, *([f"no topic for: {', '.join(lacks)}"] if lacks else []))
