"""The potentials of the two-arm thesis, 2.4, against finite differences."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.field.potential import Gains, attraction, pull, push, repulsion, standoff_gain

STEP = 1e-6


def test_the_gradient_of_attraction_is_that_of_its_potential() -> None:
    rng = np.random.default_rng(1)
    for _ in range(20):
        p, pole = rng.normal(size=3), rng.normal(size=3)
        gradient = attraction(p, pole, 3.0)[1]
        for axis in np.eye(3):
            ahead, behind = (attraction(p + sign * STEP * axis, pole, 3.0)[0] for sign in (1.0, -1.0))
            assert gradient @ axis == pytest.approx((ahead - behind) / (2.0 * STEP), abs=1e-6)


def test_the_gradient_of_repulsion_is_that_of_its_potential() -> None:
    rho = np.linspace(0.01, 0.12, 23)
    slope = repulsion(rho, 0.10, 2e-5)[1]
    ahead, behind = (repulsion(rho + sign * STEP, 0.10, 2e-5)[0] for sign in (1.0, -1.0))
    assert np.allclose(slope, (ahead - behind) / (2.0 * STEP), rtol=1e-4, atol=1e-6)


def test_repulsion_ends_at_its_limit_distance_and_stays_finite() -> None:
    potential, slope = repulsion(np.array([0.10, 0.2, 0.0, -0.01]), 0.10, 2e-5)
    assert potential[:2].tolist() == slope[:2].tolist() == [0.0, 0.0]
    assert np.isfinite(slope).all()


def test_push_and_pull_cancel_at_the_standoff() -> None:
    gains = Gains()
    goal = np.array([0.5, 0.0, 0.0])
    drawn = pull(np.zeros(3), goal, 0.5, gains.goal, gains)
    pushed = push(np.array([gains.standoff]), np.array([[-1.0, 0.0, 0.0]]), 0.5, gains)
    assert np.allclose(drawn + pushed, 0.0, atol=1e-9)
    assert gains.push == standoff_gain(gains.cruise, gains.standoff, gains.influence)


def test_a_pull_is_constant_far_away_and_can_brake_near_by() -> None:
    gains = Gains()
    goal = np.zeros(3)
    for away, most in ((2.0, gains.cruise), (0.5, gains.cruise), (0.06, np.sqrt(2.0 * gains.braking * 0.06))):
        p = np.array([away, 0.0, 0.0])
        assert np.linalg.norm(pull(p, goal, away, gains.goal, gains)) == pytest.approx(most)
