"""The reflex that steers to a place: off unless switched on, and the lowest of all."""

from __future__ import annotations

import math

import pytest

from tandem.skills.base.reflexes.approach import ApproachParameters
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.base import GO, GoGoal
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import ReflexSwitch, reflex_switch
from tests.fakes.sonar_rig import SonarRig

FRONT = "sonar_3"


def rig(x: float, *, on: bool = True) -> SonarRig:
    made = SonarRig(pose=FloorPose(x=x, y=0.0, yaw=2.0))
    made.wait(0.3)
    if on:
        reflex_switch("approach").query(made.bus, ReflexSwitch(on=True, by="Ada"))
    return made


def away(robot: SonarRig) -> float:
    return math.hypot(robot.pose.x, robot.pose.y)


def test_it_does_nothing_until_it_is_switched_on() -> None:
    robot = rig(1.5, on=False)
    robot.wait(3.0)
    assert robot.commands == []


def test_it_gets_to_its_place_and_stands_there() -> None:
    robot = rig(1.5)
    robot.wait(15.0)
    assert away(robot) < 0.13
    assert robot.speed.linear == 0.0
    assert robot.told[-1].reflex == ""


def test_what_is_too_near_ahead_takes_the_wheels_from_it() -> None:
    robot = rig(-1.5)
    robot.wait(3.0)
    robot.seen[FRONT] = 0.25
    robot.wait(0.3)
    assert robot.told[-1].reflex == "avoid_collision"
    del robot.seen[FRONT]
    robot.wait(20.0)
    assert away(robot) < 0.13


def test_it_keeps_out_of_the_way_of_a_goal_only_once_it_is_off() -> None:
    robot = rig(1.5)
    robot.wait(1.0)
    assert robot.told[-1].reflex == "approach"
    reflex_switch("approach").query(robot.bus, ReflexSwitch(on=False, by="Ada"))
    robot.wait(0.5)
    ended = robot.until_ended(robot.send(GO.name, GoGoal(x=1.0, y=0.5, position_tolerance=0.1)))
    assert ended.state is GoalState.SUCCEEDED


def test_it_stands_while_the_stop_is_set() -> None:
    robot = rig(1.5)
    robot.wait(1.0)
    STOP_STATE.publish(robot.bus, StopState(stopped=True, by="Ada", reason="a test"))
    robot.wait(2.0)
    there = robot.pose
    robot.wait(2.0)
    assert robot.pose == there


def test_bounds_that_contradict_each_other_are_refused() -> None:
    with pytest.raises(ValueError, match="contradictory thresholds"):
        ApproachParameters.model_validate({"near": {"fires": 0.3, "releases": 0.2}})
