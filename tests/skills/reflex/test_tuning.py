"""The parameters are found so that no dangerous pair is missed."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.reflex.tuning import Pairs, judge, judge_described, sample, tune
from tests.skills.reflex.two_arms import robot

FACING = Pairs(
    distance=np.array([0.30, 0.10, 0.20, 0.50]),
    turned=np.array([3.0, 0.0, 0.0, 3.0]),
    lowered=np.array([0.0, 0.0, 0.0, 2.0]),
    clearance=np.array([0.01, 0.01, 0.10, 0.30]),
)
"""Two dangerous pairs: turned against each other at 0.3 m, and side by side at 0.1 m."""


def test_an_orientation_that_needs_room_is_given_room() -> None:
    found = tune(FACING, 0.03)
    assert (found.missed, found.false_alarms) == (0.0, 0.0)
    assert found.gamma > 0.0
    assert found.k < 0.2


def test_shares_are_of_the_dangerous_and_of_the_harmless() -> None:
    found = judge(FACING, 0.03, k=0.25, gamma=0.0, mu=0.0)
    assert (found.missed, found.false_alarms) == (0.5, 0.5)


def test_nothing_dangerous_tells_nothing() -> None:
    with pytest.raises(ValueError, match="sample more"):
        tune(FACING, 0.001)


def test_what_the_robot_is_described_with_misses_nothing() -> None:
    """The campaign is ``python -m benchmarks.crossing_tuning``; here are 1600 other pairs."""
    description, hulls = robot()
    assert description.arms_crossing is not None
    pairs = sample(hulls, description, np.random.default_rng(7), 40)
    found = judge_described(pairs, description.arms_crossing)
    assert found.missed == 0.0
    assert found.false_alarms < 0.4
