"""Pictures of tagged items, read with OpenCV: right way round, where they should be, at the right depth."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tandem.sim.render_world import RenderWorld, View, looking_at
from tandem.sim.robots.registry import robot_model
from tandem.sim.scene import Label, SceneBody
from tandem.sim.tags import tags_in_item
from tandem.sim.things import BoxShape, CylinderShape
from tandem.skills.geometry.poses import about, compose, invert, transform
from tandem.skills.ports.pose import Pose

SIZE = (0.06, 0.06, 0.06)
EDGE = 0.048
AT = (0.5, 0.3, 0.8)


@pytest.fixture(scope="module", params=[True, False], ids=["egl", "tiny"])
def twin(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[RenderWorld]:
    made = RenderWorld(
        (robot_model("tiago_dual").physics_urdf,),
        Path(tmp_path_factory.mktemp("twin")),
        hardware=request.param,
    )
    yield made
    made.close()


def item(yaw: float) -> SceneBody:
    pose = Pose(position=AT, orientation=about((0, 0, 1), yaw))
    return SceneBody("item_29", BoxShape(size=SIZE), pose, 0.1, 0.9, (1, 1, 1), Label(29, EDGE))


def tin(yaw: float) -> SceneBody:
    shape = CylinderShape(radius=SIZE[0] / 2, height=SIZE[2])
    return replace(item(yaw), shape=shape)


def true_corners(body: SceneBody, view: View) -> list[np.ndarray]:
    """Return each tag's corners in pixels (first pixel's centre at 0, 0), clockwise from its top left."""
    found = []
    map_in_camera = invert(view.camera_in_map)
    for tag_in_item in tags_in_item(SIZE):
        tag_in_camera = compose(map_in_camera, compose(body.pose, tag_in_item))
        h = EDGE / 2
        points = [transform(tag_in_camera, p) for p in ((-h, h, 0), (h, h, 0), (h, -h, 0), (-h, -h, 0))]
        pixels = [(view.focal * x / z, view.focal * y / z) for x, y, z in points]
        found.append(np.array(pixels) + np.array(((view.width - 1) / 2, (view.height - 1) / 2)))
    return found


def detect(colour: np.ndarray) -> list[tuple[int, np.ndarray]]:
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    grey = cv2.cvtColor(colour, cv2.COLOR_RGB2GRAY)
    corners, ids, _ = cv2.aruco.ArucoDetector(dictionary).detectMarkers(grey)
    numbers = [] if ids is None else ids.ravel().tolist()
    return [(number, each.reshape(4, 2)) for number, each in zip(numbers, corners, strict=True)]


@pytest.mark.parametrize("distance", [0.5, 1.0, 1.5])
@pytest.mark.parametrize("yaw", [0.0, 0.5, math.pi / 2, math.pi, -math.pi / 2])
def test_a_tag_is_read_where_it_is(twin: RenderWorld, distance: float, yaw: float) -> None:
    body = item(yaw)
    twin.set_scene((body,))
    eye = (AT[0] + distance * 0.9, AT[1], AT[2] + distance * 0.44)
    view = View(looking_at(eye, AT), 1280, 720, math.radians(60))
    seen = detect(twin.draw(view).colour)
    assert seen
    truth = true_corners(body, view)
    for number, corners in seen:
        assert number == 29
        # The same corner comes first: neither mirrored nor turned. The pixels' grid is allowed for.
        assert min(np.abs(corners - expected).max() for expected in truth) < 1.6


@pytest.mark.parametrize("yaw", [0.0, 0.5, math.pi])
def test_a_tag_on_a_cylinders_label_is_read_where_it_would_be_on_the_box_about_it(
    twin: RenderWorld, yaw: float
) -> None:
    body = tin(yaw)
    twin.set_scene((body,))
    view = View(looking_at((AT[0] + 0.9, AT[1], AT[2] + 0.44), AT), 1280, 720, math.radians(60))
    seen = detect(twin.draw(view).colour)
    assert seen
    truth = true_corners(body, view)
    assert all(number == 29 for number, _ in seen)
    assert all(min(np.abs(corners - each).max() for each in truth) < 1.6 for _, corners in seen)


def test_a_cylinder_is_round_above_its_labels(twin: RenderWorld) -> None:
    tall = replace(tin(0.0), shape=CylinderShape(radius=SIZE[0] / 2, height=4 * SIZE[2]))
    twin.set_scene((tall,))
    top = AT[2] + 1.7 * SIZE[2]
    view = View(looking_at((AT[0] + 1.0, AT[1], top), (AT[0], AT[1], top)), 320, 180, math.radians(10))
    row = twin.draw(view).depth[90]
    radius = SIZE[0] / 2
    column = 160 + round(0.8 * radius / (1.0 - 0.6 * radius) * view.focal)
    assert row[160] == pytest.approx(1.0 - radius, abs=0.002)
    assert row[column] == pytest.approx(1.0 - 0.6 * radius, abs=0.002)


def test_depth_is_metres_along_the_axis(twin: RenderWorld) -> None:
    twin.set_scene((item(0.0),))
    view = View(looking_at((AT[0] + 1.0, AT[1], AT[2]), AT), 320, 180, math.radians(60))
    depth = twin.draw(view).depth
    assert depth[90, 160] == pytest.approx(1.0 - SIZE[0] / 2, abs=0.002)
    assert np.isinf(depth[0, 0])


def test_what_is_taken_away_is_no_longer_drawn(twin: RenderWorld) -> None:
    twin.set_scene((item(0.0),))
    twin.set_scene(())
    view = View(looking_at((AT[0] + 1.0, AT[1], AT[2]), AT), 1280, 720, math.radians(60))
    assert detect(twin.draw(view).colour) == []
