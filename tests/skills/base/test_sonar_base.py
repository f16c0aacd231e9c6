"""A base with sonars and a pose sensor: it goes straight, and its reflex gives way."""

from __future__ import annotations

import math
from itertools import groupby, pairwise

import pytest

from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.base import GO, GoGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import ReflexSwitch, reflex_switch
from tests.fakes.sonar_rig import SonarRig

FRONT = "sonar_3"
"""Looks 10 degrees to the left of straight ahead, from 0.17 m before the axis."""


def rig(**seen: float) -> SonarRig:
    made = SonarRig()
    made.wait(0.3)
    made.seen.update(seen)
    return made


@pytest.mark.parametrize(("x", "y"), [(1.5, 0.0), (-1.0, 1.0), (0.3, -1.2)])
def test_it_goes_to_a_place_and_says_how_near_it_got(x: float, y: float) -> None:
    robot = rig()
    ended = robot.until_ended(robot.send(GO.name, GoGoal(x=x, y=y, position_tolerance=0.1)))
    assert ended.state is GoalState.SUCCEEDED
    assert ended.result is not None
    assert math.hypot(robot.pose.x - x, robot.pose.y - y) < 0.1
    assert ended.result["position_error"] == pytest.approx(
        math.hypot(robot.pose.x - x, robot.pose.y - y), abs=0.01
    )


def test_it_turns_to_a_heading_at_the_end_when_it_is_told_one() -> None:
    robot = rig()
    ended = robot.until_ended(robot.send(GO.name, GoGoal(x=0.5, y=0.0, yaw=2.0)))
    assert ended.state is GoalState.SUCCEEDED
    assert abs(math.remainder(robot.pose.yaw - 2.0, math.tau)) < 0.1


def test_the_decomposition_is_told_while_it_runs() -> None:
    robot = rig()
    robot.until_ended(robot.send(GO.name, GoGoal(x=0.0, y=1.0)))
    told = [each.doing for each in robot.told if each.holder == GO.name and each.doing]
    assert list(dict.fromkeys(told)) == [
        ("GoTo", "TurnTo", "TurnAngle"),
        ("GoTo", "SetWheelSpeed"),
    ]


def test_what_is_too_near_ahead_takes_the_wheels_turns_away_and_gives_them_back() -> None:
    robot = rig()
    going = robot.send(GO.name, GoGoal(x=2.0, y=0.0))
    robot.wait(2.0)
    assert robot.speed.linear > 0.3
    robot.seen[FRONT] = 0.36
    robot.wait(0.2)
    assert robot.told[-1].reflex == "avoid_collision"
    robot.wait(1.0)
    del robot.seen[FRONT]
    ended = robot.until_ended(going)
    assert ended.failure is not None
    assert ended.failure.kind is FailureKind.OVERRIDDEN
    assert ended.failure.evidence["reflex"] == "avoid_collision"
    assert ended.failure.evidence["sensor"] == FRONT
    assert robot.told[-1].reflex == ""
    acts = [each.doing for each in robot.told if each.reflex]
    assert [act for act, _ in groupby(acts)] == [
        ("AvoidCollision", "SetWheelSpeed"),
        ("AvoidCollision", "TurnAngle"),
        ("AvoidCollision", "SetWheelSpeed"),
    ], "it brakes, turns, goes on a little and brakes"


def test_it_brakes_within_the_drives_limits() -> None:
    robot = rig()
    robot.send(GO.name, GoGoal(x=2.0, y=0.0))
    robot.wait(2.0)
    robot.seen[FRONT] = 0.36
    before = len(robot.commands)
    robot.wait(2.0)
    speeds = [each.linear for each in robot.commands[before - 1 :]]
    most = robot.description.driven.acceleration * 0.02
    assert max(abs(b - a) for a, b in pairwise(speeds)) <= most + 1e-9


# A thing ahead is passed along it; a thing on one side turns it to the other; a corner turns it round.
TURNS = [
    ({"sonar_3": 0.20}, -1.0),
    ({"sonar_4": 0.20}, 1.0),
    ({"sonar_1": 0.10, "sonar_2": 0.15}, -1.0),
    ({"sonar_5": 0.15, "sonar_6": 0.10}, 1.0),
]


@pytest.mark.parametrize(("seen", "side"), TURNS)
def test_it_turns_to_the_side_that_is_free(seen: dict[str, float], side: float) -> None:
    robot = rig(**seen)
    robot.wait(2.0)
    assert math.copysign(1.0, robot.pose.yaw) == side
    assert abs(robot.pose.yaw) > 0.5


def test_one_that_stands_gives_way_and_one_that_is_switched_off_does_not() -> None:
    robot = rig()
    reflex_switch("avoid_collision").query(robot.bus, ReflexSwitch(on=False, by="Ada"))
    robot.step()
    robot.seen["sonar_15"] = 0.15
    robot.wait(2.0)
    assert robot.pose == FloorPose(x=0.0, y=0.0, yaw=0.0)
    reflex_switch("avoid_collision").query(robot.bus, ReflexSwitch(on=True, by="Ada"))
    robot.wait(1.0)
    assert robot.told[-1].reflex == "avoid_collision"
    del robot.seen["sonar_15"]
    robot.wait(4.0)
    assert math.hypot(robot.pose.x, robot.pose.y) > 0.2
    assert robot.told[-1].reflex == ""


def test_with_a_silent_sonar_ahead_it_goes_slowly() -> None:
    robot = rig()
    robot.silent.add(FRONT)
    robot.wait(0.6)
    robot.send(GO.name, GoGoal(x=2.0, y=0.0))
    robot.wait(4.0)
    assert 0.0 < max(each.linear for each in robot.commands) <= 0.15
    robot.silent.clear()
    robot.wait(2.0)
    assert robot.speed.linear > 0.3


def test_with_a_sonar_that_tells_the_same_on_the_way_it_goes_slowly() -> None:
    robot = rig()
    robot.send(GO.name, GoGoal(x=4.0, y=0.0))
    robot.seen[FRONT] = 1.5
    robot.wait(5.0)
    assert 0.0 < robot.speed.linear <= 0.15


def test_it_does_not_go_before_it_knows_where_it_is() -> None:
    robot = SonarRig()
    pending = robot.send(GO.name, GoGoal(x=1.0, y=0.0))
    robot.step()
    assert pending.refresh() is None
    assert robot.commands == []
