"""Corners that cost a base more time than they are worth are left out, where that is as free."""

from collections.abc import Sequence

import numpy as np
import pytest

from tandem.skills.base.path import Path
from tandem.skills.base.planner import Clearances
from tandem.skills.base.quicker import seconds, without_slow_corners
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive
from tandem.skills.site import load
from tests.fakes.base_rig import make_rig

COURSE = make_rig(load("lab"), FloorPose(x=0.0, y=0.5, yaw=0.0)).base.drive.course
DRIVE: Drive = COURSE.drive
AT_TABLE = FloorPose(x=0.0, y=0.5, yaw=0.0)
ROUND_THE_PILLAR = ((0.0, 0.5), (-0.2, 0.25), (-0.3, -0.7), (-0.8, -1.05), (-1.9, -1.2))
"""As planned from the table to the depot: first a little away from the table."""


def clearances(start: FloorPose) -> Clearances:
    return Clearances(COURSE.site_map.plan, 0.33, start)


def quickest(points: Sequence[tuple[float, float]], start: FloorPose, goal: FloorPose) -> Path:
    path = Path(np.array(points))
    return [*without_slow_corners(path, goal, DRIVE, clearances(start))][-1]


def test_the_corner_close_to_a_table_is_left_out_and_the_pillar_still_gone_round() -> None:
    path = quickest(ROUND_THE_PILLAR, AT_TABLE, FloorPose(x=-1.9, y=-1.2, yaw=3.14))
    assert path.points.tolist() == [list(point) for point in ROUND_THE_PILLAR if point != (-0.2, 0.25)]


def test_a_shorter_way_that_comes_closer_to_things_is_not_taken() -> None:
    around, goal = ((-1.9, -1.2), (-1.45, 0.35), (-0.8, 1.2)), FloorPose(x=-0.8, y=1.2, yaw=1.6)
    assert quickest(around, FloorPose(x=-1.9, y=-1.2, yaw=3.1), goal).points.tolist() == [*map(list, around)]


def test_a_straight_way_takes_what_the_drives_limits_allow() -> None:
    start = FloorPose(x=-2.2, y=1.7, yaw=0.0)
    path = Path(np.array([(-2.2, 1.7), (0.0, 1.7)]))
    assert seconds(path, 0.0, DRIVE, clearances(start)) == pytest.approx(2.2 / 1.0 + 1.0 / 0.5, rel=0.05)
