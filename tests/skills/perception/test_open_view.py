"""Where a tag would be read for sure, on painted depth images."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from skills.perception.open_view import in_the_open, tag_on
from skills.ports.geometry import Pose, about, compose, distance, from_rpy
from skills.ports.image import RgbdImage
from skills.ports.world import Box
from tests.skills.perception.pictures import header
from tests.skills.perception.solids import scene
from tests.skills.world.facts import tag

CAMERA = compose(
    Pose(position=(0.0, 0.0, 1.0)), Pose(orientation=from_rpy(-math.pi / 2.0, 0.0, -math.pi / 2.0))
)
"""One metre above the map's origin, looking along its x."""
EDGE = 0.16


def carton(x: float = 1.0, y: float = 0.0, turned: float = 0.0) -> Box:
    """A carton whose tag, at the same height as the camera, faces it unless it is turned (rad)."""
    facing = about((0.0, 0.0, 1.0), math.pi + turned)
    return Box(size=(0.3, 0.4, 0.4), pose=Pose(position=(x, y, 1.0), orientation=facing))


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
    assert in_the_open(painted(*seen), CAMERA, tag_on(believed), EDGE) is open_


def test_without_a_depth_nothing_is_known() -> None:
    image = painted(carton())
    image.depth[:] = 0
    assert not in_the_open(image, CAMERA, tag_on(carton()), EDGE)


def test_the_tag_is_on_the_face_that_tells_where_the_item_is() -> None:
    seen = tag(0.75, 0.1)
    box = Box(size=(0.07, 0.07, 0.07), pose=compose(seen, Pose(position=(0.0, 0.0, -0.035))))
    upright = box.model_copy(
        update={"pose": Pose(position=box.pose.position, orientation=about((0.0, 0.0, 1.0), math.pi))}
    )
    assert distance(tag_on(upright), seen) < 1e-9
