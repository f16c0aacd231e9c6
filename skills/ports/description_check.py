"""Whether a robot's description holds together: names, groups, hands, postures, frames and the URDF's joints.

Each mistake is told as what was expected and what was found. The sim asks before a robot enters its room,
skills before they begin, and ``tandem hardware check`` of any driver: so all three refuse the same.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final

from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.urdf_check import ONE_NUMBER, UrdfError, check_fingers, mimics, parsed

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from tandem.skills.ports.robot_description import RobotDescription

ARM_POSTURES: Final = ("home", "carry")
SLACK: Final = 1e-3
"""rad or m by which a posture may lie beyond a limit: as much as a rounded number is off."""
MOST_TOLD: Final = 8
"""Mistakes in one text; one wrong name often makes several."""


class DescriptionError(DocumentError):
    """A robot's description that can't be right. The text has a line for each mistake."""


def check_description(robot: RobotDescription) -> None:
    """Do nothing if the description holds together.

    Raises:
        DescriptionError: naming the robot, and for each mistake what was expected and what was found.
    """
    found = [f"expected {expected}, found {found}" for expected, found in _mistakes(robot)]
    if found:
        more = [] if len(found) <= MOST_TOLD else [f"and {len(found) - MOST_TOLD} more"]
        raise DescriptionError("\n".join((f"robot {robot.name!r}:", *found[:MOST_TOLD], *more)))


def _mistakes(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    yield from contradictions(robot)
    try:
        root = parsed(robot.urdf)
    except UrdfError as error:
        yield "a URDF whose joints can be believed", str(error).replace("\n", "; ")
        return
    yield from strangers_in_urdf(robot, root)


def contradictions(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    """Yield what was expected and found where the description is at odds with itself."""
    for what, names in (
        ("group", (group.name for group in robot.groups)),
        ("hand", robot.hands),
        ("joint", _joints(robot)),
    ):
        twice = [name for name, count in Counter(names).items() if count > 1]
        if twice:
            yield f"each {what} once", f"{', '.join(twice)} several times"
    yield from _of_hands(robot)
    yield from _of_postures(robot)
    for laser in robot.lasers:
        if not 0.0 <= laser.range_min < laser.range_max:
            yield f"{laser.name}: range_min below range_max", f"{laser.range_min:g} and {laser.range_max:g}"


def strangers_in_urdf(robot: RobotDescription, root: Element) -> Iterator[tuple[str, str]]:
    """Yield what was expected and found where the description names what its URDF lacks or can't move.

    Args:
        robot: the description.
        root: its URDF, as ``urdf_check.parsed`` returns it.
    """
    links = {link.get("name", "") for link in root.findall("link")}
    children = {
        child.get("link", "") for joint in root.findall("joint") if (child := joint.find("child")) is not None
    }
    for what, link in _frames(robot):
        if link not in links:
            yield f"link {link!r} in the URDF, {what}", "no such link"
    if robot.base_frame in children:
        yield f"{robot.base_frame!r} as the URDF's root", "a link below another"
    kinds = {joint.get("name", ""): joint.get("type", "") for joint in root.findall("joint")}
    for joint in sorted(robot.joints):
        if joint not in kinds:
            yield f"joint {joint!r} of the description in the URDF", "no such joint"
        elif kinds[joint] not in ONE_NUMBER:
            yield f"joint {joint!r} to be one of {', '.join(sorted(ONE_NUMBER))}", kinds[joint]
    yield from _unmovable(robot, root)


def _unmovable(robot: RobotDescription, root: Element) -> Iterator[tuple[str, str]]:
    """Yield hands and groups whose joints skills would not take."""
    try:
        check_fingers(root, {hand.side: hand.gripper.joints for hand in robot.end_effectors})
    except UrdfError as error:
        yield "hands with two fingers that slide", str(error).replace("\n", "; ")
    in_groups = {joint for group in robot.groups for joint in group.joints}
    for follower, mimic in mimics(root).items():
        if both := in_groups & {follower, mimic.source}:
            yield "neither end of a <mimic> in a group", ", ".join(sorted(both))


def _of_hands(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    groups = {group.name for group in robot.groups}
    for hand in robot.end_effectors:
        if hand.group not in groups or hand.group != f"arm_{hand.side}":
            yield f"a group arm_{hand.side} that carries hand {hand.side}", f"group {hand.group!r}"
        having = {posture.name for posture in robot.postures if posture.group == hand.group}
        if lacking := [name for name in ARM_POSTURES if name not in having]:
            yield f"postures home and carry of {hand.group}", f"no {lacking[0]}"


def _of_postures(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    groups = {group.name: group for group in robot.groups}
    for posture in robot.postures:
        group = groups.get(posture.group)
        who = f"posture {posture.name} of {posture.group}"
        if group is None or len(posture.positions) != len(group.limits):
            yield (
                f"{who}: a group, and a position of each of its joints",
                f"{len(posture.positions)} positions",
            )
            continue
        for limit, position in zip(group.limits, posture.positions, strict=True):
            if not limit.lower - SLACK <= position <= limit.upper + SLACK:
                yield f"{who}: {limit.joint} from {limit.lower:g} to {limit.upper:g}", f"{position:g}"


def _joints(robot: RobotDescription) -> Iterable[str]:
    yield from (joint for group in robot.groups for joint in group.joints)
    yield from (joint for hand in robot.end_effectors for joint in hand.gripper.joints)


def _frames(robot: RobotDescription) -> list[tuple[str, str]]:
    return [
        ("its base_frame", robot.base_frame),
        *((f"the tool frame of hand {hand.side}", hand.frame) for hand in robot.end_effectors),
        *(
            (f"a touch_link of {hand.side}", link)
            for hand in robot.end_effectors
            for link in hand.touch_links
        ),
        *((f"the frame of camera {camera.name}", camera.frame) for camera in robot.cameras),
        *((f"the frame of laser {laser.name}", laser.frame) for laser in robot.lasers),
        *((f"the frame of range sensor {each.name}", each.frame) for each in robot.range_sensors),
        *((f"the frame of cliff sensor {each.name}", each.frame) for each in robot.cliff_sensors),
        *((f"the frame of robot sensor {each.name}", each.frame) for each in robot.robot_sensors),
    ]
