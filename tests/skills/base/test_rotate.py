"""Turning on the spot."""

import math

import pytest

from tandem.skills.base.wheels import Wheels
from tandem.skills.base.wheels_run import Ride
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import RotateFeedback, RotateGoal
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import Command
from tandem.skills.site import load
from tests.fakes.base_rig import make_rig

START = FloorPose(x=-1.0, y=-1.6, yaw=0.4)


@pytest.mark.parametrize("angle", [math.pi / 2, -math.pi / 6, math.pi, -2 * math.pi, 0.0])
def test_it_turns_by_the_angle_whole_turns_too(angle: float) -> None:
    rig = make_rig(load("lab"), START)
    outcome = rig.run(rig.base.rotate.run(RotateGoal(angle=angle), "g"))
    assert outcome.result is not None
    assert outcome.result.turned == pytest.approx(angle, abs=0.02)
    assert wrap(rig.robot.truth.yaw - START.yaw - angle) == pytest.approx(0.0, abs=0.02)


def test_a_right_angle_takes_little_more_than_the_drives_limits_allow() -> None:
    rig = make_rig(load("lab"), START)
    start = rig.now
    rig.run(rig.base.rotate.run(RotateGoal(angle=math.pi / 2), "g"))
    assert rig.now - start < 2.5 + 0.4


def test_it_stands_still_only_until_a_scan_has_been_taken_from_there() -> None:
    rig = make_rig(load("lab"), START)
    clocks = rig.robot.clocks
    wheels = Wheels(rig.bus, clocks, rig.base.drive.course.drive, lambda: lambda: True)
    told = RotateFeedback(remaining=0.0)
    ride = Ride(clocks, rig.base.localiser, wheels, feedback=lambda: told, where="test")
    rig.wait(0.2)
    start = rig.now
    for _ in ride.settle_seen(1.0):
        rig.tick()
    assert 0.0 < rig.now - start < 0.2  # the fake scans every 0.1 s


def test_cancelled_it_stands_still_at_its_end() -> None:
    rig = make_rig(load("lab"), START)
    outcome = rig.run(
        rig.base.rotate.run(RotateGoal(angle=3.0), "g"),
        lambda t: Command.CANCEL if t > 1.0 else Command.GO_ON,
    )
    assert outcome.canceled
    assert rig.robot.angular == 0.0
