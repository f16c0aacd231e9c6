"""What a robot lacks of what a task needs, in words."""

from __future__ import annotations

import pytest

from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.testing.mock_description import mock_description
from tandem.trees.needs import Needs, unable
from tandem.trees.registry import discover
from tandem.trees.task import UNABLE

BOTH = mock_description()
ONE = BOTH.model_copy(update={"end_effectors": (BOTH.end_effector("left"),)})
BARE = BOTH.model_copy(update={"end_effectors": (), "cameras": (), "drive": None})


@pytest.mark.parametrize(
    ("needs", "robot", "why"),
    [
        (Needs(hands=2, drive=True, camera=True), BOTH, ""),
        (Needs(hands=1), BARE, "it needs a gripper"),
        (Needs(hands=2), ONE, "it needs two hands"),
        (Needs(named=("left", "right")), ONE, "it needs hands called left and right (there are: left)"),
        (Needs(drive=True, camera=True), BARE, "it needs a base that drives and a camera"),
        (Needs(place=True), BOTH.model_copy(update={"lasers": ()}), ""),
        (Needs(place=True), BOTH.model_copy(update={"pose_sensors": ()}), ""),
        (
            Needs(place=True, robots=True),
            BOTH.model_copy(update={"lasers": (), "pose_sensors": (), "robot_sensors": ()}),
            "it needs a laser or a pose sensor, to know where it is and a sensor for other robots",
        ),
        (Needs(), BARE, ""),
    ],
)
def test_what_is_missing_is_named(needs: Needs, robot: RobotDescription, why: str) -> None:
    assert unable("it", needs, robot) == why


def test_a_hand_that_the_robot_lacks_is_answered_with_those_it_has() -> None:
    fetch = discover()["fetch"]
    asked = fetch.request.model_validate({"task": "fetch", "item": 29, "arm": "middle"})
    (problem,) = fetch.against(asked, BOTH)
    assert (problem.path, problem.expected) == ("arm", "one of the robot's hands: left, right")
    assert fetch.against(asked, None) == (), "of a robot that has not been heard nothing can be said"


def test_a_task_that_the_robot_cannot_do_is_refused_with_the_missing_part() -> None:
    fetch = discover()["fetch"]
    (problem,) = fetch.against(fetch.request.model_validate({"task": "fetch", "item": 29}), BARE)
    assert (problem.code, problem.path) == (UNABLE, "task")
    assert problem.found == "fetch needs a gripper and a base that drives and a camera"
