"""Every verb in every state: whether it is taken, and what is said when it is not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from surroundings import WAIT as KIND
from surroundings import Skill, Surroundings

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.running.time_limits import SILENT_AFTER
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.tasks import (
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_STEP,
    AnswerQuestion,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ForceNode,
    NameTask,
    Reprioritise,
    StepTask,
    TaskState,
    TaskStatus,
    task_status,
)

S = TaskState
NUDGING = {"task": "wait", "item": 29, "weight": 2.0, "test_run": True}

TAKEN_IN = {
    "cancel": {S.QUEUED, S.RUNNING, S.PAUSING, S.PAUSED, S.CANCELING},
    "pause": {S.RUNNING, S.PAUSING, S.PAUSED},
    "resume": {S.PAUSING, S.PAUSED},
    "step": {S.PAUSED},
    "abandon": set(),  # not while the hardware answers: see below
    "reprioritise": {S.QUEUED},
    "answer": set(),  # not while nothing is asked: see test_ask.py
    "breakpoint": {S.RUNNING, S.PAUSING, S.PAUSED},
    "force": {S.RUNNING, S.PAUSING, S.PAUSED},
}


def say(here: Surroundings, verb: str, task: str) -> ControlAnswer:
    said: dict[str, Callable[[], ControlAnswer]] = {
        "cancel": lambda: here.say(TASK_CANCEL, CancelTask(task=task)),
        "pause": lambda: here.say(TASK_PAUSE, NameTask(task=task)),
        "resume": lambda: here.say(TASK_RESUME, NameTask(task=task)),
        "step": lambda: here.say(TASK_STEP, StepTask(task=task, by="tick")),
        "abandon": lambda: here.say(TASK_ABANDON, NameTask(task=task)),
        "reprioritise": lambda: here.say(TASK_REPRIORITISE, Reprioritise(task=task, priority=5)),
        "answer": lambda: here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="yes")),
        "breakpoint": lambda: here.say(TASK_BREAKPOINT, Breakpoint(task=task, node="wait for the world")),
        "force": lambda: here.say(TASK_FORCE, ForceNode(task=task, node="wait/nudge", status="SUCCESS")),
    }
    return said[verb]()


def bring_to(here: Surroundings, skill: Skill, state: TaskState) -> str:
    """Bring a task into a state, by the ways that clients, skills and restarts have."""
    if state in {S.QUEUED, S.EXPIRED, S.REJECTED}:
        here.ask(NUDGING)
        task = here.ask({**NUDGING, "expires": 5.0}).task
        if state is S.EXPIRED:
            here.step(1, seconds=6.0)
        if state is S.REJECTED:
            here.kinds = {"other": KIND}
            here.crash()
            here.begin()
        return task
    task = here.ask({**NUDGING, "on_restart": "interrupt"}).task
    skill.step()
    here.step()
    if state in {S.PAUSING, S.PAUSED}:
        say(here, "pause", task)
        here.step()
        if state is S.PAUSED:
            skill.step()
            here.step()
    if state in {S.CANCELING, S.CANCELED}:
        say(here, "cancel", task)
        skill.step()
    if state in {S.SUCCEEDED, S.FAILED}:
        here.world(1 if state is S.SUCCEEDED else 2)
    if state in {S.SUCCEEDED, S.FAILED, S.CANCELED}:
        skill.end(GoalState.SUCCEEDED if state is not S.CANCELED else GoalState.CANCELED)
        here.step(3)
    if state is S.INTERRUPTED:
        here.crash()
        here.begin()
    return task


@pytest.fixture
def here(tmp_path: Path) -> Surroundings:
    return Surroundings(ledger=lambda: SqliteLedger(tmp_path))


@pytest.mark.parametrize("state", list(TaskState))
@pytest.mark.parametrize("verb", TAKEN_IN)
def test_a_verb_in_a_state(here: Surroundings, verb: str, state: TaskState) -> None:
    skill = Skill(here)
    task = bring_to(here, skill, state)
    found = here.executive.book.find(task)
    assert found is not None
    assert found.state is state
    told = say(here, verb, task)
    assert told.accepted == (state in TAKEN_IN[verb]), told.reason
    assert bool(told.reason) != told.accepted
    if state.terminal:
        assert state in told.reason
        assert here.executive.book.find(task) == found


@pytest.mark.parametrize("verb", TAKEN_IN)
def test_a_verb_on_an_unknown_task(here: Surroundings, verb: str) -> None:
    assert say(here, verb, "wait-9").reason == "unknown task 'wait-9'"


SERVICES = (
    TASK_CANCEL, TASK_PAUSE, TASK_RESUME, TASK_STEP, TASK_ABANDON, TASK_REPRIORITISE, TASK_ANSWER,
    TASK_BREAKPOINT, TASK_FORCE,
)  # fmt: skip


@pytest.mark.parametrize("key", [service.key for service in SERVICES])
@pytest.mark.parametrize("payload", [b"", b"{", b"[]", b'{"task": 1}', b"\xff", b'{"task": "a", "b": 1}'])
def test_a_verb_with_a_document_that_is_none(here: Surroundings, key: str, payload: bytes) -> None:
    pending = here.bus.query(key, payload)
    here.step()
    answer = ControlAnswer.model_validate_json(pending.poll() or b"")
    assert not answer.accepted
    assert any(each in answer.reason for each in ("task", "UTF-8", "b: expected no such field"))


def test_a_cancelled_task_is_abandoned_only_when_the_hardware_is_silent(here: Surroundings) -> None:
    skill = Skill(here)
    here.hardware()
    task = bring_to(here, skill, S.CANCELING)
    here.hardware()
    assert "the hardware answers" in say(here, "abandon", task).reason
    here.step(1, seconds=SILENT_AFTER + 1.0)
    assert say(here, "abandon", task).accepted
    here.step()
    found = here.executive.book.find(task)
    assert found.state is S.INTERRUPTED
    assert "test/nudge" in found.failure.message
    waits = here.ask(NUDGING).task
    here.step(5)
    assert here.executive.book.find(waits).state is S.QUEUED, "what may still move is waited for"


def test_a_node_is_forced_in_a_test_run_only(here: Surroundings) -> None:
    task = here.ask({**NUDGING, "test_run": False}).task
    assert "not a test run" in say(here, "force", task).reason


def test_a_forced_node_does_not_work_and_ends_as_it_was_told(here: Surroundings) -> None:
    task = here.ask({**NUDGING, "weight": 1.0}).task
    told = here.say(TASK_FORCE, ForceNode(task=task, node="wait for the world", status="FAILURE"))
    assert told.accepted
    here.step(2)
    found = here.executive.book.find(task)
    assert (found.state, found.failure.message) == (S.FAILED, "the node was forced to fail, for a test")


def test_a_breakpoint_holds_the_task_before_a_node_until_it_is_resumed(here: Surroundings) -> None:
    skill = Skill(here)
    task = bring_to(here, skill, S.RUNNING)
    assert "no node 'wait'" not in say(here, "breakpoint", task).reason
    here.world(1)
    skill.end(GoalState.SUCCEEDED)
    here.step(5)
    assert here.executive.book.find(task).state is S.PAUSED
    assert say(here, "resume", task).accepted
    here.step(2)
    assert here.executive.book.find(task).state is S.SUCCEEDED


def test_what_is_set_at_nodes_is_told_with_the_tree_until_the_task_ends(here: Surroundings) -> None:
    skill = Skill(here)
    asked = here.ask({**NUDGING, "test_run": True})
    skill.step()
    here.step()
    node = "wait/wait for the world"
    here.shown()

    def told() -> list[tuple[object, object]]:
        here.step()
        return [(each.breakpoints, each.forced) for each in here.shown()]

    for side in ("after", "before"):
        here.say(TASK_BREAKPOINT, Breakpoint(task=asked.task, node=node, when=side))
    assert told()[-1] == ({node: ("before", "after")}, {})
    here.say(TASK_BREAKPOINT, Breakpoint(task=asked.task, node=node, on=False))
    here.say(TASK_FORCE, ForceNode(task=asked.task, node=node, status="FAILURE"))
    assert told()[-1] == ({node: ("after",)}, {node: "FAILURE"})
    here.cancel(asked.task)
    assert told()[-1] == ({}, {}), "it does not come to them any more"


def test_one_tick_is_stepped(here: Surroundings) -> None:
    skill = Skill(here)
    task = bring_to(here, skill, S.PAUSED)
    ticks = here.executive.running.ticks
    assert say(here, "step", task).accepted
    skill.step()
    here.step(5)
    skill.step()
    here.step(5)
    assert here.executive.running.ticks == ticks + 1
    assert here.executive.book.find(task).state in {S.PAUSING, S.PAUSED}


@pytest.mark.parametrize("verb", ["cancel", "pause", "breakpoint"])
def test_a_verb_takes_the_id_that_the_client_chose(here: Surroundings, verb: str) -> None:
    here.ask({**NUDGING, "id": "my-1"})
    here.step()
    assert say(here, verb, "my-1").accepted


def test_a_tasks_own_id_is_not_hidden_by_a_clients(here: Surroundings) -> None:
    first = here.ask(NUDGING).task
    second = here.ask({**NUDGING, "id": first}).task
    say(here, "reprioritise", second)
    assert say(here, "cancel", first).accepted
    found = here.executive.book.find(second)
    assert found is not None
    assert found.state is S.QUEUED


def test_the_status_of_a_task_is_told_by_the_clients_id(here: Surroundings) -> None:
    task = here.ask({**NUDGING, "id": "my-1"}).task
    pending = here.bus.query(task_status("my-1").key, b"{}")
    here.step()
    assert TaskStatus.model_validate_json(pending.poll() or b"").task == task
