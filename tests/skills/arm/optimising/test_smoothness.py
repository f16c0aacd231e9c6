"""The smoothness of paths, against finite differences and what is known of clamped splines."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.optimising.first_guess import near, resampled
from tandem.skills.arm.optimising.limits import Bounds
from tandem.skills.arm.optimising.smoothness import smoothness
from tandem.skills.kinematics.transforms import Array

FORM = smoothness(9)
START, END = np.array([0.3, -1.0]), np.array([1.1, 0.5])


def wavy() -> Array:
    path = np.linspace(START, END, 11)
    path[1:-1] += np.random.default_rng(3).normal(0.0, 0.1, (9, 2))
    return path


def by_hand(path: Array) -> float:
    """Half the integral of the squared accelerations, one at a time; it rests before and after."""
    step = 1.0 / (len(path) - 1)
    total = 0.0
    for i in range(len(path)):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        total += 0.5 * step * float(np.sum(((after - 2.0 * path[i] + before) / step**2) ** 2))
    return total


def test_the_cost_is_the_sum_over_the_points() -> None:
    assert FORM.costs(wavy()).sum() == pytest.approx(by_hand(wavy()))


def test_the_gradient_is_that_of_finite_differences() -> None:
    path, found = wavy(), FORM.gradient(wavy())
    for i in range(9):
        for j in range(2):
            ahead, behind = path.copy(), path.copy()
            ahead[i + 1, j] += 1e-5
            behind[i + 1, j] -= 1e-5
            assert found[i, j] == pytest.approx((by_hand(ahead) - by_hand(behind)) / 2e-5, rel=1e-4)


def test_the_matrix_is_the_hessian() -> None:
    path = wavy()
    moved = path.copy()
    moved[1:-1] += np.random.default_rng(4).normal(size=(9, 2))
    assert np.allclose(FORM.gradient(moved) - FORM.gradient(path), FORM.matrix @ (moved - path)[1:-1])


def test_the_smoothest_path_is_straight_and_slow_at_both_ends() -> None:
    fine = smoothness(199)
    share = (fine.smoothest(START, END) - START) / (END - START)
    time = np.linspace(0.0, 1.0, 201)[:, None]
    assert np.allclose(share, 3.0 * time**2 - 2.0 * time**3, atol=0.01)


def test_noise_has_the_covariance_of_the_inverse() -> None:
    drawn = FORM.noise @ np.random.default_rng(5).standard_normal((9, 200_000))
    wanted = FORM.inverse / FORM.inverse.diagonal().max()
    assert np.allclose(np.cov(drawn), wanted, atol=0.02)


def test_the_columns_of_the_smoothing_matrix_peak_at_one_nth() -> None:
    assert np.allclose(FORM.smoothing.max(axis=0), 1.0 / 9.0)


def test_points_are_spread_over_the_length_of_a_polyline() -> None:
    corner = np.array([[0.0, 0.0], [3.0, 0.0], [3.0, 1.0]])
    assert np.allclose(resampled(corner, 5), [[0, 0], [1, 0], [2, 0], [3, 0], [3, 1]])


@pytest.mark.parametrize("follow", [1e-6, 1e12])
def test_a_seed_is_followed_as_closely_as_asked(follow: float) -> None:
    corner = np.array([START, [1.5, -1.5], END])
    wanted = FORM.smoothest(START, END) if follow < 1.0 else resampled(corner, 11)
    assert np.allclose(near(corner, FORM, follow), wanted, atol=1e-4)


def test_what_is_beyond_the_limits_comes_back_and_the_ends_stay() -> None:
    bounds = Bounds(np.array([-0.2, -1.5]), np.array([1.2, 1.5]))
    path = FORM.smoothest(START, END)
    path[:, 0] += 0.6 * np.sin(np.linspace(0.0, np.pi, 11)) ** 2
    back = bounds.bring_back(path, FORM)
    assert np.all(back[1:-1] >= bounds.lower)
    assert np.all(back[1:-1] <= bounds.upper)
    assert np.array_equal(back[[0, -1]], path[[0, -1]])
    assert np.array_equal(back[:, 1], path[:, 1]), "a joint within its limits is left alone"
    cut = np.clip(path, bounds.lower, bounds.upper)
    assert by_hand(back) < by_hand(cut), "bent rather than cut off"
