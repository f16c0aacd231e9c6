"""The queue: whose turn it is, when, and who takes over from whom."""

from __future__ import annotations

from typing import Literal

import pytest
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from surroundings import Skill, Surroundings, WaitForWorld

from tandem.executive.service.policy import Policy
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import Command
from tandem.skills.ports.tasks import TASK_REPRIORITISE, Reprioritise, TaskState
from tandem.skills.site import load
from tandem.trees.behaviours.interruptible import Interruptible
from tandem.trees.context import TreeContext
from tandem.trees.task import TaskType

S = TaskState
WAIT = {"task": "wait", "item": 29}
NUDGING = {**WAIT, "weight": 2.0}


class OpenRequest(Message):
    task: Literal["open"] = "open"
    item: int


def build(_: OpenRequest, context: TreeContext) -> Behaviour:
    return Interruptible("let others in", context, WaitForWorld(context))


KIND = TaskType("open", "Wait, and let others in.", OpenRequest, lambda _, __: (), build)


@pytest.fixture
def here() -> Surroundings:
    return Surroundings()


def state(here: Surroundings, task: str) -> TaskState:
    return here.executive.book.find(task).state


def order(here: Surroundings, asked: list[dict[str, object]]) -> list[int]:
    """Ask for all while another task runs; return their places in the order in which they then ran."""
    here.ask(WAIT)
    tasks = [here.ask({**WAIT, **each}).task for each in asked]
    here.told()
    here.world(1)
    here.step(40)
    began = [status.task for status in here.told() if status.state is S.RUNNING]
    return [tasks.index(task) for task in dict.fromkeys(began) if task in tasks]


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ([{}, {}, {}], [0, 1, 2]),
        ([{"priority": 1}, {"priority": 3}, {"priority": 2}], [1, 2, 0]),
        ([{}, {"priority": -1}, {}, {"priority": 1}], [3, 0, 2, 1]),
        ([{"not_before": 1000.0}, {}], [1]),
        ([{"not_before": 0.3, "priority": 9}, {}], [1, 0]),
        ([{"expires": 0.01}, {}], [1]),
    ],
)
def test_by_priority_then_by_arrival_and_not_before_its_time(
    here: Surroundings, asked: list[dict[str, object]], expected: list[int]
) -> None:
    assert order(here, asked)[: len(expected)] == expected


def test_what_has_waited_too_long_has_expired(here: Surroundings) -> None:
    here.ask(WAIT)
    late = here.ask({**WAIT, "expires": 5.0}).task
    here.step(1, seconds=4.0)
    assert state(here, late) is S.QUEUED
    here.step(1, seconds=2.0)
    assert here.told()[-1].state is S.EXPIRED


def test_a_clock_that_jumps_neither_ends_nor_begins_what_depends_on_it(here: Surroundings) -> None:
    """For one second it is an hour too late: what has half an hour yet has it afterwards, too."""
    here.ask(WAIT)
    soon = here.ask({**WAIT, "expires": 1800.0}).task
    later = here.ask({**WAIT, "not_before": 1800.0}).task
    free = here.ask(WAIT).task
    here.clocks.wall = 3600.0
    here.world(1)
    here.step(10, seconds=0.1)
    states = [state(here, each) for each in (soon, later, free)]
    assert states == [S.QUEUED, S.QUEUED, S.SUCCEEDED]
    here.clocks.wall = 0.0
    here.step(5, seconds=0.1)
    assert [state(here, each) for each in (soon, later)] == [S.SUCCEEDED, S.QUEUED]
    here.step(1, seconds=1800.0)
    here.step(5)
    assert state(here, later) is S.SUCCEEDED


def test_a_task_that_has_begun_does_not_expire(here: Surroundings) -> None:
    """It makes room for another one, and its latest start goes by meanwhile."""
    here = Surroundings(kinds={"wait": Surroundings().kinds["wait"], "open": KIND})
    low = here.ask({"task": "open", "item": 29, "expires": 5.0}).task
    urgent = here.ask({**WAIT, "priority": 5}).task
    here.step(3)
    assert (state(here, low), state(here, urgent)) == (S.QUEUED, S.RUNNING)
    here.step(10, seconds=1.0)
    assert state(here, low) is S.QUEUED
    here.cancel(urgent)
    here.step(3)
    assert state(here, low) is S.RUNNING


@pytest.mark.parametrize(
    ("said", "path"),
    [
        ({"priority": 101}, "priority"),
        ({"priority": 1.5}, "priority"),
        ({"not_before": "soon"}, "not_before"),
        ({"not_before": 9.0, "expires": 8.0}, "expires"),
        ({"expires": 0.5}, "expires"),
        ({"on_restart": "hope"}, "on_restart"),
        ({"test_run": 1}, "test_run"),
    ],
)
def test_what_is_wrong_with_an_envelope_is_named(
    here: Surroundings, said: dict[str, object], path: str
) -> None:
    here.step(1, seconds=1.0)
    answer = here.ask({**WAIT, **said})
    assert (answer.accepted, [problem.path for problem in answer.problems]) == (False, [path])


def test_a_full_queue_is_told_by_its_code(here: Surroundings) -> None:
    here = Surroundings(policy=Policy(waiting=2))
    answers = [here.ask(WAIT) for _ in range(4)]
    assert [answer.accepted for answer in answers] == [True, True, True, False]
    assert answers[-1].problems[0].code == "QUEUE_FULL"


def test_many_requests_of_one_moment_are_all_answered(here: Surroundings) -> None:
    pending = [here.bus.query("task/request", b'{"task": "wait", "item": 29}') for _ in range(100)]
    here.step(5)
    assert all(b'"accepted":true' in (each.poll() or b"") for each in pending)
    assert len(here.executive.book.waiting) == 99


def test_another_priority_is_another_place(here: Surroundings) -> None:
    here.ask(WAIT)
    first, second = here.ask(WAIT).task, here.ask(WAIT).task
    assert here.say(TASK_REPRIORITISE, Reprioritise(task=second, priority=1)).accepted
    assert here.executive.book.waiting == (second, first)
    assert here.told()[-1].priority == 1


def test_a_task_that_may_be_interrupted_makes_room_and_is_taken_up_again() -> None:
    here = Surroundings(kinds={"wait": Surroundings().kinds["wait"], "open": KIND})
    skill = Skill(here)
    low = here.ask({"task": "open", "item": 29}).task
    here.ask(WAIT)
    urgent = here.ask({**NUDGING, "priority": 5}).task
    here.step(2)
    skill.step()
    assert (state(here, low), state(here, urgent)) == (S.QUEUED, S.RUNNING)
    here.cancel(urgent)
    skill.step()
    assert skill.commands_seen == [Command.CANCEL]
    skill.end(GoalState.CANCELED)
    here.step(3)
    assert state(here, low) is S.RUNNING, "it came before the one of its own priority"
    assert here.executive.book.find(low).begun == 2
    here.world(1)
    here.step(4)
    assert state(here, low) is S.SUCCEEDED


@pytest.mark.parametrize(("kind", "priority"), [("wait", 5), ("open", 0)])
def test_nobody_else_makes_room(kind: str, priority: int) -> None:
    here = Surroundings(kinds={"wait": Surroundings().kinds["wait"], "open": KIND})
    running = here.ask({"task": kind, "item": 29}).task
    here.ask({**WAIT, "priority": priority})
    here.step(5)
    assert state(here, running) is S.RUNNING


def test_a_door_is_closed_when_its_work_has_ended() -> None:
    context = TreeBench(load("lab"), items={}).context
    node = Interruptible("door", context, WaitForWorld(context))
    node.tick_once()
    assert context.interruptible
    node.stop(Status.INVALID)
    assert not context.interruptible
