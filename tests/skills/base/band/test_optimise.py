"""Bands are pulled tight within the drive's limits, clear of things, behind people."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.sim.robots.locobot import DRIVE
from tandem.skills.base.band.judge import may_be_driven
from tandem.skills.base.band.limits import Task
from tandem.skills.base.band.optimise import optimise
from tandem.skills.base.band.routes import along
from tandem.skills.base.band.terms import terms
from tandem.skills.base.band.timed import Bands, motion
from tests.skills.base.band.tasks import NEEDED, WAY, done, post, task
from tests.skills.base.people.test_keeping_away import track


def pulled(made: Task, steps: int = 25) -> Bands:
    return done(optimise(along(WAY, made), made, steps))[0]


def shaken(made: Task, seed: int, by: float = 0.05) -> Bands:
    rng, first = np.random.default_rng(seed), along(WAY, made)
    return Bands(
        first.poses + rng.normal(0.0, by, first.poses.shape),
        first.times * rng.uniform(0.7, 1.3, first.times.shape),
    )


def test_derivatives_are_those_of_the_terms() -> None:
    made = task(track(1.2, -1.0, 0.0, 0.7), field=post(1.0, 0.1), stops=True)
    bands, tiny = shaken(made, 1), 1e-6
    values, slopes = terms(bands, made)
    for row, number in ((0, 3), (1, 5), (2, 7), (3, 4)):
        poses, times = bands.poses.copy(), bands.times.copy()
        if row < 3:
            poses[0, number, row] += tiny
        else:
            times[0, number] += tiny
        measured = (terms(Bands(poses, times), made)[0] - values)[0] / tiny
        told = slopes[0, :, row * (WAY.shape[0] - 6) + number]
        assert told == pytest.approx(measured, abs=0.01)


def test_alone_a_band_is_straight_quick_and_within_the_limits() -> None:
    made = task(linear=0.0, stops=True)
    band = pulled(made)
    how = motion(band)
    assert may_be_driven(band, made).all()
    assert abs(band.poses[0, :, 1]).max() < 0.01
    assert how.linear.max() <= DRIVE.forward
    # 0 to 0.7 m/s and back with 0.5 m/s2 take 4.26 s for 2 m.
    assert 4.2 < band.lasts[0] < 4.9


def test_a_thing_is_cleared_by_what_a_plan_needs() -> None:
    made = task(field=post(1.0, 0.2))
    assert not may_be_driven(along(WAY, made), made).any()
    band = pulled(made)
    assert may_be_driven(band, made).all()
    assert np.hypot(band.poses[0, :, 0] - 1.0, band.poses[0, :, 1] - 0.2).min() > NEEDED - 0.02


def test_somebody_who_walks_across_is_passed_behind() -> None:
    made = task(track(1.2, -1.0, 0.0, 0.7))
    band = pulled(made)
    assert may_be_driven(band, made).all()
    moments, x = band.moments[0], band.poses[0, :, 0]
    there = float(np.interp(1.2, x, moments))
    walked = -1.0 + 0.7 * there
    assert walked > float(np.interp(1.2, x, band.poses[0, :, 1]))


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000), x=st.floats(0.6, 2.5), y=st.floats(-1.0, 1.0), speed=st.floats(-1.2, 1.2))
def test_steps_never_make_it_worse_and_leave_both_ends(seed: int, x: float, y: float, speed: float) -> None:
    made = task(track(x, y, 0.0, speed), field=post(1.1, -0.4))
    first = shaken(made, seed)
    before = (terms(first, made)[0] ** 2).sum()
    band, cost = done(optimise(first, made, 5))
    assert cost[0] <= before
    assert np.isfinite(band.poses).all()
    assert (band.times > 0.0).all()
    assert band.poses[0, 0] == pytest.approx(first.poses[0, 0])
    assert band.poses[0, -1, :2] == pytest.approx(first.poses[0, -1, :2])


@pytest.mark.parametrize("wrong", ["fast", "sideways", "through", "person", "jerk"])
def test_what_breaks_a_limit_may_not_be_driven(wrong: str) -> None:
    made = task(linear=0.56)
    if wrong == "through":
        made = task(field=post(1.0, 0.0), linear=0.56)
    if wrong == "person":
        made = task(track(1.0, 0.0, 0.0, 0.0), linear=0.56)
    band = along(WAY, made)
    poses, times = band.poses.copy(), band.times.copy()
    if wrong == "fast":
        times *= 0.6
    if wrong == "sideways":
        poses[0, 5:, 1] += 0.1
    if wrong == "jerk":
        times[0, 6] *= 4.0
    assert may_be_driven(band, task(linear=0.56)).all()
    assert not may_be_driven(Bands(poses, times), made).any()
