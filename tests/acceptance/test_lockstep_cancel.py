"""Cancelling in each phase: the robot is at rest in truth, no goal runs on, and the next request works."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.course import STILL, Course, course

pytestmark = [pytest.mark.lockstep, pytest.mark.xdist_group("cancel")]

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=2.6)
REST_WITHIN = 2.0
"""Robot seconds from the cancel to the task's end."""


@pytest.fixture(scope="module")
def run() -> Iterator[Course]:
    """Return one system for all cancels: each test also shows that the one before left it in order."""
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as running:
        yield running


def at(run: Course, node: str) -> Callable[[], bool]:
    """Return the condition that a node with this in its path runs."""
    return lambda: any(node in path for path in run.running())


def holding(run: Course) -> bool:
    world = run.world()
    return world is not None and bool(world.held)


def cancel(run: Course, task: str) -> None:
    """Cancel, and check what must hold after each cancel."""
    asked_at = run.seconds
    assert run.cancel(task).accepted
    assert run.caller.follow(task, within=REST_WITHIN).state is TaskState.CANCELED
    assert run.open_goals() == (), "a task ends when its goals have"
    assert run.moves() < STILL, f"{run.seconds - asked_at} s after the cancel"


def after(run: Course, node: str, seconds: float = 0.4) -> str:
    """Ask for item 29 and go on until a node has run for a moment; return the task."""
    task = run.ask(29)
    run.until(at(run, node), within=120.0)
    since = run.seconds
    run.until(lambda: run.seconds >= since + seconds, within=seconds + 0.1)
    assert at(run, node)(), run.account()
    return task


def test_while_the_request_is_checked(run: Course) -> None:
    cancel(run, after(run, "fetch/request", seconds=0.0))


def test_while_turning_in_the_search(run: Course) -> None:
    cancel(run, after(run, "turn 30 degrees"))


def test_while_driving_to_the_item(run: Course) -> None:
    cancel(run, after(run, "drive to item", seconds=0.8))


def test_while_the_arm_moves_before_the_grasp(run: Course) -> None:
    cancel(run, after(run, "pre-grasp", seconds=0.9))


def test_with_the_item_in_the_hand(run: Course) -> None:
    cancel(run, after(run, "after pick: tuck"))


def test_a_queued_task_never_starts(run: Course) -> None:
    first, second = run.ask(42), run.ask(3)
    assert run.cancel(second).accepted
    cancel(run, first)
    ended = {status.task: status for status in run.tasks()}
    assert ended[second].state is TaskState.CANCELED
    assert ended[second].started is None


def test_while_placing(run: Course) -> None:
    cancel(run, after(run, "put down", seconds=0.2))


def test_while_driving_home_and_then_another_request_works(run: Course) -> None:
    task = run.ask(29)
    run.until(at(run, "home: drive"), within=150.0)
    since = run.seconds
    run.until(lambda: run.seconds >= since + 0.8, within=1.0)
    cancel(run, task)
    assert run.delivered(29)
    assert run.fetch(29, within=60.0).state is TaskState.SUCCEEDED, "it is there already: only home is left"
    assert run.delivered(29)


@pytest.mark.thorough
def test_while_the_hand_closes_and_then_another_request_works() -> None:
    facing = BEFORE_THE_TABLE.model_copy(update={"yaw": 0.0})
    with course(load_scenario("Demo").starting_at(facing)) as run:
        cancel(run, after(run, "/close", seconds=0.1))
        assert run.fetch(29, within=200.0).state is TaskState.SUCCEEDED, run.account()
        assert run.delivered(29)
