"""The service over the bus in memory, with a task whose tree waits for a word."""

from __future__ import annotations

import subprocess
import sys
from typing import TypeVar

import pytest
from surroundings import NUDGE, Skill, Surroundings

from tandem.executive.service.running.tick_timer import TICK_PERIOD
from tandem.executive.service.running.time_limits import REST_WITHIN
from tandem.executive.service.tasks.task_book import KEPT, MAX_WAITING, TaskBook, start_id
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP, Nothing, Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import TASK_INFO, TASK_LIST, TREE_NOW, NodeStatus, Progress, TaskState

A = TypeVar("A", bound=Message)
WAIT = {"task": "wait", "item": 29}
NUDGING = {"task": "wait", "item": 29, "weight": 2.0}


@pytest.fixture
def here() -> Surroundings:
    return Surroundings()


def query(here: Surroundings, service: Service[Nothing, A]) -> A:
    pending = service.query(here.bus, Nothing())
    here.step()
    answer = pending.poll()
    assert answer is not None
    return service.decode_answer(answer)


def test_a_step_does_not_list_who_waits(here: Surroundings, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a thousand in the queue that alone would cost more than a tick."""

    def listed(_: TaskBook) -> tuple[str, ...]:
        raise AssertionError("listed")

    for _ in range(3):
        here.ask(WAIT)
    monkeypatch.setattr(TaskBook, "waiting", property(listed))
    here.step(3)
    assert query(here, TASK_INFO).queued == 2
    assert not here.executive.idle


def states(here: Surroundings) -> list[tuple[str, str]]:
    return [(status.task[-1], status.state.value) for status in here.told()]


def test_requests_run_one_at_a_time_in_their_order(here: Surroundings) -> None:
    for _ in range(3):
        here.ask(WAIT)
    assert query(here, TASK_INFO).queued == 2
    seen = []
    for _ in range(3):
        here.world(1)
        here.step()
        here.world(0)
        here.step()
        seen += states(here)
    order = [each for each in seen if each[1] in {"RUNNING", "SUCCEEDED"}]
    assert order[:2] == [("1", "RUNNING"), ("1", "RUNNING")]  # the second tells the phase
    ends = [task for task, state in order if state == "SUCCEEDED"]
    starts = list(dict.fromkeys(task for task, state in order if state == "RUNNING"))
    assert ends == starts == ["1", "2", "3"]
    assert order.index(("2", "RUNNING")) > order.index(("1", "SUCCEEDED"))


def test_the_first_tick_comes_with_the_request(here: Surroundings) -> None:
    here.ask(WAIT)
    assert here.shown()[0].root.children[0].status is NodeStatus.RUNNING


def test_the_tree_is_published_when_something_in_it_changes_and_only_then(here: Surroundings) -> None:
    here.ask(WAIT)
    here.shown()
    here.step(20)
    assert here.shown() == []
    here.world(1)
    here.step()
    (last,) = here.shown()
    assert last.root.status is NodeStatus.SUCCESS
    assert last.root.children[0].message == "version 1"


def test_it_ticks_when_something_has_happened_or_a_timer_is_due(here: Surroundings) -> None:
    here.ask(WAIT)
    run = here.executive.running
    assert run.ticks == 1
    here.step(10, seconds=TICK_PERIOD / 100)
    assert run.ticks == 1
    here.step(seconds=TICK_PERIOD)
    assert run.ticks == 2
    here.world(0)
    here.step(seconds=0.0)
    assert run.ticks == 3


def test_a_failure_is_told_with_its_kind(here: Surroundings) -> None:
    here.ask(WAIT)
    here.world(2)
    here.step()
    last = here.told()[-1]
    assert last.state is TaskState.FAILED
    assert last.failure.kind is FailureKind.GRASP_EMPTY


def test_progress_is_told_never_falls_and_ends_at_one(here: Surroundings) -> None:
    here.ask(WAIT)
    assert here.told()[-1].progress.phase == "waiting"
    here.executive.running.context._progress = Progress(phase="back", fraction=0.1)
    here.step()
    assert here.executive.running.progress.fraction == 0.5
    here.world(1)
    here.step()
    assert here.told()[-1].progress.fraction == 1.0


def test_a_tree_that_raises_costs_its_task_only(here: Surroundings) -> None:
    here.ask(WAIT)
    here.world(3)
    here.step()
    failed = here.told()[-1]
    assert (failed.state, failed.failure.kind) == (TaskState.FAILED, FailureKind.SKILL_CRASHED)
    here.world(1)
    here.step()
    here.ask(WAIT)
    assert here.told()[-1].state is TaskState.SUCCEEDED


def test_a_tree_that_cant_be_built_costs_its_task_only(here: Surroundings) -> None:
    here.ask({**WAIT, "weight": 3.0})
    assert here.told()[-1].state is TaskState.FAILED
    assert here.ask(WAIT).accepted


def test_cancel_while_queued(here: Surroundings) -> None:
    here.ask(WAIT)
    second, third = here.ask(WAIT).task, here.ask(WAIT).task
    assert here.cancel(second).accepted
    here.world(1)
    here.step(3)
    ended = [(status.task, status.state) for status in here.told() if status.state.terminal]
    assert (second, TaskState.CANCELED) in ended
    assert ended[-1] == (third, TaskState.SUCCEEDED)


def test_cancel_of_what_is_not_there(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    here.world(1)
    here.step()
    assert "SUCCEEDED" in here.cancel(task).reason
    assert "unknown task" in here.cancel("wait-0099").reason
    pending = here.bus.query("task/cancel", b"{")
    here.step()
    assert b"expected" in pending.poll()


@pytest.fixture
def skill(here: Surroundings) -> Skill:
    return Skill(here)


def test_cancel_while_running_waits_for_the_skill_to_be_at_rest(here: Surroundings, skill: Skill) -> None:
    task = here.ask(NUDGING).task
    here.ask(WAIT)
    skill.step()
    here.step()
    assert here.cancel(task).accepted
    skill.step()
    assert skill.canceled
    here.step(5)
    assert states(here)[-1] == ("1", "CANCELING")
    assert here.cancel(task).accepted, "asking twice is allowed"
    skill.end(GoalState.CANCELED)
    here.step(2)
    assert states(here)[:2] == [("1", "CANCELED"), ("2", "RUNNING")]


def test_a_cancelled_tree_is_shown_as_stopped(here: Surroundings, skill: Skill) -> None:
    task = here.ask(NUDGING).task
    skill.step()
    here.shown()
    here.cancel(task)
    assert here.shown()[-1].root.status is NodeStatus.INVALID


def test_a_skill_that_does_not_come_to_rest_has_the_hardware_stopped(
    here: Surroundings, skill: Skill
) -> None:
    stop = here.bus.serve(STOP.key)
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    here.cancel(task)
    skill.step()
    here.step(1, seconds=REST_WITHIN + 1)
    (asked,) = stop.drain()
    assert b"did not come to rest" in asked.payload
    asked.reply(StopState(stopped=True).model_dump_json().encode())
    here.step()
    last = here.told()[-1]
    assert (last.state, last.failure.kind) == (TaskState.FAILED, FailureKind.HARDWARE_STOPPED)
    assert last.failure.evidence["stop_confirmed"] is True


def stop_for_a_stuck_goal(here: Surroundings, skill: Skill, *, confirmed: bool) -> None:
    stop = here.bus.serve(STOP.key)
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    here.cancel(task)
    skill.step()
    here.step(1, seconds=REST_WITHIN + 1)
    stop.drain()[0].reply(StopState(stopped=confirmed).model_dump_json().encode())
    here.ask(WAIT)


def test_after_a_confirmed_stop_a_stuck_goal_is_given_up_and_the_next_task_runs(
    here: Surroundings, skill: Skill
) -> None:
    stop_for_a_stuck_goal(here, skill, confirmed=True)
    here.step(3)
    skill.end(GoalState.SUCCEEDED)
    here.world(1)
    here.step(3)
    assert [each for each in states(here) if each[1] in {"FAILED", "SUCCEEDED"}] == [
        ("1", "FAILED"),
        ("2", "SUCCEEDED"),
    ]


def test_nothing_starts_while_a_stuck_goal_may_still_move(here: Surroundings, skill: Skill) -> None:
    stop_for_a_stuck_goal(here, skill, confirmed=False)
    here.step(20, seconds=0.5)
    seen = states(here)
    assert ("1", "FAILED") in seen
    assert ("2", "RUNNING") not in seen
    skill.end(GoalState.CANCELED)
    here.step(2)
    assert ("2", "RUNNING") in states(here)


def test_a_goal_that_ignores_its_time_out_has_the_hardware_stopped(here: Surroundings, skill: Skill) -> None:
    stop = here.bus.serve(STOP.key)
    here.ask(NUDGING)
    for _ in range(round(NUDGE.timeout + REST_WITHIN) + 2):
        skill.step()
        here.step(1, seconds=1.0)
        for request in stop.drain():
            request.reply(StopState(stopped=True).model_dump_json().encode())
    last = here.told()[-1]
    assert (last.state, last.failure.kind) == (TaskState.FAILED, FailureKind.HARDWARE_STOPPED)
    assert last.failure.evidence["skill"] == NUDGE.name


def test_a_stop_that_nobody_confirms_is_said_to_be_unconfirmed(here: Surroundings, skill: Skill) -> None:
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    here.cancel(task)
    skill.step()
    here.step(8, seconds=1.0)
    here.step(4, seconds=1.0)
    last = next(status for status in reversed(here.told()) if status.state.terminal)
    assert last.failure.evidence["stop_confirmed"] is False


def test_questions_are_answered(here: Surroundings) -> None:
    assert query(here, TREE_NOW).root.name == "idle"
    here.ask(WAIT)
    info = query(here, TASK_INFO)
    assert (info.tasks, info.running) == (("wait",), "wait-0001")
    assert query(here, TREE_NOW).task == "wait-0001"
    assert [status.task for status in query(here, TASK_LIST).tasks] == ["wait-0001"]


def test_the_queue_is_bounded(here: Surroundings) -> None:
    answers = [here.ask(WAIT) for _ in range(MAX_WAITING + 2)]
    assert [answer.accepted for answer in answers] == [True] * (MAX_WAITING + 1) + [False]


def test_old_tasks_are_forgotten(here: Surroundings) -> None:
    here.world(1)
    for _ in range(KEPT + 10):
        here.ask(WAIT)
    assert len(here.executive.book.all()) <= KEPT + 1


def test_closing_cancels_what_waits_and_what_runs(here: Surroundings, skill: Skill) -> None:
    here.ask(NUDGING)
    here.ask(WAIT)
    skill.step()
    here.told()
    here.executive.close()
    here.executive.close()
    skill.step()
    assert skill.canceled
    assert states(here) == [("2", "CANCELED"), ("1", "CANCELING")]


def test_ids_differ_between_two_starts() -> None:
    assert start_id() != start_id()


@pytest.mark.parametrize(
    "module",
    ["tandem.executive.service.executive", "tandem.executive.trials.run_report", "tandem.trees.registry"],
)
def test_the_service_loads_nothing_heavy(module: str) -> None:
    heavy = "numpy cv2 ompl pinocchio coal pybullet ruckig yaml"
    code = f"""
import sys, {module}, tandem.trees.registry
tandem.trees.registry.discover()
print(" ".join(name for name in "{heavy}".split() if name in sys.modules))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
