"""CHOMP and STOMP with a round robot among discs, and what CHOMP does not get out of."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills.arm.optimising.chomp import Chomp
from tandem.skills.arm.optimising.obstacle_cost import hinge
from tandem.skills.arm.optimising.settings import ChompSettings, StompSettings
from tandem.skills.arm.optimising.smoothness import smoothness
from tandem.skills.arm.optimising.stomp import Stomp, probabilities
from tandem.skills.kinematics.transforms import Array
from tests.skills.arm.optimising.rig import BOUNDS, Disc, clearance, cost

FORM = smoothness(30)
START, END = np.array([-1.0, 0.0]), np.array([1.0, 0.0])
ONE = (0.0, 0.05, 0.3)
HEAD_ON = (0.0, 0.0, 0.3)
"""Right in the way: nothing pushes to either side."""


def chomp(*discs: Disc) -> Chomp:
    return Chomp(FORM.smoothest(START, END), FORM, cost(*discs), BOUNDS, ChompSettings())


def stomp(*discs: Disc, seed: int = 1) -> Stomp:
    begun = FORM.smoothest(START, END)
    return Stomp(begun, FORM, cost(*discs), BOUNDS, StompSettings(), np.random.default_rng(seed))


BOTH = pytest.mark.parametrize("make", [chomp, stomp])
Make = Callable[..., Chomp | Stomp]


def run(optimiser: Chomp | Stomp, iterations: int) -> Array:
    for _ in range(iterations):
        for _ in optimiser.advance():
            pass
    return optimiser.path


def length(path: Array) -> float:
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


@BOTH
def test_around_a_disc(make: Make) -> None:
    path = run(make(ONE), 100)
    assert clearance(path, ONE) > 0.0
    assert np.array_equal(path[[0, -1]], [START, END])
    assert path[15, 1] < 0.0, "below the disc, whose centre is above the straight line"
    assert 2.08 < length(path) < 2.6  # two tangents of 0.937 and an arc of 0.35 * 0.61


@BOTH
def test_nothing_around_leaves_the_straight_line(make: Make) -> None:
    path = run(make((0.0, 3.0, 0.1)), 60)
    assert np.max(np.abs(path[:, 1])) < 0.2
    assert length(path) < 2.1


def test_stomp_gets_around_what_chomp_stays_before() -> None:
    assert clearance(run(chomp(HEAD_ON), 150), HEAD_ON) < 0.0
    assert clearance(run(stomp(HEAD_ON), 150), HEAD_ON) > 0.0


def test_the_cost_does_not_depend_on_how_fast_the_path_goes() -> None:
    share = np.linspace(0.0, 1.0, 402)[:, None]
    even, hurried = START + share * (END - START), START + share**2 * (END - START)
    both = cost(ONE).costs(np.stack((even, hurried))).sum(axis=1)
    assert both[0] == pytest.approx(both[1], rel=0.01)


def test_the_gradient_is_the_costs_own() -> None:
    # Many points, so that sums are near integrals; a bump across, as one along changes nothing.
    form = smoothness(300)
    path = form.smoothest(START, END)
    path[:, 1] += 0.05 * np.sin(np.linspace(0.0, np.pi, 302)) ** 2
    bump = np.zeros_like(path)
    bump[100:201, 1] = np.sin(np.linspace(0.0, np.pi, 101)) ** 2
    around = cost(ONE)
    change = [around.costs((path + h * bump)[None]).sum() for h in (1e-5, -1e-5)]
    slope = (change[0] - change[1]) / 2e-5
    assert np.sum(around.gradient(path) * bump[1:-1]) == pytest.approx(slope, rel=0.02)


def test_nearness_costs_more_and_more_from_the_margin_on() -> None:
    gaps = np.array([0.2, 0.1, 0.05, 0.0, -0.1])
    values, slopes = hinge(gaps, 0.1)
    assert np.allclose(values, [0.0, 0.0, 0.0125, 0.05, 0.15])
    ahead, behind = hinge(gaps + 1e-7, 0.1)[0], hinge(gaps - 1e-7, 0.1)[0]
    assert np.allclose(slopes, (ahead - behind) / 2e-7, atol=1e-5)


def test_cheap_rollouts_get_the_shares() -> None:
    share = probabilities(np.array([[0.0, 5.0], [1.0, 5.0], [0.5, 5.0]]), 10.0)
    assert np.allclose(share.sum(axis=0), 1.0)
    assert np.allclose(share[:, 0], np.exp([0.0, -10.0, -5.0]) / np.exp([0.0, -10.0, -5.0]).sum())
    assert np.allclose(share[:, 1], 1.0 / 3.0)


def test_cheap_rollouts_are_remembered_until_a_way_is_found() -> None:
    quiet = StompSettings(noise=1e-9, kept=6)
    start = FORM.smoothest(START, END)
    loud = Stomp(start, FORM, cost(ONE), BOUNDS, StompSettings(kept=6), np.random.default_rng(1))
    run(loud, 1)
    forgetful = Stomp(loud.path, FORM, cost(ONE), BOUNDS, quiet, np.random.default_rng(2))
    loud.settings = quiet
    before = loud.path
    loud._sigma = forgetful._sigma
    moved, stayed = run(loud, 1), run(forgetful, 1)
    assert np.max(np.abs(moved - before)) > 1e-3
    assert np.max(np.abs(stayed - before)) < 1e-6
    loud.settle()
    assert np.max(np.abs(run(loud, 1) - moved)) < 1e-6


def test_a_seed_gives_one_path() -> None:
    assert np.array_equal(run(stomp(ONE), 20), run(stomp(ONE), 20))
    assert not np.array_equal(run(stomp(ONE), 20), run(stomp(ONE, seed=2), 20))


def test_work_comes_in_slices() -> None:
    slices = list(stomp(ONE).advance())
    assert len(slices) == 6  # twelve rollouts, two at once
    assert max(*slices, *chomp(ONE).advance()) <= 100
