"""Ramps keep all limits, arrive, and take no longer than the limits' own times allow."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tandem.skills.perception.ramp import rest_to_rest
from tandem.skills.ports.robot_description import JointLimit


def limit(velocity: float, acceleration: float, jerk: float) -> JointLimit:
    return JointLimit(
        joint="j",
        lower=-3,
        upper=3,
        velocity=velocity,
        acceleration=acceleration,
        jerk=jerk,
        effort=1,
    )


LIMITS = (limit(3.0, 5.0, 50.0), limit(1.0, 2.0, 10.0))


@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
def test_limits_are_kept_between_the_points(one: float, two: float) -> None:
    points = rest_to_rest((0.1, -0.1), (0.1 + one, -0.1 + two), LIMITS)
    assert points[-1].positions == pytest.approx((0.1 + one, -0.1 + two))
    for a, b in pairwise(points):
        h = b.time - a.time
        for i, bounds in enumerate(LIMITS):
            # The cubic between the points, as the hardware draws it.
            rise = (b.positions[i] - a.positions[i]) / h
            start = 2 * (3 * rise - 2 * a.velocities[i] - b.velocities[i]) / h
            end = 2 * (a.velocities[i] + 2 * b.velocities[i] - 3 * rise) / h
            assert abs(b.velocities[i]) <= bounds.velocity * 1.001
            assert max(abs(start), abs(end)) <= bounds.acceleration * 1.001 + 1e-5
            assert abs(end - start) / h <= bounds.jerk * 1.001 + 1e-3


def test_a_small_motion_takes_the_time_of_its_jerk() -> None:
    points = rest_to_rest((0.0,), (0.05,), (limit(10.0, 10.0, 50.0),))
    assert points[-1].time == pytest.approx((32 * 0.05 / 50) ** (1 / 3))


def test_a_long_motion_cruises() -> None:
    points = rest_to_rest((0.0,), (2.0,), (limit(0.5, 5.0, 50.0),))
    assert points[-1].time == pytest.approx(2.0 / 0.5 + 0.5 / 5.0 + 5.0 / 50.0)
    assert np.max([point.velocities for point in points]) == pytest.approx(0.5)


def test_no_way_is_one_point() -> None:
    assert len(rest_to_rest((0.3,), (0.3,), LIMITS[:1])) == 1
