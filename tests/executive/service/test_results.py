"""A typed result: told with the status, kept in the ledger; a promise that is broken fails the task."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from py_trees.behaviour import Behaviour
from surroundings import WAIT, Surroundings, WaitRequest, build

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.running.time_limits import LOST_AFTER
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import TaskState, TaskStatus
from tandem.trees.context import TreeContext
from tandem.trees.task import MAX_RESULT_BYTES, TaskType

DONE, FAILED = 1, 2
"""What the world's version tells the task that waits for it."""


class Count(Message):
    """A result."""

    counted: int
    note: str = ""


class Other(Message):
    """A message that is no result of the kind."""


def telling(found: Callable[[], Message | None] | None) -> dict[str, TaskType[Message]]:
    def with_result(request: WaitRequest, context: TreeContext) -> Behaviour:
        context.result = found
        return build(request, context)

    return {"wait": replace(WAIT, build=with_result, result=Count)}  # type: ignore[dict-item, arg-type]


def ended(here: Surroundings, word: int = DONE) -> TaskStatus:
    assert here.ask({"task": "wait", "item": 29}).accepted
    here.step()
    here.world(word)
    here.step(5)
    return here.told()[-1]


def test_the_result_is_told_with_the_end() -> None:
    status = ended(Surroundings(kinds=telling(lambda: Count(counted=3))))
    assert (status.state, status.result) == (TaskState.SUCCEEDED, {"counted": 3, "note": ""})


def test_a_kind_without_a_result_tells_none() -> None:
    status = ended(Surroundings())
    assert (status.state, status.result) == (TaskState.SUCCEEDED, None)


@pytest.mark.parametrize("found", [lambda: Count(counted=1), lambda: None], ids=["some", "none"])
def test_a_task_that_fails_tells_what_it_has(found: Callable[[], Message | None]) -> None:
    status = ended(Surroundings(kinds=telling(found)), FAILED)
    told = found()
    assert status.state is TaskState.FAILED
    assert status.result == (None if told is None else told.model_dump())


def test_a_task_that_lost_its_hardware_tells_what_it_has() -> None:
    here = Surroundings(kinds=telling(lambda: Count(counted=2)))
    assert here.ask({"task": "wait", "item": 29}).accepted
    here.hardware()
    here.step(round(LOST_AFTER) + 2, seconds=1.0)
    status = here.told()[-1]
    assert (status.state, status.result) == (TaskState.FAILED, {"counted": 2, "note": ""})


def test_a_cancelled_task_tells_what_it_has() -> None:
    here = Surroundings(kinds=telling(lambda: Count(counted=2)))
    task = here.ask({"task": "wait", "item": 29}).task
    here.step()
    assert here.cancel(task).accepted
    here.step(5)
    status = here.told()[-1]
    assert (status.state, status.result) == (TaskState.CANCELED, {"counted": 2, "note": ""})


def raising() -> Message:
    raise RuntimeError("a mistake")


@pytest.mark.parametrize(
    ("found", "words"),
    [
        (None, "expected Count as result, found None"),
        (lambda: None, "expected Count as result, found None"),
        (Other, "expected Count as result, found Other()"),
        (lambda: Count(counted=1, note="x" * MAX_RESULT_BYTES), f"at most {MAX_RESULT_BYTES} bytes"),
        (raising, "a mistake"),
    ],
    ids=["never set", "none", "another model", "too large", "raises"],
)
def test_a_task_that_breaks_its_promise_fails_and_says_how(
    found: Callable[[], Message | None] | None, words: str
) -> None:
    status = ended(Surroundings(kinds=telling(found)))
    assert (status.state, status.result) == (TaskState.FAILED, None)
    assert status.failure is not None
    assert words in status.failure.message


@pytest.mark.parametrize("found", [raising, Other], ids=["raises", "another model"])
def test_a_mistake_in_the_result_does_not_hide_why_a_task_failed(found: Callable[[], Message]) -> None:
    status = ended(Surroundings(kinds=telling(found)), FAILED)
    assert status.failure is not None
    assert status.failure.message == "closed on nothing"


def test_the_result_outlives_a_crash(tmp_path: Path) -> None:
    here = Surroundings(
        kinds=telling(lambda: Count(counted=3)), ledger=lambda: SqliteLedger(tmp_path / "ledger.db")
    )
    task = ended(here).task
    here.crash()
    here.begin()
    found = here.executive.book.find(task)
    assert found is not None
    assert found.result == {"counted": 3, "note": ""}
