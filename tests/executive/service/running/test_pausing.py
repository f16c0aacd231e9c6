"""Pause, resume, step, and what is done after a cancel."""

from __future__ import annotations

import pytest
from surroundings import Skill, Surroundings

from tandem.executive.service.running.time_limits import REST_WITHIN, WIND_DOWN_WITHIN
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP, STOP_STATE
from tandem.skills.ports.skill import Command
from tandem.skills.ports.tasks import TASK_PAUSE, TASK_RESUME, TASK_STEP, TaskState, TaskStatus

WAIT = {"task": "wait", "item": 29}
NUDGING = {**WAIT, "weight": 2.0}
WINDING = {**WAIT, "weight": 4.0}


@pytest.fixture
def here() -> Surroundings:
    return Surroundings()


@pytest.fixture
def skill(here: Surroundings) -> Skill:
    return Skill(here)


def nudging(here: Surroundings, skill: Skill) -> str:
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    return task


def last(here: Surroundings) -> TaskStatus:
    return here.told()[-1]


def test_a_paused_task_is_not_ticked_and_its_skills_rest(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    assert here.verb(TASK_PAUSE, task).accepted
    assert last(here).state is TaskState.PAUSING
    here.step()
    skill.step()
    here.step()
    assert last(here).state is TaskState.PAUSED
    assert skill.commands_seen == [Command.PAUSE]
    ticks = here.executive.running.ticks
    here.world(1)
    here.step(100)
    assert here.executive.running.ticks == ticks


def test_a_resumed_task_goes_on_to_its_end(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    here.step()
    skill.step()
    here.step()
    assert here.verb(TASK_RESUME, task).accepted
    here.step()
    skill.step()
    here.step()
    assert skill.commands_seen == [Command.PAUSE, Command.RESUME]
    assert last(here).state is TaskState.RUNNING
    skill.end(GoalState.SUCCEEDED)
    here.world(1)
    here.step(2)
    assert last(here).state is TaskState.SUCCEEDED


def test_a_goal_that_ends_instead_of_pausing_is_at_rest_too(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    skill.end(GoalState.SUCCEEDED)
    here.step()
    assert last(here).state is TaskState.PAUSED


def test_a_skill_that_does_not_pause_has_the_hardware_stopped(here: Surroundings, skill: Skill) -> None:
    stop = here.bus.serve(STOP.key)
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    here.step(2, seconds=REST_WITHIN)
    stop.drain()[0].reply(StopState(stopped=True).model_dump_json().encode())
    here.step()
    assert last(here).failure.kind is FailureKind.HARDWARE_STOPPED


def test_a_paused_task_can_be_cancelled(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    here.step()
    skill.step()
    here.step()
    assert here.cancel(task).accepted
    skill.step()
    assert skill.canceled
    skill.end(GoalState.CANCELED)
    here.step(2)
    assert last(here).state is TaskState.CANCELED


def test_a_step_ends_with_the_next_leaf(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    here.step()
    skill.step()
    here.step()
    assert here.verb(TASK_STEP, task).accepted
    here.step()
    skill.step()
    here.step(20)
    assert last(here).state is TaskState.RUNNING
    skill.end(GoalState.SUCCEEDED)
    here.step()
    assert last(here).state is TaskState.PAUSED
    here.world(1)
    here.step(20)
    assert here.told() == []
    assert here.verb(TASK_STEP, task).accepted
    here.step(20)
    assert last(here).state is TaskState.SUCCEEDED


def test_what_cant_be_paused_resumed_or_stepped_is_said(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    queued = here.ask(WAIT).task
    assert here.verb(TASK_RESUME, task).reason == "the task is not paused"
    assert here.verb(TASK_STEP, task).reason == "the task is not paused"
    assert here.verb(TASK_PAUSE, queued).reason == "the task has not started"
    assert "unknown task" in here.verb(TASK_PAUSE, "wait-0099").reason
    here.verb(TASK_PAUSE, task)
    assert "coming to rest" in here.verb(TASK_STEP, task).reason
    here.cancel(task)
    assert here.verb(TASK_PAUSE, task).reason == "the task is being cancelled"
    skill.step()
    skill.end(GoalState.CANCELED)
    here.step(2)
    assert "CANCELED" in here.verb(TASK_PAUSE, task).reason


def test_the_tree_is_told_how_long_it_stood(here: Surroundings, skill: Skill) -> None:
    task = nudging(here, skill)
    here.verb(TASK_PAUSE, task)
    skill.step()
    here.step(10, seconds=1.0)
    here.verb(TASK_RESUME, task)
    assert here.executive.running.context.paused_for == pytest.approx(10.0, abs=0.1)


def test_after_a_cancel_the_wind_down_is_done(here: Surroundings, skill: Skill) -> None:
    task = here.ask(WINDING).task
    assert here.cancel(task).accepted
    here.step(5)
    skill.step()
    assert skill.goal.endswith("put down/1")
    here.step(10)
    assert last(here).state is TaskState.CANCELING
    skill.end(GoalState.SUCCEEDED)
    here.step(10)
    ended = last(here)
    assert (ended.state, ended.failure) == (TaskState.CANCELED, None)


def test_a_second_cancel_stops_the_wind_down_too(here: Surroundings, skill: Skill) -> None:
    task = here.ask(WINDING).task
    here.cancel(task)
    here.step(5)
    skill.step()
    here.step()
    assert here.cancel(task).accepted
    skill.step()
    assert skill.canceled
    skill.end(GoalState.CANCELED)
    here.step(5)
    assert last(here).state is TaskState.CANCELED


def test_a_wind_down_has_its_time(here: Surroundings) -> None:
    task = here.ask({**WAIT, "weight": 5.0}).task
    here.cancel(task)
    here.step(round(WIND_DOWN_WITHIN) + 5, seconds=1.0)
    ended = last(here)
    assert (ended.state, ended.failure.kind) == (TaskState.CANCELED, FailureKind.TIMED_OUT)


def test_with_the_hardwares_stop_set_nothing_is_wound_down(here: Surroundings, skill: Skill) -> None:
    task = here.ask(WINDING).task
    STOP_STATE.publish(here.bus, StopState(stopped=True, by="operator"))
    here.cancel(task)
    here.step(5)
    skill.step()
    ended = last(here)
    assert skill.goal == ""
    assert (ended.state, ended.failure.kind) == (TaskState.CANCELED, FailureKind.HARDWARE_STOPPED)
