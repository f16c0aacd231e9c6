"""What is told of a task: to those who listen, to those who come late, and of long ago."""

from __future__ import annotations

from pathlib import Path

import pytest
from surroundings import Surroundings

from tandem.executive.client.pages import listed
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.policy import Policy
from tandem.executive.service.tasks.time_left import Expectation
from tandem.skills.ports.endpoint import Refusal
from tandem.skills.ports.tasks import (
    TASK_HISTORY,
    TASK_LIST,
    TASK_STATUS,
    TREE,
    AskHistory,
    AskTasks,
    History,
    TaskList,
    TaskState,
    TaskStatus,
    TreeSnapshot,
    task_status,
)
from tandem.skills.wire.memory import MemoryPending

WAIT = {"task": "wait", "item": 29}


@pytest.fixture
def here(tmp_path: Path) -> Surroundings:
    return Surroundings(ledger=lambda: SqliteLedger(tmp_path))


def get(here: Surroundings, key: str, payload: bytes = b"") -> bytes | None:
    pending = here.bus.query(key, payload)
    here.step()
    return pending.poll()


def history(here: Surroundings, asked: AskHistory) -> History:
    answer = get(here, TASK_HISTORY.key, asked.model_dump_json().encode())
    assert answer is not None
    return TASK_HISTORY.decode_answer(answer)


def test_who_comes_late_asks_a_topics_key_for_what_holds_now(here: Surroundings) -> None:
    assert get(here, TASK_STATUS.key) is None
    first, second = here.ask(WAIT).task, here.ask(WAIT).task
    assert TaskStatus.model_validate_json(get(here, TASK_STATUS.key) or b"").task in {first, second}
    one = TaskStatus.model_validate_json(get(here, task_status(first).key) or b"")
    assert (one.task, one.state, one.running) == (first, TaskState.RUNNING, ("wait for the world",))
    assert TreeSnapshot.model_validate_json(get(here, TREE.key) or b"").task == first
    assert get(here, task_status("wait-9999").key) is None


def test_the_status_of_an_ended_task_is_still_told(here: Surroundings) -> None:
    here.world(1)
    task = here.ask(WAIT).task
    here.step()
    one = TaskStatus.model_validate_json(get(here, task_status(task).key) or b"")
    assert (one.state, one.running, one.ended_at) == (TaskState.SUCCEEDED, (), one.ended.seconds)


def test_the_history_has_what_memory_has_forgotten(
    here: Surroundings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tandem.executive.service.tasks.task_book.KEPT", 2)
    here.world(1)
    tasks = [here.ask(WAIT).task for _ in range(5)]
    here.step(8)
    assert [each.task for each in here.executive.book.all()] == tasks[-2:]
    assert [each.task for each in history(here, AskHistory()).tasks] == tasks[::-1]
    assert history(here, AskHistory(states=(TaskState.FAILED,))).tasks == ()
    assert history(here, AskHistory(task=tasks[0])).tasks[0].state is TaskState.SUCCEEDED


@pytest.mark.parametrize("document", [b"{", b'{"before": 99999999999999999999}', b'{"limit": 101}'])
def test_a_question_about_the_history_that_is_none_is_refused(here: Surroundings, document: bytes) -> None:
    pending = here.bus.query(TASK_HISTORY.key, document)
    here.step()
    assert pending.poll() is None
    assert Refusal.model_validate_json(pending.refusal() or b"").problems


def test_a_long_list_comes_in_pages(here: Surroundings) -> None:
    for _ in range(250):
        here.ask(WAIT)
        here.clocks.advance(0.1)

    def page(asked: AskTasks) -> TaskList:
        return TaskList.model_validate_json(get(here, TASK_LIST.key, asked.model_dump_json().encode()) or b"")

    newest = page(AskTasks())
    assert [each.task for each in newest.tasks] == [f"wait-{number:04d}" for number in range(151, 251)]
    assert [each.task for each in page(AskTasks(before=newest.more, limit=2)).tasks] == [
        "wait-0149",
        "wait-0150",
    ]
    assert [each.task for each in listed(page)] == [f"wait-{number:04d}" for number in range(1, 251)]


def test_a_wildcard_is_answered_by_questions_only_each_under_its_key(here: Surroundings) -> None:
    first, second = here.ask(WAIT).task, here.ask(WAIT).task
    pending = here.bus.query("task/**", b"")
    here.step()
    assert isinstance(pending, MemoryPending)
    assert set(pending.replies) == {
        "task/list",
        "task/info",
        "task/kinds",
        "task/site",
        "task/history",
        "task/status",
        f"task/{first}/status",
        f"task/{second}/status",
    }
    assert {each.state for each in here.executive.book.all()} == {TaskState.RUNNING, TaskState.QUEUED}


def test_old_tasks_go_when_the_service_starts(here: Surroundings) -> None:
    here.world(1)
    for _ in range(5):
        here.ask(WAIT)
    here.step(8)
    here.policy = Policy(keep_tasks=2)
    here.crash()
    here.begin()
    assert len(history(here, AskHistory()).tasks) == 2


def test_what_a_task_takes_yet_is_learnt_from_those_before(here: Surroundings) -> None:
    for seconds in (10, 30, 20):
        here.world(0)
        here.ask(WAIT)
        here.step(seconds, seconds=1.0)
        here.world(1)
        here.step(2)
    here.world(0)
    here.ask(WAIT)
    assert here.told()[-1].time_left == pytest.approx(20.0, abs=1.0)
    here.crash()
    here.begin()
    here.step(5, seconds=1.0)
    assert here.executive.book.all()[-1].time_left == pytest.approx(20.0, abs=1.0)


def test_expectation_is_the_median_from_the_phase_on_and_never_below_nothing() -> None:
    left = Expectation({"search": (30.0, 10.0, 20.0), "home": (4.0,)})
    left.enter("search", 100.0)
    assert [left.left(now) for now in (100.0, 105.0, 150.0)] == [20.0, 15.0, 0.0]
    left.enter("unheard of", 150.0)
    assert left.left(150.0) is None
    left.enter("home", 151.0)
    assert left.left(152.0) == 3.0
    assert left.lesson(155.0) == {"search": 55.0, "unheard of": 5.0, "home": 4.0}
