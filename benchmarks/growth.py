"""What a tick, a request and a list cost against how much is known: tasks that ended or wait, items believed.

In one process, with mocked skills and a ledger on disk; processor time, so that others disturb it little. A
cost is flat when it does not rise with the size; what grows, and why, is told in docs/waiting.md.
"""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from pydantic import JsonValue

from benchmarks.machine import frozen
from benchmarks.rows import Row, quantile
from benchmarks.ticks import ITEMS, forget
from tandem.executive.ledger.port import Entry
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.executive import Executive
from tandem.executive.service.policy import Policy
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_CANCEL,
    TASK_HISTORY,
    TASK_LIST,
    AskHistory,
    AskTasks,
    CancelTask,
    TaskAnswer,
    TaskState,
    TaskStatus,
)
from tandem.skills.ports.world import ItemFact
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryHub
from tandem.trees.registry import discover

ENDED: Final = (100, 1_000, 10_000, 100_000)
WAITING: Final = (10, 100, 900)
BELIEVED: Final = (10, 100, 1_000)
TIMES: Final = 40
FIRST_ITEM: Final = 1_000
"""Numbers of believed items that no request names."""
FETCH: Final[dict[str, JsonValue]] = {"task": "fetch", "item": 29}
LATER: Final[dict[str, JsonValue]] = {**FETCH, "priority": -1}


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    ended, times = (ENDED[:2], 5) if quick else (ENDED, TIMES)
    for count in ended:
        yield from _sized("tasks ended", count, times, ended=count)
    for count in WAITING[:1] if quick else WAITING:
        yield from _sized("tasks waiting", count, times, waiting=count)
    for count in BELIEVED[:1] if quick else BELIEVED:
        yield from _sized("items believed", count, times, items=count)


def _sized(
    what: str, count: int, times: int, *, ended: int = 0, waiting: int = 0, items: int = 0
) -> Iterator[Row]:
    with tempfile.TemporaryDirectory() as folder:
        known = Known(Path(folder), ended=ended, waiting=waiting, items=items)
        try:
            with frozen():
                measured = known.costs(times)
        finally:
            known.close()
    for name, seconds in measured.items():
        note = "median of processor time"
        yield Row(f"{name}, {count:,} {what}", 1e3 * quantile(seconds, 0.5), "ms", note=note)


class Known:
    """An executive that knows much, with one task under way.

    Args:
        folder: for its ledger.
        ended: tasks in the ledger.
        waiting: tasks in the queue.
        items: that are believed beside the one that is fetched.
    """

    def __init__(self, folder: Path, *, ended: int, waiting: int, items: int) -> None:
        hub, self._clocks, site = MemoryHub(), SteppedClocks(), load("lab")
        self._robot = MockRobot(hub.endpoint(), self._clocks, site, items=ITEMS, duration=1e6)
        ledger = SqliteLedger(folder)
        for number in range(1, ended + 1):
            _enter(ledger, number)
        ledger.commit()
        policy = Policy(keep_tasks=10 * max(ENDED))
        self._executive = Executive(
            hub.endpoint(), self._clocks, site, discover(), ledger=ledger, policy=policy
        )
        self._client = hub.endpoint()
        self._believe(items)
        self.ask(FETCH)
        for _ in range(waiting):
            self.ask(LATER)

    def costs(self, times: int) -> dict[str, list[float]]:
        """Return the processor seconds of each of some acts, each done so often."""
        self._go_on()
        acts: dict[str, Callable[[], object]] = {
            "step with a tick": self._executive.step,
            "request, answered": self._answered_request,
            "task/list, answered": lambda: self._answered(TASK_LIST.query(self._client, AskTasks())),
            "task/history, answered": lambda: self._answered(TASK_HISTORY.query(self._client, AskHistory())),
            "world/state, taken in": self._executive.step,
        }
        spent: dict[str, list[float]] = {name: [] for name in acts}
        for _ in range(times):
            for name, act in acts.items():
                self._clocks.advance(0.06)  # a timer of the tree is due
                if name.startswith("world"):
                    self._robot.tell()
                else:
                    self._quiet()
                began = time.thread_time()
                act()
                spent[name].append(time.thread_time() - began)
            self._withdraw()
        return spent

    def ask(self, document: dict[str, JsonValue]) -> TaskAnswer:
        """Send a request and let it be answered."""
        pending = self._client.query(REQUEST, json.dumps(document).encode(), timeout=10.0)
        self._go_on()
        payload = pending.poll()
        assert payload is not None, "the executive answers at once"
        return TaskAnswer.model_validate_json(payload)

    def close(self) -> None:
        """Leave."""
        self._executive.close()
        self._robot.close()

    def _go_on(self) -> None:
        for _ in range(3):
            self._clocks.advance(0.01)
            self._robot.step()
            self._executive.step()

    def _quiet(self) -> None:
        """Have all taken in that was told, so that only the act is measured."""
        self._executive.step()
        self._clocks.advance(0.06)

    def _answered_request(self) -> None:
        self._asked = self._client.query(REQUEST, json.dumps(LATER).encode(), timeout=10.0)
        self._executive.step()

    def _answered(self, pending: object) -> None:
        del pending
        self._executive.step()

    def _withdraw(self) -> None:
        payload = self._asked.poll()
        assert payload is not None, "the executive answers at once"
        answer = TaskAnswer.model_validate_json(payload)
        assert answer.task is not None, answer
        TASK_CANCEL.query(self._client, CancelTask(task=answer.task))
        self._go_on()

    def _believe(self, count: int) -> None:
        forget(self._robot)
        world = self._robot.world
        facts = tuple(
            ItemFact(
                item=FIRST_ITEM + number,
                size=(0.06, 0.06, 0.06),
                tag_in_map=ITEMS[29],
                seen=self._robot.now,
                quality=1.0,
                position_sigma=0.002,
            )
            for number in range(count)
        )
        self._robot.world = world.model_copy(update={"items": facts, "version": world.version + 1})
        self._robot.tell()


def _enter(ledger: SqliteLedger, number: int) -> None:
    status = TaskStatus(
        task=f"fetch-{number:04d}",
        kind="fetch",
        request=FETCH,
        state=TaskState.QUEUED,
        accepted_at=float(number),
    )
    ledger.enter(Entry(status, number))
    ended = status.model_copy(update={"state": TaskState.SUCCEEDED, "ended_at": float(number)})
    ledger.change(ended, float(number))
