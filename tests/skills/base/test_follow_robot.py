"""Following another robot on a planar SUMMIT-XL, which sees ahead only."""

from __future__ import annotations

import math

import pytest

from tandem.skills.base.map import floor_field
from tandem.skills.base.sights import Sight
from tandem.skills.base.way_back import WayBack
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.base import FOLLOW, FollowGoal, FollowSource
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import RobotWhereabouts, whereabouts
from tandem.skills.site import load
from tests.fakes.sonar_rig import PERIOD, SonarRig


def rig(**others: tuple[float, float]) -> SonarRig:
    made = SonarRig(robot="summit_xl", others=others)
    made.wait(0.3)
    return made


def apart(robot: SonarRig) -> float:
    x, y = robot.others["r2"]
    return math.hypot(x - robot.pose.x, y - robot.pose.y)


@pytest.mark.parametrize("start", [(2.5, 0.0), (1.5, 1.5), (-1.5, -2.0)])
def test_it_comes_to_its_distance_from_wherever_the_other_is(start: tuple[float, float]) -> None:
    robot = rig(r2=start)
    robot.send(FOLLOW.name, FollowGoal(robot="r2", distance=1.3, seconds=60.0))
    robot.wait(20.0)
    assert apart(robot) == pytest.approx(1.3, abs=0.1)


def test_it_keeps_near_one_that_drives_away_and_turns() -> None:
    robot = rig(r2=(1.3, 0.0))
    robot.send(FOLLOW.name, FollowGoal(robot="r2", distance=1.3, seconds=120.0))
    far = 0.0
    for tick in range(2000):
        heading = 0.02 * tick * PERIOD * 4.0
        x, y = robot.others["r2"]
        robot.others["r2"] = (
            x + 0.3 * PERIOD * math.cos(heading),
            y + 0.3 * PERIOD * math.sin(heading),
        )
        robot.step()
        far = max(far, apart(robot))
    assert far < 1.8


def test_it_backs_up_from_one_that_comes_near() -> None:
    robot = rig(r2=(0.95, 0.0))
    robot.send(FOLLOW.name, FollowGoal(robot="r2", distance=1.3, seconds=60.0))
    robot.wait(5.0)
    assert apart(robot) == pytest.approx(1.3, abs=0.1)


@pytest.mark.parametrize(
    ("x", "yaw", "others", "goes"),
    [
        (-1.60, 0.0, {}, 0.24),
        (-1.85, 0.0, {}, 0.0),
        (0.0, 0.0, {"r1": (-0.85, 0.0)}, 0.05),
        (0.0, 0.0, {"r1": (-0.85, 0.9)}, 0.35),
    ],
    ids=["to the wall behind", "at the wall", "to a robot behind", "past a robot beside"],
)
def test_it_backs_up_only_where_map_and_sights_leave_room(
    x: float, yaw: float, others: dict[str, tuple[float, float]], goes: float
) -> None:
    back = WayBack(floor_field(load("rocs"), 0.4), radius=0.46)
    seen = {name: Sight(*at, at=9.9) for name, at in others.items()}
    free = back.free(FloorPose(x=x, y=0.0, yaw=yaw), seen, now=10.0)
    assert free == pytest.approx(goes, abs=0.051) if goes < 0.3 else free > goes


def test_it_follows_one_that_it_does_not_see_by_what_that_tells() -> None:
    robot = rig()
    told = whereabouts("r2")
    robot.send(FOLLOW.name, FollowGoal(robot="r2", distance=1.3, seconds=60.0, source=FollowSource.BELIEF))
    for sequence in range(150):
        there = FloorPose(x=0.0, y=-2.0, yaw=0.0)
        message = RobotWhereabouts(name="r2", start="s", sequence=sequence, base_in_map=there)
        told.publish(robot.commons, message)
        robot.wait(0.1)
    assert math.hypot(robot.pose.x, robot.pose.y + 2.0) == pytest.approx(1.3, abs=0.1)


def test_one_that_is_lost_is_looked_for_where_it_was_and_then_all_around() -> None:
    robot = rig(r2=(1.3, -0.2))
    robot.send(FOLLOW.name, FollowGoal(robot="r2", distance=1.3, seconds=60.0))
    robot.wait(1.0)
    robot.others["r2"] = (-1.3, 0.3)
    robot.wait(1.0)
    assert robot.speed.angular < 0.0, "it was to the right"
    robot.wait(8.0)
    assert apart(robot) == pytest.approx(1.3, abs=0.15)


def test_it_ends_with_its_time_and_says_how_long_it_saw_the_other() -> None:
    robot = rig(r2=(1.3, 0.0))
    statuses = robot.send(FOLLOW.name, FollowGoal(robot="r2", seconds=4.0))
    robot.wait(2.0)
    del robot.others["r2"]
    ended = robot.until_ended(statuses)
    assert ended.state is GoalState.SUCCEEDED
    assert ended.result is not None
    assert ended.result["seconds"] == pytest.approx(4.0, abs=0.1)
    assert ended.result["seen"] == pytest.approx(2.6, abs=0.3), "for a moment longer it counts as seen"
