"""The map against distances worked out by hand, and its chain against the URDF's numbers."""

import math

import numpy as np
import pytest

from tandem.skills.base.map import build_map, clearance_field, surface_field
from tandem.skills.ports.site import SiteBox
from tandem.skills.site import load
from tests.fakes.planar_robot import describe

BOUNDS = (-1.0, -1.0, 1.0, 1.0)


def box(
    x: float, y: float, *, size: tuple[float, float, float] = (0.4, 0.2, 1.0), yaw: float = 0.0
) -> SiteBox:
    return SiteBox(size=size, centre=(x, y, 0.5), yaw=yaw)


def test_clearance_is_the_distance_to_the_nearest_box_or_to_the_floors_end() -> None:
    field = clearance_field([box(0.0, 0.0)], BOUNDS)
    assert field.at_point(0.5, 0.0) == pytest.approx(0.3, abs=1e-6)
    assert field.at_point(0.5, 0.5) == pytest.approx(math.hypot(0.3, 0.4), abs=2e-3)
    assert field.at_point(0.0, 0.9) == pytest.approx(0.1, abs=1e-6)


def test_a_turned_box_is_met_where_it_is() -> None:
    field = clearance_field([box(0.0, 0.0, yaw=math.pi / 2)], BOUNDS)
    assert field.at_point(0.5, 0.0) == pytest.approx(0.4, abs=1e-6)


def test_inside_touching_boxes_only_the_visible_face_counts() -> None:
    # A panel of 2 cm before a wall of 10 cm: a point in the wall is drawn back to the panel's face.
    wall = box(0.0, 1.05, size=(2.4, 0.1, 1.0))
    panel = box(0.0, 0.99, size=(1.0, 0.02, 1.0))
    field = surface_field([wall, panel], BOUNDS)
    assert field.at_point(0.0, 1.08) == pytest.approx(-0.10, abs=3e-3)
    assert field.at_point(-0.8, 1.08) == pytest.approx(-0.08, abs=3e-3)
    assert field.at_point(0.0, 0.9) == pytest.approx(0.08, abs=1e-6)


def test_the_gradient_points_away_from_the_surface() -> None:
    _, gradient = surface_field([box(0.0, 0.0)], BOUNDS).with_gradient(
        np.array([[0.51, 0.01], [0.01, -0.51]])
    )
    assert gradient == pytest.approx(np.array([[1.0, 0.0], [0.0, -1.0]]), abs=1e-6)


def test_the_laser_sees_legs_where_the_plan_has_the_whole_table() -> None:
    site_map = build_map(load("lab"), describe())
    assert site_map.laser_in_base.x == pytest.approx(0.202)
    assert site_map.plan.at_point(1.0, 0.5) < 0.0
    assert site_map.laser.at_point(1.0, 0.5) == pytest.approx(math.hypot(0.54, 0.37), abs=5e-3)


def test_a_laser_that_does_not_lie_level_is_refused() -> None:
    tilted = describe().model_copy(
        update={"urdf": describe().urdf.replace('xyz="0.202', 'rpy="0.2 0 0" xyz="0.202')}
    )
    with pytest.raises(ValueError, match="level"):
        build_map(load("lab"), tilted)
