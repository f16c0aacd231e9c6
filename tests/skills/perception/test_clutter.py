"""Clutter out of depth images of known boxes."""

import math

import numpy as np
import pytest

from tandem.skills.geometry.poses import about, compose, invert, to_pose, transform
from tandem.skills.perception import clutter
from tandem.skills.perception.clutter import Known
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.world import Box
from tests.skills.perception.pictures import header
from tests.skills.perception.solids import scene
from tests.skills.perception.stage import DESCRIPTION, URDF, Chain

TABLE = Box(size=(0.9, 1.2, 0.04), pose=Pose(position=(1.1, 0.0, 0.69)))
BASE = to_pose(FloorPose(x=0.1, y=0.05, yaw=0.05))
CAMERA = Chain.from_urdf(URDF, DESCRIPTION.base_frame, "optical").pose({"pan": 0.0, "tilt": -0.5})
CAMERA_IN_MAP = compose(BASE, CAMERA)
CAN = Box(size=(0.08, 0.08, 0.16), pose=Pose(position=(0.95, 0.2, 0.79)))
CARTON = Box(size=(0.2, 0.1, 0.1), pose=Pose(position=(1.1, -0.25, 0.76), orientation=about((0, 0, 1), 0.6)))
ITEM = Box(size=(0.06, 0.06, 0.06), pose=Pose(position=(0.9, 0.0, 0.74)))


def measure(boxes: tuple[Box, ...], known: Known, seed: int = 1) -> tuple[Box, ...]:
    image = scene(header(), CAMERA_IN_MAP, boxes, np.random.default_rng(seed))
    return clutter.boxes(clutter.unexplained(image, CAMERA, BASE, known), known.furniture)


def test_what_stands_on_the_table_is_measured_and_the_table_is_not() -> None:
    found = measure((TABLE, CAN, CARTON), Known((TABLE,), ()))
    assert len(found) == 2
    for truth in (CAN, CARTON):
        near = min(found, key=lambda box: math.dist(box.pose.position, truth.pose.position))
        assert near.pose.position == pytest.approx(truth.pose.position, abs=0.02)
        assert sorted(near.size[:2]) == pytest.approx(sorted(truth.size[:2]), abs=0.03)
        assert near.size[2] == pytest.approx(truth.size[2], abs=0.015)


def test_a_table_alone_gives_nothing_though_the_robot_is_4_cm_off() -> None:
    moved = Box(size=TABLE.size, pose=Pose(position=(1.13, 0.03, 0.69)))
    assert measure((moved,), Known((TABLE,), ())) == ()


def test_items_that_are_known_are_no_clutter() -> None:
    assert measure((TABLE, ITEM), Known((TABLE,), (ITEM,))) == ()
    assert len(measure((TABLE, ITEM), Known((TABLE,), ()))) == 1


def test_the_robots_own_arms_are_no_clutter() -> None:
    arm = Box(size=(0.3, 0.08, 0.08), pose=Pose(position=(0.65, 0.1, 0.95)))
    ends = tuple(transform(invert(BASE), (x, 0.1, 0.95)) for x in (0.5, 0.8))
    assert len(measure((TABLE, arm), Known((TABLE,), ()))) == 1
    assert measure((TABLE, arm), Known((TABLE,), (), segments=((ends[0], ends[1]),))) == ()


def test_the_same_picture_gives_the_same_boxes() -> None:
    first, second = (measure((TABLE, CAN, CARTON), Known((TABLE,), ())) for _ in range(2))
    assert first == second


def test_a_believed_box_is_shown_when_it_is_in_the_picture_and_not_hidden() -> None:
    behind = Box(size=(0.05, 0.05, 0.05), pose=Pose(position=(1.12, 0.26, 0.735)))
    aside = Box(size=(0.05, 0.05, 0.05), pose=Pose(position=(1.0, 1.5, 0.735)))
    gone = Box(size=(0.05, 0.05, 0.05), pose=Pose(position=(1.05, -0.1, 0.735)))
    image = scene(header(), CAMERA_IN_MAP, (TABLE, CAN), np.random.default_rng(1))
    assert clutter.looked_through(image, CAMERA_IN_MAP, (behind, aside, gone, CAN)) == (gone, CAN)
