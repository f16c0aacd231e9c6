"""Whether what was asked for is so, by the simulation's truth."""

from __future__ import annotations

import pytest
from pydantic import JsonValue

from tandem.executive.trials.truly import judged
from tandem.sim.truth import TrueBody, TrueRobot, Truth
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

FLAT = (0.0, 0.0, 0.0, 1.0)
THERE = Pose(position=(1.1, 0.0, 0.0), orientation=FLAT)
TRUTH = Truth(
    stamp=RobotTime(boot="b", seconds=1.0),
    base_in_map=Pose(position=(5.0, 5.0, 0.0), orientation=FLAT),
    bodies=(),
    contacts=(),
    robots=(TrueRobot(name="r2", base_in_map=THERE, linear=(0.0, 0.0), angular=0.0),),
)


@pytest.mark.parametrize(
    ("request_", "robot", "words"),
    [
        ({"task": "go_to", "x": 1.0, "y": 0.0}, "r2", "r2 is 0.100 m from where it was to go"),
        ({"task": "go_to", "x": 5.0, "y": 5.0}, "", "the robot is 0.000 m from where it was to go"),
        ({"task": "patrol", "corners": [{"x": 9, "y": 9}, {"x": 1, "y": 0}]}, "r2", "r2 is 0.100 m"),
        ({"task": "inspect"}, "r2", "nothing that the simulation can judge"),
    ],
)
def test_a_robot_is_where_it_was_to_go(request_: dict[str, JsonValue], robot: str, words: str) -> None:
    found = judged(request_, TRUTH, load("rocs"), robot)
    assert found.good
    assert found.words.startswith(words)


def test_a_robot_that_is_elsewhere_is_not_there_whatever_it_says() -> None:
    found = judged({"task": "go_to", "x": 1.0, "y": 1.0}, TRUTH, load("rocs"), "r2")
    assert not found.good
    assert found.notes == {"off_goal": 1.005}


@pytest.mark.parametrize("said", [29, "tea"])
def test_an_item_is_judged_whatever_it_is_called(said: JsonValue) -> None:
    lies = TrueBody(name="item_29", item=29, pose=Pose(position=(0.0, 0.0, 0.03), orientation=FLAT))
    found = judged({"task": "fetch", "item": said, "to": "depot"}, with_body(lies), load("lab"), "")
    assert not found.good
    assert found.words == "item 29 (tea) is not in depot"


@pytest.mark.parametrize("said", [30, "coffee"])
def test_an_item_that_the_site_does_not_have_is_not_there(said: JsonValue) -> None:
    assert not judged({"task": "fetch", "item": said, "to": "depot"}, TRUTH, load("lab"), "").good


def with_body(body: TrueBody) -> Truth:
    return TRUTH.model_copy(update={"bodies": (body,)})
