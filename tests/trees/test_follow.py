"""Follow: the other robot is followed for the time asked for, whatever takes the base meanwhile."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.base import FollowGoal, FollowSource
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.whereabouts import Following
from tandem.skills.site import load
from tandem.skills.testing.mock_base import FOR_EVER, MockReflex
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.tasks.follow import TASK, FollowedResult, FollowRequest

SITE = load("lab")


def bench(reflex: MockReflex | None = None) -> TreeBench:
    made = TreeBench(SITE, items={}, localised=True, step=0.05)
    made.robot.wheels.reflex = reflex or MockReflex()
    return made


def result(run: TreeBench) -> FollowedResult:
    return FollowedResult.model_validate(run.result())


def goals(run: TreeBench) -> list[FollowGoal]:
    return [goal for _, goal in run.robot.calls if isinstance(goal, FollowGoal)]


def test_it_follows_for_the_time_asked_for_and_tells_for_how_long_it_saw_the_other() -> None:
    run = bench()
    run.robot.wheels.seen = 0.8
    assert run.run("follow", {"robot": "r2", "distance": 1.2, "seconds": 50.0}) is Status.SUCCESS
    told = result(run)
    assert told.seconds == pytest.approx(50.0, abs=0.2)
    assert told.share == pytest.approx(0.8, abs=0.01)
    assert [(goal.robot, goal.distance) for goal in goals(run)] == [("r2", 1.2)]


def test_after_a_reflex_it_goes_on_for_the_rest_of_the_time() -> None:
    run = bench(MockReflex(times=2, holds=5.0))
    assert run.run("follow", {"robot": "r2", "seconds": 50.0}) is Status.SUCCESS
    told = result(run)
    assert (told.overridden, told.reactive) == (2, pytest.approx(10.0, abs=0.5))
    assert [goal.seconds for goal in goals(run)] == [pytest.approx(each, abs=0.5) for each in (50, 45, 40)]


def test_a_long_time_is_of_several_goals() -> None:
    run = bench()
    assert run.run("follow", {"robot": "r2", "seconds": 700.0}) is Status.SUCCESS
    assert [goal.seconds for goal in goals(run)] == [pytest.approx(each, abs=0.5) for each in (300, 300, 100)]


def test_no_reflex_holds_it_up_beyond_its_time() -> None:
    run = bench(MockReflex(times=FOR_EVER))
    assert run.run("follow", {"robot": "r2", "seconds": 20.0}) is Status.SUCCESS
    assert result(run).share == 0.0
    assert result(run).overridden > 20
    assert run.clocks.robot().seconds < 25.0


def test_what_was_seen_before_a_reflex_counts() -> None:
    run = bench()
    late = Failure(
        kind=FailureKind.OVERRIDDEN, message="reflex x took the base", evidence={"reflex": "avoid_collision"}
    )
    run.robot.leaf_faults["follow it", 1] = Fault(failure=late, late=10.0)
    run.robot.wheels.seen = 0.0
    assert run.run("follow", {"robot": "r2", "seconds": 20.0}) is Status.SUCCESS
    assert result(run).seen == pytest.approx(10.0, abs=0.5)


def test_a_robot_that_sees_no_others_can_only_go_by_what_they_tell() -> None:
    blind = mock_description().model_copy(update={"robot_sensors": ()})
    (problem,) = TASK.against(FollowRequest(robot="r2"), blind)
    assert (problem.path, problem.found) == ("source", "sensor")
    assert "no sensor for other robots" in problem.expected
    assert TASK.against(FollowRequest(robot="r2", source=FollowSource.BELIEF), blind) == ()


def test_the_goal_says_how_the_other_is_found() -> None:
    run = bench()
    assert run.run("follow", {"robot": "r2", "seconds": 5.0, "source": "belief"}) is Status.SUCCESS
    assert {each.source for each in goals(run)} == {FollowSource.BELIEF}


def test_whom_it_follows_is_told_to_the_site() -> None:
    assert TASK.following(FollowRequest(robot="r2", distance=1.0)) == Following(robot="r2", distance=1.0)
