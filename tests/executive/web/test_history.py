"""What the page's server keeps of the ledger's tasks: no more than there is room for."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterable
from typing import Any, cast

from tandem.executive.client.aio import AsyncClient
from tandem.executive.web.history import MOST, Filter, Past, known
from tandem.skills.ports.tasks import PAGE, History, TaskState, TaskStatus

WIDTH = 10_000
"""Characters of a text that nobody asks for twice."""


class Ledger:
    """Answers as an executive that keeps every task: newest first."""

    def __init__(self) -> None:
        self.tasks: list[TaskStatus] = []
        self.asked = 0

    def add(self, count: int, state: TaskState = TaskState.SUCCEEDED, text: str = "") -> None:
        for number in range(len(self.tasks), len(self.tasks) + count):
            self.tasks.append(
                TaskStatus(
                    task=f"go-{number}", kind="go", request={"text": text}, state=state, accepted_at=number
                )
            )

    async def history(
        self, *, states: Iterable[TaskState] = (), before: int = 0, limit: int = PAGE
    ) -> History:
        self.asked += 1
        wanted, end = set(states), before or len(self.tasks)
        begin = max(0, end - limit)
        found = [each for each in self.tasks[begin:end] if not wanted or each.state in wanted]
        return History(tasks=tuple(reversed(found)), more=begin)

    async def status(self, task: str) -> TaskStatus:
        return self.tasks[int(task.removeprefix("go-"))]


def found(past: Past, ledger: Ledger) -> list[str]:
    """Return the ids of the newest tasks that are known, and refresh before."""
    asyncio.run(past.refresh(cast("AsyncClient", ledger)))
    told: dict[str, Any] = json.loads(past.answer(Filter()))
    return [str(told["count"]), *(each["task"] for each in told["tasks"][:2])]


def test_a_server_that_lives_for_long_keeps_the_newest() -> None:
    past, ledger = Past(most=250), Ledger()
    ledger.add(200)
    assert found(past, ledger) == ["200", "go-199", "go-198"]
    assert not json.loads(past.answer(Filter()))["left_out"]
    for _ in range(10):
        ledger.add(100)
        found(past, ledger)
    assert found(past, ledger) == ["250", "go-1199", "go-1198"]
    assert json.loads(past.answer(Filter()))["left_out"], "the page says so"


def test_of_a_larger_ledger_no_more_is_asked_for_than_is_kept() -> None:
    past, ledger = Past(most=250), Ledger()
    ledger.add(2000)
    assert found(past, ledger) == ["250", "go-1999", "go-1998"]
    assert ledger.asked == 3


def test_what_has_not_ended_is_kept_however_long_it_waits() -> None:
    past, ledger = Past(most=50), Ledger()
    ledger.add(1, TaskState.QUEUED)
    found(past, ledger)
    ledger.add(200)
    assert found(past, ledger) == ["51", "go-200", "go-199"]
    assert json.loads(past.answer(Filter(state="QUEUED")))["count"] == 1


def test_large_requests_don_t_take_more_than_the_room_that_there_is() -> None:
    past, ledger = Past(room=20 * WIDTH), Ledger()
    ledger.add(100, text="x" * WIDTH)
    count, newest, _ = found(past, ledger)
    assert (10 < int(count) < 20, newest) == (True, "go-99")


def test_twenty_thousand_tasks_are_filtered_and_counted() -> None:
    past, ledger = Past(), Ledger()
    ledger.add(MOST)
    for number in range(0, MOST, 10):
        ledger.tasks[number] = ledger.tasks[number].model_copy(update={"state": TaskState.FAILED})
    past._known = {each.task: known(each) for each in reversed(ledger.tasks)}  # to read it takes 200 pages
    counts = {Filter(): MOST, Filter(state="FAILED"): MOST // 10, Filter(text="go-1999"): 11}
    for wanted, count in counts.items():
        told = json.loads(past.answer(wanted))
        assert (told["count"], len(told["tasks"])) == (count, min(count, 50))
