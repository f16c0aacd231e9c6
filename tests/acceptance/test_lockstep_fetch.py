"""Fetches by the whole system in lockstep; what they come to is read from the truth."""

from __future__ import annotations

import math

import pytest

from tandem.sim.scenario import load_scenario
from tandem.sim.things import TrueItem
from tandem.skills.geometry.poses import wrap, yaw_of
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tandem.skills.site import load
from tests.acceptance.course import Course, course

pytestmark = pytest.mark.lockstep

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)
BACK_TO_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=math.pi)
ON_THE_CABINET = TrueItem(item=29, support="cabinet", x=1.10, y=-2.57, yaw=0.2)
"""Too far from home and from the first search spot for its tag to be read."""


def at_home(course: Course) -> bool:
    home, base = course.site.home, course.truth().base_in_map
    away = math.hypot(base.position[0] - home.x, base.position[1] - home.y)
    return away < 0.10 and abs(wrap(yaw_of(base.orientation) - home.yaw)) < 0.15


def told(course: Course, words: str) -> int:
    return sum(words in line for line in course.story)


@pytest.mark.thorough
def test_two_items_in_view_one_after_the_other() -> None:
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as run:
        first, second = run.ask(29), run.ask(42)
        states = {status.task: status.state for status in run.tasks()}
        assert states == {first: TaskState.RUNNING, second: TaskState.QUEUED}
        assert run.caller.follow(first, within=150.0).state is TaskState.SUCCEEDED
        assert run.delivered(29)
        assert run.caller.follow(second, within=150.0).state is TaskState.SUCCEEDED

        assert told(run, "turn 30 degrees") == 0, "the first look has both in view"
        assert run.delivered(29), "the second item must not push the first one off"
        assert run.delivered(42)
        world = run.world()
        assert world is not None
        slots = {placed.item: placed.slot for placed in world.placed}
        assert sorted(slots) == [29, 42]
        assert slots[29] != slots[42]
        ended, began = (run.tasks()[0].ended, run.tasks()[1].started)
        assert ended is not None
        assert began is not None
        assert began.seconds >= ended.seconds
        assert at_home(run)
        assert run.open_goals() == ()


@pytest.mark.thorough
def test_item_behind_the_robot() -> None:
    with course(load_scenario("Demo").starting_at(BACK_TO_THE_TABLE)) as run:
        assert run.fetch(29).state is TaskState.SUCCEEDED
        assert 1 <= told(run, "ok   turn 30 degrees here") <= 8, "it stops turning when the tag is seen"
        assert told(run, "next spot") == 0
        assert run.delivered(29)
        assert at_home(run)


@pytest.mark.thorough
def test_item_at_the_second_search_spot() -> None:
    with course(load_scenario("Demo").with_item(ON_THE_CABINET)) as run:
        assert run.fetch(29).state is TaskState.SUCCEEDED
        assert told(run, "ok   drive to spot") == 2
        assert told(run, "ok   look again here") == 0, "not where it started, nor at the first spot"
        assert run.delivered(29)
        assert at_home(run)


@pytest.mark.thorough
def test_an_absent_item_is_not_found_and_the_robot_goes_home() -> None:
    site = load("lab")
    site = site.model_copy(update={"spots": site.spots[:1]})  # six take minutes
    demo = load_scenario("Demo").without_item(29)
    with course(demo, site=site) as run:
        ended = run.fetch(29)
        assert ended.state is TaskState.FAILED
        assert ended.failure is not None
        assert FailureKind.ITEM_NOT_FOUND in [failure.kind for failure in ended.failure.chain()]
        assert told(run, "ok   turn 30 degrees") == 24, "a full turn where it starts, and at the spot"
        assert at_home(run)
        assert run.moves() < 0.003
