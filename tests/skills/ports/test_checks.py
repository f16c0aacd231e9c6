"""Numbers that no robot tells are refused, wherever in a message they stand."""

from __future__ import annotations

import math

import pytest

from tandem.skills.ports.checks import LARGEST, LONGEST, too_large
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.sensors import LaserScan

NOW = RobotTime(boot="b", seconds=1.0)
RANGES = (1.0, 2.0, 3.0)


def scan(*ranges: float, stamp: RobotTime = NOW) -> LaserScan:
    return LaserScan.model_construct(stamp=stamp, ranges=ranges)


@pytest.mark.parametrize("wrong", [LARGEST * 2, -LARGEST * 2, math.inf, math.nan])
@pytest.mark.parametrize("place", range(4))
def test_one_number_among_many_is_found(wrong: float, place: int) -> None:
    assert too_large(scan(*RANGES[:place], wrong, *RANGES[place:]))


def test_what_robots_tell_passes() -> None:
    assert not too_large(scan(*RANGES))
    assert not too_large(scan())
    assert not too_large((1.0, 2, "three", None))


def test_a_time_may_be_larger_than_a_length_and_not_without_bounds() -> None:
    assert not too_large(scan(*RANGES, stamp=RobotTime(boot="b", seconds=LARGEST * 2)))
    assert too_large(scan(*RANGES, stamp=RobotTime(boot="b", seconds=LONGEST * 2)))
