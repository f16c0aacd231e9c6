"""The end of a way to a pose: laid aside by as much as the turn there carries the base back."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tandem.skills.base.ending import laid_aside, swerve
from tandem.skills.base.path import Path
from tandem.skills.base.planner import Clearances
from tandem.skills.base.wheels import stopping_speed
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tests.fakes.base_rig import make_rig

LAB = load("lab")
START = FloorPose(x=-1.0, y=-1.6, yaw=0.0)
COURSE = make_rig(LAB, START).base.drive.course
OPEN = Clearances(COURSE.site_map.plan, 0.3, START)
AHEAD = Path(np.array([(-1.0, -1.6), (0.5, -1.6)]))


def end(yaw: float) -> FloorPose:
    return FloorPose(x=0.5, y=-1.6, yaw=yaw)


def test_a_turn_on_the_last_half_second_carries_aside_as_the_integral_says() -> None:
    drive, seconds = COURSE.drive, 0.5
    left = drive.acceleration * seconds**2 / 2
    aside = swerve(left, stopping_speed(left, drive.acceleration, 0.05), 1.5, drive)
    bound = drive.acceleration * drive.turn_acceleration * seconds**4 / 24
    assert bound < aside < 3 * bound, "the latency makes the way last longer"


def test_turned_away_or_turning_away_it_is_carried_less() -> None:
    plain = swerve(0.3, 0.5, 1.5, COURSE.drive)
    assert swerve(0.3, 0.5, 1.5, COURSE.drive, off=-0.05) < plain
    assert swerve(0.3, 0.5, 1.5, COURSE.drive, rate=-0.2) < plain


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_way_ends_beside_its_goal_on_the_other_side_than_it_turns_to(side: float) -> None:
    path = laid_aside(AHEAD, end(side * 1.5), COURSE.drive, OPEN)
    assert path.points[-1][0] == pytest.approx(0.5)
    assert 0.03 < -side * (path.points[-1][1] + 1.6) < 0.08


def test_without_room_or_a_turn_or_a_run_up_it_ends_where_it_did() -> None:
    narrow = replace(OPEN, needed=OPEN.field.at_point(0.5, -1.6))
    short = Path(np.array([(0.0, -1.6), (0.5, -1.6)]))
    assert laid_aside(AHEAD, end(0.1), COURSE.drive, OPEN) is AHEAD
    assert laid_aside(short, end(1.5), COURSE.drive, OPEN) is short
    assert any(laid_aside(AHEAD, end(yaw), COURSE.drive, narrow) is AHEAD for yaw in (1.5, -1.5))


def test_a_base_that_creeps_would_have_turned_round_before_it_is_there() -> None:
    assert math.isinf(swerve(0.6, 0.05, 3.0, COURSE.drive))
