"""The base's controller and odometry, without physics."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.sim.base import BaseController, Odometer
from tandem.sim.robots.pmb2 import DRIVE, WHEELS
from tandem.sim.scenario import Noise
from tandem.skills.ports.hardware import BaseVelocity

PERIOD = 0.01


def test_a_command_is_cut_to_the_limits_and_reached_within_the_acceleration() -> None:
    base = BaseController(DRIVE, WHEELS, (0.0, 0.0))
    speeds = []
    for _ in range(300):
        base.command(BaseVelocity(linear=5.0, angular=0.0))
        base.advance(PERIOD, (0.0, 0.0))
        speeds.append(base.linear)
    assert speeds[-1] == pytest.approx(1.0)
    assert max(np.diff(speeds)) <= 0.5 * PERIOD + 1e-9
    for _ in range(300):
        base.command(BaseVelocity(linear=-5.0, angular=0.0))
        base.advance(PERIOD, (0.0, 0.0))
    assert base.linear == pytest.approx(-0.2)


def test_without_fresh_commands_it_stops() -> None:
    base = BaseController(DRIVE, WHEELS, (0.0, 0.0))
    base.command(BaseVelocity(linear=0.1, angular=0.0))
    history = []
    for _ in range(80):
        base.advance(PERIOD, (0.0, 0.0))
        history.append(base.linear)
    assert max(history) == pytest.approx(0.1)
    assert history[int(DRIVE.dead_man / PERIOD) + 22] == 0.0


def _drive(noise: Noise, left: float, right: float) -> Odometer:
    odometer = Odometer(WHEELS, (0.0, 0.0), noise, np.random.default_rng(3))
    for step in range(1, 1001):
        odometer.update(PERIOD, (left * step / 1000, right * step / 1000))
    return odometer


def test_ideal_odometry_is_the_way_of_the_wheels() -> None:
    """A circle: both wheels roll r (d ± b/2) phi."""
    turn, radius = math.pi / 2, 1.0
    left, right = ((radius + side * WHEELS.track / 2) * turn / WHEELS.radius for side in (-1, 1))
    pose = _drive(Noise(), left, right).pose
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((1.0, 1.0, turn), abs=1e-5)


def test_noisy_odometry_is_wrong_by_the_scale_and_the_same_for_the_same_seed() -> None:
    noise = Noise(odometry_scale=0.02, odometry_drift=0.01)
    angle = 10.0 / WHEELS.radius
    first, second = (_drive(noise, angle, angle).pose for _ in range(2))
    assert first == second
    assert math.hypot(first.x, first.y) == pytest.approx(10.2, rel=2e-3)
    assert first.yaw != 0.0
