"""An executive that dies and comes back: over the bus in memory, with its ledger on the disk."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pytest
from py_trees.behaviour import Behaviour
from surroundings import WAIT as KIND
from surroundings import Skill, Surroundings

from tandem.executive.ledger.port import SentGoal
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.render.failure_words import explain
from tandem.executive.service.policy import Policy
from tandem.executive.service.tasks.resuming import RESUMES
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import Command
from tandem.skills.ports.tasks import (
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_PAUSE,
    TASK_RESUME,
    AnswerQuestion,
    AskHistory,
    ControlAnswer,
    NameTask,
    TaskState,
    TaskStatus,
)
from tandem.trees.behaviours.ask import Ask
from tandem.trees.context import TreeContext
from tandem.trees.task import TaskType

S = TaskState
WAIT = {"task": "wait", "item": 29}
NUDGING = {**WAIT, "weight": 2.0}


@pytest.fixture
def here(tmp_path: Path) -> Surroundings:
    return Surroundings(ledger=lambda: SqliteLedger(tmp_path))


def restart(here: Surroundings) -> None:
    here.crash()
    here.told()
    here.begin()


def states(here: Surroundings) -> dict[str, TaskState]:
    return {status.task: status.state for status in here.executive.book.all()}


def status(here: Surroundings, task: str) -> TaskStatus:
    found = here.executive.book.find(task)
    assert found is not None
    return found


def test_every_acknowledged_request_is_there_and_runs(here: Surroundings) -> None:
    tasks = [here.ask(WAIT).task for _ in range(3)]
    restart(here)
    assert states(here) == {tasks[0]: S.RUNNING, tasks[1]: S.QUEUED, tasks[2]: S.QUEUED}
    here.world(1)
    here.step(4)
    assert set(states(here).values()) == {S.SUCCEEDED}


def test_a_finished_task_is_not_run_again_and_is_still_known(here: Surroundings) -> None:
    here.world(1)
    task = here.ask(WAIT).task
    restart(here)
    here.step(3)
    assert here.executive.idle
    assert (status(here, task).state, status(here, task).begun) == (S.SUCCEEDED, 1)


def test_ids_go_on_after_a_restart(here: Surroundings) -> None:
    first = here.ask(WAIT).task
    restart(here)
    assert here.ask(WAIT).task != first


def test_the_same_request_is_answered_the_same_after_a_restart_and_another_refused(
    here: Surroundings,
) -> None:
    mine = {**WAIT, "id": "mine"}
    first = here.ask(mine)
    restart(here)
    assert here.ask(mine) == first
    refused = here.ask({**mine, "weight": 2.0})
    assert (refused.accepted, refused.problems[0].path) == (False, "id")
    assert len(states(here)) == 1


def test_the_goal_of_before_comes_to_rest_first_and_its_number_does_not_come_again(
    here: Surroundings,
) -> None:
    skill = Skill(here)
    task = here.ask(NUDGING).task
    skill.step()
    assert skill.goal == f"{task}/nudge/1"
    restart(here)
    here.step(2)
    skill.step()
    assert skill.commands_seen == [Command.CANCEL]
    here.step(5)
    assert skill.goals.drain() == [], "nothing is sent while the old goal may still move"
    skill.end(GoalState.CANCELED)
    here.step(3)
    skill.step()
    assert skill.goal == f"{task}/nudge/2"
    assert status(here, task).begun == 2


def test_a_goal_that_its_skill_has_forgotten_holds_nobody_up(here: Surroundings) -> None:
    skill = Skill(here)
    here.ask(NUDGING)
    skill.step()
    restart(here)
    here.step()
    for request in skill.commands.drain():
        request.reply(skill.status(GoalState.UNKNOWN))
    here.step(2)
    skill.step()
    assert skill.goal.endswith("/nudge/2")


def test_a_paused_task_is_paused_after_the_restart(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    here.verb(TASK_PAUSE, task)
    restart(here)
    here.world(1)
    here.step(3)
    assert states(here)[task] is S.PAUSED
    assert here.verb(TASK_RESUME, task).accepted
    here.step()
    assert states(here)[task] is S.SUCCEEDED


def test_a_cancel_is_carried_out_after_the_restart(here: Surroundings) -> None:
    skill = Skill(here)
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    here.cancel(task)
    restart(here)
    here.step()
    skill.step()
    here.step()
    assert states(here)[task] is S.CANCELING
    skill.end(GoalState.CANCELED)
    here.step(2)
    assert states(here)[task] is S.CANCELED


def test_what_is_not_to_be_taken_up_is_interrupted_and_says_so(here: Surroundings) -> None:
    task = here.ask({**WAIT, "on_restart": "interrupt"}).task
    restart(here)
    ended = status(here, task)
    assert (ended.state, ended.failure.kind) == (S.INTERRUPTED, FailureKind.INTERRUPTED)
    assert here.told()[-1].state is S.INTERRUPTED


@pytest.mark.parametrize(("answer", "end"), [("resume", S.SUCCEEDED), ("interrupt", S.INTERRUPTED)])
def test_what_is_to_be_asked_about_waits_for_the_operator(
    here: Surroundings, answer: str, end: TaskState
) -> None:
    here.policy = Policy(on_restart="ask")
    task = here.ask(WAIT).task
    restart(here)
    restart(here)
    here.world(1)
    here.step(3)
    asking = status(here, task)
    assert (asking.state, asking.question.choices) == (S.PAUSED, ("resume", "interrupt"))
    assert "answer the question" in here.verb(TASK_RESUME, task).reason
    assert "resume, interrupt" in here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="yes")).reason
    assert here.say(TASK_ANSWER, AnswerQuestion(task=task, answer=answer)).accepted
    here.step(2)
    assert states(here)[task] is end


def test_a_request_that_no_longer_fits_is_rejected(here: Surroundings) -> None:
    here.ask(WAIT)
    waits = here.ask(WAIT).task
    here.kinds = {"other": KIND}
    restart(here)
    assert states(here)[waits] is S.REJECTED
    assert "task: expected" in status(here, waits).failure.message
    assert here.executive.idle


def test_progress_does_not_run_backwards_over_a_restart(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    before = status(here, task).progress.fraction
    assert before == 0.5
    restart(here)
    assert status(here, task).progress.fraction >= before


def test_an_executive_that_is_ended_keeps_what_waits_and_what_runs(here: Surroundings) -> None:
    tasks = [here.ask(WAIT).task for _ in range(2)]
    here.executive.close()
    here.end.close()
    here.begin()
    assert states(here) == {tasks[0]: S.RUNNING, tasks[1]: S.QUEUED}


def crash_again(here: Surroundings, times: int, died: str = "") -> None:
    for _ in range(times):
        here.died = died
        restart(here)
        here.step(3)


def test_a_task_at_which_the_executive_crashes_again_and_again_ends_and_the_next_runs(
    here: Surroundings,
) -> None:
    poison, after = here.ask(WAIT).task, here.ask(WAIT).task
    crash_again(here, RESUMES)
    assert states(here) == {poison: S.RUNNING, after: S.QUEUED}
    crash_again(here, 1, died="the executive process ended (signal 11); last output:\nboom")
    assert states(here) == {poison: S.INTERRUPTED, after: S.RUNNING}
    told = explain(status(here, poison))
    assert "crashed 4 times" in told
    assert "signal 11" in told
    assert "boom" in told


def test_an_executive_that_ends_in_order_has_not_crashed(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    for _ in range(2 * RESUMES):
        here.executive.close()
        here.end.close()
        here.begin()
        here.step(3)
    assert states(here)[task] is S.RUNNING


def test_a_task_that_comes_further_between_crashes_is_taken_up_each_time(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    for number in range(3 * RESUMES):
        here.kept.goal(SentGoal(f"{task}/node {number}/1", "test/nudge"))
        here.kept.goal_ended(f"{task}/node {number}/1", "SUCCEEDED")
        here.kept.commit()
        crash_again(here, 1)
    assert states(here)[task] is S.RUNNING


def test_a_task_that_stands_paused_is_not_blamed(here: Surroundings) -> None:
    task = here.ask(WAIT).task
    here.verb(TASK_PAUSE, task)
    crash_again(here, 2 * RESUMES)
    assert states(here)[task] is S.PAUSED


def test_a_poisonous_cancel_ends_too(here: Surroundings) -> None:
    task = here.ask({**WAIT, "weight": 5.0}).task
    here.cancel(task)
    crash_again(here, RESUMES + 1)
    assert states(here)[task] is S.INTERRUPTED


@pytest.mark.parametrize(("answer", "end"), [("resume", S.RUNNING), ("interrupt", S.INTERRUPTED)])
def test_an_answer_that_was_taken_holds_although_it_had_no_effect_yet(
    here: Surroundings, answer: str, end: TaskState
) -> None:
    here.policy = Policy(on_restart="ask")
    skill = Skill(here)
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    restart(here)
    assert here.say(TASK_ANSWER, AnswerQuestion(task=task, answer=answer)).accepted
    restart(here)
    assert states(here)[task] is end


def test_an_abandoned_task_stays_abandoned(here: Surroundings) -> None:
    skill = Skill(here)
    here.hardware()
    task = here.ask(NUDGING).task
    skill.step()
    here.step()
    here.cancel(task)
    here.step(1, seconds=5.0)
    pending = TASK_ABANDON.query(here.bus, NameTask(task=task))
    here.executive._verbs.step()
    answer = pending.poll()
    assert answer is not None
    assert ControlAnswer.model_validate_json(answer).accepted
    restart(here)
    assert status(here, task).state is S.INTERRUPTED
    assert "abandoned" in status(here, task).failure.message


class AskingRequest(Message):
    task: Literal["asking"] = "asking"
    item: int


def build_asking(_: AskingRequest, context: TreeContext) -> Behaviour:
    return Ask("which", context, "Left or right?", ("left", "right"), lambda _: None)


ASKING = TaskType("asking", "Ask.", AskingRequest, lambda _, __: (), build_asking)


def test_an_answer_to_the_tree_holds_until_it_is_taken(here: Surroundings) -> None:
    here.kinds = {"asking": ASKING}
    restart(here)
    task = here.ask({"task": "asking", "item": 29}).task
    here.step(3)
    assert status(here, task).question is not None
    pending = TASK_ANSWER.query(here.bus, AnswerQuestion(task=task, answer="left"))
    here.executive._verbs.step()
    assert pending.poll() is not None
    restart(here)
    here.step(3)
    assert states(here)[task] is S.SUCCEEDED


YEAR = 365 * 86_400.0


def test_one_start_with_a_clock_a_year_ahead_forgets_nothing(here: Surroundings) -> None:
    here.policy = Policy(keep_days=1.0)
    here.world(1)
    mine = {**WAIT, "id": "mine"}
    first = here.ask(mine)
    late = here.ask(
        {**WAIT, "expires": here.clocks.utc() + 1800.0, "not_before": here.clocks.utc() + 60.0}
    ).task
    here.step(5)
    for wall in (YEAR, 0.0):
        here.clocks.wall = wall
        restart(here)
        here.step(3)
        assert status(here, first.task).state is S.SUCCEEDED
        assert states(here)[late] is S.QUEUED
        assert here.ask(mine) == first
        assert here.executive.idle or states(here)[late] is S.QUEUED


def test_a_clients_id_does_not_run_twice_although_its_task_is_forgotten(here: Surroundings) -> None:
    here.policy = Policy(keep_tasks=0)
    here.world(1)
    mine = {**WAIT, "id": "mine"}
    first = here.ask(mine)
    here.ask(WAIT)
    here.step(5)
    restart(here)
    assert here.kept.history(AskHistory(task=first.task)).tasks == ()
    assert here.ask(mine) == first
    assert not here.ask({**mine, "weight": 2.0}).accepted
    assert here.executive.idle


def test_a_task_that_had_begun_and_waits_again_does_not_expire_over_a_restart(here: Surroundings) -> None:
    task = here.ask({**WAIT, "expires": 5.0}).task
    here.executive.running.make_room()
    here.step()
    restart(here)
    here.step(1, seconds=10.0)
    assert states(here)[task] in {S.QUEUED, S.RUNNING}


def test_a_clock_that_is_set_back_repeats_no_id(here: Surroundings) -> None:
    here.world(1)
    ids = {here.ask(WAIT).task}
    for _ in range(3):
        here.clocks.wall -= 1000.0
        restart(here)
        ids.add(here.ask(WAIT).task)
    assert len(ids) == 4


def test_a_request_that_can_not_be_written_is_refused_and_the_next_is_taken(here: Surroundings) -> None:
    file = here.kept
    assert isinstance(file, SqliteLedger)
    file._db.execute("PRAGMA query_only = 1")
    refused = here.ask(WAIT)
    assert (refused.accepted, refused.problems[0].code) == (False, "NOT_KEPT")
    file._db.execute("PRAGMA query_only = 0")
    assert here.ask(WAIT).accepted
    assert len(states(here)) == 1
