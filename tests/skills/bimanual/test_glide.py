"""A straight way in bounded time."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.bimanual.glide import Bounds, glide
from tandem.skills.geometry.poses import about, angle_between
from tandem.skills.ports.pose import Pose

START = Pose(position=(0.5, 0.0, 0.9))
BOUNDS = Bounds(speed=0.12, acceleration=0.4, jerk=3.0)


@pytest.mark.parametrize("metres", [0.01, 0.1, 0.5])
def test_speed_acceleration_and_jerk_are_bounded(metres: float) -> None:
    way = glide(START, Pose(position=(0.5, metres, 0.9)), BOUNDS)
    step = way.duration / 2000
    y = np.array([way.at(k * step).position[1] for k in range(2001)])
    derived = [np.diff(y, n) / step**n for n in (1, 2, 3)]
    most = [float(np.max(np.abs(each))) for each in derived]
    limits = (BOUNDS.speed, BOUNDS.acceleration, BOUNDS.jerk)
    assert all(found <= limit * 1.01 for found, limit in zip(most, limits, strict=True))
    assert max(found / limit for found, limit in zip(most, limits, strict=True)) > 0.95
    assert abs(derived[0][0]) + abs(derived[0][-1]) < 1e-3 * BOUNDS.speed


def test_it_turns_the_shorter_way_and_at_the_same_pace() -> None:
    end = Pose(position=(0.7, 0.0, 0.9), orientation=about((0, 0, 1), -1.0))
    way = glide(START, end, BOUNDS)
    middle = way.at(way.duration / 2)
    assert middle.position[0] == pytest.approx(0.6)
    assert angle_between(middle.orientation, about((0, 0, 1), -0.5)) == pytest.approx(0.0, abs=1e-7)
    assert way.at(math.inf) == end
