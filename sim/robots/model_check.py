"""Whether what the simulation is told of a robot fits the physics' URDF, and the description."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tandem.skills.ports.description_check import DescriptionError, check_description

if TYPE_CHECKING:
    from tandem.sim.model import RobotModel


def check_model(model: RobotModel) -> None:
    """Do nothing if the parts of a robot fit each other.

    Raises:
        DescriptionError: naming each part that there is not, and where it was named.
    """
    check_description(model.description)
    found = list(_mistakes(model))
    if found:
        raise DescriptionError("\n".join((f"robot {model.description.name!r}:", *found)))


def _mistakes(model: RobotModel) -> Iterator[str]:
    root = ET.fromstring(model.physics_urdf)  # noqa: S314 - put together by the robot's own file
    links = [link.get("name", "") for link in root.findall("link")]
    joints = {joint.get("name", "") for joint in root.findall("joint")}
    for where, link in _links(model):
        if link not in links:
            yield f"{where}: no link {link!r} in the physics; is it among those that finish keeps?"
    for where, joint in _joints(model):
        if joint not in joints:
            yield f"{where}: no joint {joint!r} in the physics"
    for where, frame in _frames(model):
        if frame not in model.frames:
            yield f"{where}: no frame {frame!r} among the frames that finish returned"
    if links and links[0] != model.root:
        yield f"expected {model.root!r} as the first link, found {links[0]!r}; put_first adds it"
    sides = tuple(hand.side for hand in model.hands)
    if set(sides) != set(model.description.hands):
        yield f"hands: expected those of the description, {model.description.hands}, found {sides}"
    if (model.wheels is None) is not (model.description.drive is None):
        yield "expected wheels and a drive in the description, or neither of them"


def _links(model: RobotModel) -> Iterator[tuple[str, str]]:
    for hand in model.hands:
        yield from ((f"hand {hand.side}", link) for link in (hand.mount_link, *hand.finger_links))
    for where, named in (
        ("floor_frictions", model.floor_frictions),
        ("sideways_frictions", model.sideways_frictions),
        ("bumper_links", model.bumper_links),
        ("touching_links", [link for pair in model.touching_links for link in pair]),
        ("anchored_wheels", model.anchored_wheels),
    ):
        yield from ((where, link) for link in named)


def _joints(model: RobotModel) -> Iterator[tuple[str, str]]:
    for hand in model.hands:
        named = (hand.wrench_joint, hand.inner, hand.outer)
        yield from ((f"hand {hand.side}", joint) for joint in named)
    if model.wheels is not None:
        yield from (("wheels", joint) for joint in model.wheels.joints)
    yield from (("description", joint) for joint in sorted(model.description.joints))


def _frames(model: RobotModel) -> Iterator[tuple[str, str]]:
    told = model.description
    yield from ((f"hand {hand.side}", hand.frame) for hand in told.end_effectors)
    yield from ((f"camera {each.name}", each.frame) for each in told.cameras)
    yield from ((f"laser {each.name}", each.frame) for each in told.lasers)
    yield from ((f"range sensor {each.name}", each.frame) for each in told.range_sensors)
    yield from ((f"cliff sensor {each.name}", each.frame) for each in told.cliff_sensors)
    yield from ((f"robot sensor {each.name}", each.frame) for each in told.robot_sensors)
