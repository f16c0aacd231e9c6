"""Where a tag would be read for sure, on painted depth images."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from tandem.skills.geometry.poses import about, compose, from_rpy
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.perception.open_view import in_the_open
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box
from tests.skills.perception.pictures import header
from tests.skills.perception.solids import scene

CAMERA = compose(
    Pose(position=(0.0, 0.0, 1.0)), Pose(orientation=from_rpy(-math.pi / 2.0, 0.0, -math.pi / 2.0))
)
"""One metre above the map's origin, looking along its x."""
EDGE = 0.16


def carton(x: float = 1.0, y: float = 0.0, turned: float = 0.0) -> Box:
    """A carton whose tag, at the same height as the camera, faces it unless it is turned (rad)."""
    facing = about((0.0, 0.0, 1.0), math.pi + turned)
    return Box(size=(0.3, 0.4, 0.4), pose=Pose(position=(x, y, 1.0), orientation=facing))


def tag_of(box: Box) -> Pose:
    return tag_of_item(box.pose, box.size[0])


def painted(*boxes: Box) -> RgbdImage:
    return scene(header(), CAMERA, boxes, np.random.default_rng(1))


WALL = Box(size=(0.1, 6.0, 6.0), pose=Pose(position=(3.0, 0.0, 1.0)))


def at(x: float, y: float, size: Sequence[float] = (0.05, 0.1, 0.2)) -> Box:
    return Box(size=(size[0], size[1], size[2]), pose=Pose(position=(x, y, 1.0)))


@pytest.mark.parametrize(
    ("believed", "seen", "open_"),
    [
        (carton(), (carton(y=-0.1),), True),
        (carton(), (WALL,), True),
        (carton(), (carton(), at(0.5, 0.0)), False),
        (carton(), (carton(), at(0.5, 0.04)), False),
        (carton(), (carton(), at(0.84, 0.03, (0.02, 0.02, 0.1))), False),
        (carton(), (carton(), at(0.5, 0.3)), True),
        (carton(y=0.45), (carton(y=0.3),), False),
        (carton(turned=math.radians(74.0)), (carton(),), False),
        (carton(turned=math.pi), (carton(),), False),
        (carton(x=8.0), (carton(x=8.0, y=-0.1),), False),
    ],
    ids=[
        "its own plain face has come there",
        "nothing is there",
        "an arm is before it",
        "an arm is before a part of it",
        "a finger is 2 cm before it",
        "an arm is beside it",
        "the picture ends there",
        "seen too obliquely",
        "seen from behind",
        "too small",
    ],
)
def test_the_place_of_a_tag_is_open(believed: Box, seen: tuple[Box, ...], *, open_: bool) -> None:
    assert in_the_open(painted(*seen), CAMERA, tag_of(believed), EDGE) is open_


def test_without_a_depth_nothing_is_known() -> None:
    image = painted(carton())
    image.depth[:] = 0
    assert not in_the_open(image, CAMERA, tag_of(carton()), EDGE)
