"""The Pioneer's sonars are where its maker says, and look outwards all around."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tandem.sim.robots.p3dx import SONARS
from tandem.sim.robots.registry import robot_model
from tandem.skills.geometry.chain import Chain


@pytest.mark.parametrize("number", range(16))
def test_a_sonar_sits_at_its_place_and_looks_along_x(number: int) -> None:
    description = robot_model("p3dx").description
    sensor = description.range_sensors[number]
    pose = Chain.from_urdf(description.urdf, description.base_frame, sensor.frame).pose({})
    x, y, heading = SONARS[number]
    assert pose.position[:2] == pytest.approx((x / 1000, y / 1000), abs=1e-6)
    _, _, qz, qw = pose.orientation
    assert 2 * math.atan2(qz, qw) == pytest.approx(math.radians(heading), abs=1e-6)


def test_left_and_right_mirror_each_other() -> None:
    places = np.array(SONARS)
    mirrored = places * (1, -1, -1)
    assert {tuple(each) for each in places.tolist()} == {tuple(each) for each in mirrored.tolist()}


def test_their_cones_leave_no_gap_before_the_robot() -> None:
    """Between -65 and 65 degrees, as headings go."""
    half = math.degrees(robot_model("p3dx").description.range_sensors[0].cone) / 2
    front = sorted(heading for _, _, heading in SONARS if abs(heading) <= 50)
    gaps = [later - earlier - 2 * half for earlier, later in pairwise(front)]
    assert max(gaps) <= 0
