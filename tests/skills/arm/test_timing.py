"""Timing: within the limits, on the path, and not much slower than the bang-bang bound."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.curve import through
from tandem.skills.arm.timing import bang_bang, time_curve, time_path
from tandem.skills.arm.trajectory import MotionLimits, Trajectory

LIMITS = MotionLimits(np.array([1.95, 1.95, 2.35, 1.76]), np.full(4, 5.0), np.full(4, 50.0))


def worst(trajectory: Trajectory) -> tuple[float, float, float]:
    """Return velocity, acceleration and jerk over their limits, by differences."""
    step = 0.02
    q = trajectory.sample(np.arange(0.0, trajectory.duration, step))
    v = np.diff(q, axis=0) / step
    a = np.diff(v, axis=0) / step
    j = np.diff(a, axis=0) / step
    return (
        float(np.max(np.abs(v) / LIMITS.velocity)),
        float(np.max(np.abs(a) / LIMITS.acceleration)),
        float(np.max(np.abs(j) / LIMITS.jerk)),
    )


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("blend", [0.0, 0.5, 1.0])
def test_limits_hold(seed: int, blend: float) -> None:
    path = np.random.default_rng(seed).uniform(-1.0, 1.0, (2 + seed % 3, 4))
    trajectory = time_path(path, LIMITS, blend)
    velocity, acceleration, jerk = worst(trajectory)
    assert velocity < 1.01
    assert acceleration < 1.03
    assert jerk < 1.35  # third differences of cubic splines overshoot where the jerk jumps
    assert np.allclose(trajectory.positions[[0, -1]], path[[0, -1]])
    assert np.allclose(trajectory.velocities[[0, -1]], 0.0)
    assert np.all(np.diff(trajectory.times) > 0.0)


def test_a_straight_motion_is_near_the_bound_and_on_the_line() -> None:
    a, b = np.zeros(4), np.array([1.0, -0.5, 0.7, 0.2])
    trajectory = time_path(np.array([a, b]), LIMITS)
    assert trajectory.duration < 1.2 * bang_bang(a, b, LIMITS)
    share = trajectory.positions[:, :1] / b[0]
    assert np.allclose(trajectory.positions, share * b, atol=1e-9)


def test_without_blending_it_stops_in_each_waypoint() -> None:
    path = np.array([[0.0, 0, 0, 0], [1.0, 0, 0, 0], [1.0, 1, 0, 0]])
    stops = time_path(path, LIMITS, 0.0)
    dense = stops.sample(np.linspace(0.0, stops.duration, 2000))
    assert np.min(np.linalg.norm(dense - path[1], axis=1)) < 1e-3
    assert time_path(path, LIMITS, 1.0).duration < stops.duration


def test_a_blended_corner_stays_within_the_two_segments() -> None:
    path = np.array([[0.0, 0, 0, 0], [1.0, 0, 0, 0], [1.0, 1, 0, 0]])
    dense = time_path(path, LIMITS, 1.0).sample(np.linspace(0.0, 3.0, 500))
    assert np.all((dense[:, :2] > -1e-4) & (dense[:, :2] < 1.0 + 1e-4))


def test_a_curve_keeps_the_limits_and_ends_at_rest() -> None:
    x = np.linspace(0.0, 1.0, 12)[:, None]
    path = 0.3 * np.sin(x * np.array([0.5, 1.0, 1.5, 2.0]))
    trajectory = time_curve(through(path), LIMITS)
    velocity, acceleration, jerk = worst(trajectory)
    assert velocity < 1.01
    assert acceleration < 1.03
    assert jerk < 1.35
    assert np.allclose(trajectory.positions[-1], path[-1])


def test_a_short_line_of_the_hand_takes_what_the_joints_allow() -> None:
    x = np.linspace(0.0, 1.0, 20)[:, None]
    trajectory = time_curve(through(np.hstack((0.3 * x, 0.2 * x**1.5, 0.2 * x**2, 0.1 * x))), LIMITS)
    _, acceleration, jerk = worst(trajectory)
    assert max(acceleration, jerk) > 0.85


def test_nowhere_to_go_takes_no_time() -> None:
    assert time_path(np.zeros((2, 4)), LIMITS).duration == 0.0
