"""A sensor that says nothing is silent; while the robot rests, its hardware says things less often."""

from __future__ import annotations

import pytest

from tandem.skills.base.ranger import SILENT, Ranger
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import CliffSensor

PERIOD, RESTING = 0.02, 0.1


@pytest.mark.parametrize(("resting", "heard_until"), [(0.0, SILENT * PERIOD), (RESTING, SILENT * RESTING)])
def test_it_is_deaf_after_some_periods_without_a_reading(resting: float, heard_until: float) -> None:
    sensor = CliffSensor(name="front", frame="front", range_max=0.3, lead=0.1, period=PERIOD)
    ranger = Ranger(sensor, FloorPose(x=0.1, y=0.0, yaw=0.0))
    ranger.hear(0.05, RobotTime(boot="a", seconds=1.0), moving=False)
    deaf = [
        ranger.is_deaf(RobotTime(boot="a", seconds=1.0 + age), resting)
        for age in (heard_until - 0.01, heard_until + 0.01)
    ]
    assert deaf == [False, True]
