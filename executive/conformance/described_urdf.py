"""Clauses about the URDF in the description."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.skills.ports.urdf_check import ONE_NUMBER, UrdfError, check_fingers, mimics, parsed

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.robot_description import RobotDescription


def _parses(bench: Bench) -> Steps:
    try:
        parsed(bench.robot.urdf)
    except UrdfError as error:
        raise Broken("a URDF whose joints can be believed", str(error).replace("\n", "; ")) from error
    yield


def _holds_parts(bench: Bench) -> Steps:
    robot = bench.robot
    try:
        root = parsed(robot.urdf)
    except UrdfError as error:
        raise Skip("the URDF can't be read") from error
    links = {link.get("name", "") for link in root.findall("link")}
    children = {
        child.get("link", "") for joint in root.findall("joint") if (child := joint.find("child")) is not None
    }
    for what, link in _frames(robot):
        if link not in links:
            raise Broken(f"link {link!r} in the URDF, {what}", "no such link")
    if robot.base_frame in children:
        raise Broken(f"{robot.base_frame!r} as the URDF's root", "a link below another")
    kinds = {joint.get("name", ""): joint.get("type", "") for joint in root.findall("joint")}
    for joint in sorted(robot.joints):
        if joint not in kinds:
            raise Broken(f"joint {joint!r} of the description in the URDF", "no such joint")
        if kinds[joint] not in ONE_NUMBER:
            raise Broken(f"joint {joint!r} to be one of {', '.join(sorted(ONE_NUMBER))}", kinds[joint])
    _check_joints(robot, root)
    yield


def _check_joints(robot: RobotDescription, root: Element) -> None:
    """Raise Broken for hands and groups whose joints skills would not take."""
    try:
        check_fingers(root, {hand.side: hand.gripper.joints for hand in robot.end_effectors})
    except UrdfError as error:
        raise Broken("hands with two fingers that slide", str(error).replace("\n", "; ")) from error
    in_groups = {joint for group in robot.groups for joint in group.joints}
    for follower, mimic in mimics(root).items():
        if both := in_groups & {follower, mimic.source}:
            raise Broken("neither end of a <mimic> in a group", ", ".join(sorted(both)))


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


CLAUSES: Final = (
    Clause(
        "urdf_parses",
        "The URDF is XML, and each of its joints has ends, an axis and limits that can be right.",
        "extending.md#a-robot",
        _parses,
    ),
    Clause(
        "urdf_holds_parts",
        "The URDF has each joint and frame that the description names, with base_frame as its root.",
        "extending.md#a-robot",
        _holds_parts,
    ),
)
