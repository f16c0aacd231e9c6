"""Hardware with a resting period tells less of a robot that rests, and all of one that moves."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import pybullet
import pytest

from benchmarks.rig import LIFT, Rig
from tandem.sim.rest import STANDS_AFTER
from tandem.sim.scenario import Noise
from tandem.sim.sensor_nodes import RangesNode
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.sensors import CliffSensor, RangeReading

PERIOD, RESTING = 0.01, 0.05
SETTLED = round(STANDS_AFTER / PERIOD) + 10


class Heard(Rig):
    """A rig that notes when clock and joints were told."""

    def __init__(self, resting_period: float | None) -> None:
        super().__init__(friction=None, resting_period=resting_period)
        self.clock = keys.Latest(self.bus, keys.CLOCK, depth=1024)
        self.joints = keys.Latest(self.bus, keys.JOINT_STATES, depth=1024)

    def steps(self, ticks: int) -> tuple[set[float], set[float]]:
        """Let periods pass; return the seconds between clocks, and between joint states."""
        self.clock.take()
        self.joints.take()
        self.ticks(ticks)
        stamps = [[each.stamp.seconds for each in latest.take()] for latest in (self.clock, self.joints)]
        clock, joints = ({round(b - a, 3) for a, b in pairwise(row)} for row in stamps)
        return clock, joints


class Down:
    """A cliff sensor over an even floor."""

    sensor = CliffSensor(name="front", frame="front", period=2 * PERIOD, range_max=0.3, lead=0.1)

    def measure(self) -> float:
        return 0.05


@pytest.fixture
def heard() -> Iterator[Heard]:
    made = Heard(RESTING)
    made.ticks(SETTLED)
    yield made
    made.close()


def test_at_rest_it_tells_once_a_resting_period(heard: Heard) -> None:
    assert heard.steps(50) == ({RESTING}, {RESTING})


def test_a_goal_is_told_at_the_full_rate_from_its_first_period(heard: Heard) -> None:
    heard.send("arm_left", heard.goal("arm_left", LIFT, 1.0))
    assert heard.steps(50) == ({PERIOD}, {PERIOD})


def test_a_base_that_drives_is_told_at_the_full_rate(heard: Heard) -> None:
    keys.BASE_VELOCITY.publish(heard.bus, BaseVelocity(linear=0.2, angular=0.0))
    heard.ticks(1)
    assert heard.steps(20) == ({PERIOD}, {PERIOD})


def test_a_robot_that_is_pushed_does_not_rest(heard: Heard) -> None:
    pybullet.applyExternalForce(
        heard.body.body, -1, (4000.0, 0.0, 0.0), (0.0, 0.0, 0.1), pybullet.LINK_FRAME, heard.physics.client
    )
    assert PERIOD in heard.steps(10)[1]


def test_range_and_cliff_sensors_rest_with_it(heard: Heard) -> None:
    stamps: list[float] = []

    def tell(now: RobotTime, _: tuple[RangeReading, ...]) -> None:
        stamps.append(now.seconds)

    sensors, dice = (RangesNode((Down(),), tell),), np.random.default_rng(1)
    heard.hardware.restart(heard.body, boot="again", noise=Noise(), rng=dice, sensors=sensors)
    heard.ticks(SETTLED)
    stamps.clear()
    heard.ticks(20)
    assert {round(b - a, 3) for a, b in pairwise(stamps)} == {RESTING}
    stamps.clear()
    heard.send("arm_left", heard.goal("arm_left", LIFT, 1.0))
    heard.ticks(20)
    assert {round(b - a, 3) for a, b in pairwise(stamps)} == {2 * PERIOD}


def test_without_a_resting_period_nothing_differs() -> None:
    rig = Heard(None)
    rig.ticks(SETTLED)
    assert rig.steps(20) == ({PERIOD}, {PERIOD})
    rig.close()
