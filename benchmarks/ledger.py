"""The ledger: durable requests a second, the time until one is acknowledged, and until a killed task goes on.

Beside each stands what the same disk and the same bus do without us, taken in turns with it: a plain SQLite
insert of a row of the same size with the same settings, and a query that is answered at once + an fdatasync.
"""

from __future__ import annotations

import json
import os
import sqlite3
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Final

from benchmarks.echo import KEY
from benchmarks.machine import frozen
from benchmarks.processes import PREFIX, echo, free_endpoint, running
from benchmarks.rows import Row, quantile
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.intake.request_parser import Asked, read_request
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.executive.service.tasks.wall_clock import WallClock
from tandem.executive.system.process_usage import shared_memory
from tandem.executive.system.processes import SPARE_AFTER
from tandem.executive.trials.campaigns.crash_rig import PREFIX as RIG_PREFIX
from tandem.executive.trials.campaigns.crash_rig import CrashRig
from tandem.executive.trials.campaigns.crash_world import ITEM, deeds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TASK_STATUS, CancelTask, TaskAnswer, TaskStatus
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.zenoh_bus import ZenohBus
from tandem.trees.registry import discover

SINGLE: Final = 1000
BATCH: Final = 64
BATCHES: Final = 40
ASKED: Final = 600
RESTARTS: Final = 10
TASKS: Final = 10_000
PACE: Final = 0.011
"""Seconds between two requests: one client may ask a hundred times a second."""
LATER: Final = 9e9
"""UTC seconds: these requests only wait."""
FETCH: Final = {"task": "fetch", "item": ITEM, "not_before": LATER}


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    share = 20 if quick else 1
    with tempfile.TemporaryDirectory(prefix="tandem-bench-") as name:
        folder = Path(name)
        yield from _writing(folder, share)
        yield from _acknowledging(folder / "ack", share)
        yield from _going_on(folder / "rig", max(1, RESTARTS // share))
        yield from _remembering(folder / "many", TASKS // share)


def _writing(folder: Path, share: int) -> Iterator[Row]:
    asked = read_request(json.dumps(FETCH).encode(), discover(), load("lab"))
    assert isinstance(asked, Asked)
    ledger = SqliteLedger(folder / "written")
    book = TaskBook(ledger, WallClock(SteppedClocks(), None), "bench", bound=10**9)
    plain, size = _plain(folder / "plain.sqlite"), len(_row_of(book, asked))

    def ours(count: int) -> None:
        for _ in range(count):
            assert book.accept(asked).accepted
        book.keep()

    def theirs(count: int) -> None:
        plain(count, size)

    for what, batch, times in (("single", 1, SINGLE), (f"{BATCH} a commit", BATCH, BATCHES)):
        our, their = _in_turns(partial(ours, batch), partial(theirs, batch), max(1, times // share))
        baseline = batch / quantile(their, 0.5)
        yield Row(f"plain SQLite inserts, {what}", baseline, "1/s", note="baseline: same size, same settings")
        yield Row(
            f"durable requests, {what}", batch / quantile(our, 0.5), "1/s", note=f"of {len(our)} commits"
        )
    ledger.close()


def _row_of(book: TaskBook, asked: Asked) -> str:
    status = book.get(book.accept(asked).task)
    assert status is not None
    return status.model_dump_json()


def _plain(path: Path) -> Callable[[int, int], None]:
    db = sqlite3.connect(path, isolation_level=None)
    for pragma in ("locking_mode = EXCLUSIVE", "journal_mode = WAL", "synchronous = FULL"):
        db.execute(f"PRAGMA {pragma}")
    db.execute("CREATE TABLE t (n INTEGER PRIMARY KEY, text TEXT)")

    def insert(count: int, size: int) -> None:
        db.execute("BEGIN IMMEDIATE")
        for _ in range(count):
            db.execute("INSERT INTO t (text) VALUES (?)", ("x" * size,))
        db.execute("COMMIT")

    return insert


def _in_turns(
    one: Callable[[], None], other: Callable[[], None], times: int
) -> tuple[list[float], list[float]]:
    found: tuple[list[float], list[float]] = ([], [])
    with frozen():
        for _ in range(times):
            for work, taken in zip((one, other), found, strict=True):
                began = time.perf_counter()
                work()
                taken.append(time.perf_counter() - began)
    return found


def _acknowledging(folder: Path, share: int) -> Iterator[Row]:
    folder.mkdir()
    sync = os.open(folder / "synced", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    acks, queries, syncs = list[float](), list[float](), list[float]()
    with running(["executive"], data=folder) as (endpoint, _), echo(endpoint):
        bus = ZenohBus(endpoint, PREFIX)
        time.sleep(0.5)
        document = json.dumps(FETCH).encode()
        with frozen():
            for _ in range(ASKED // share):
                began = time.perf_counter()
                _ask(bus, KEY, document)
                asked = time.perf_counter()
                os.write(sync, b"x" * 1500)
                os.fdatasync(sync)
                synced = time.perf_counter()
                answer = _ask(bus, REQUEST, document)
                acks.append(time.perf_counter() - synced)
                queries.append(asked - began)
                syncs.append(synced - asked)
                _withdraw(bus, answer)
                time.sleep(PACE)
        bus.close()
    os.close(sync)
    for name, share_ in (("median", 0.5), ("p99", 0.99)):
        floor = quantile([a + b for a, b in zip(queries, syncs, strict=True)], share_)
        note = (
            f"query {1e3 * quantile(queries, share_):.2g}, fdatasync {1e3 * quantile(syncs, share_):.2g} ms"
        )
        yield Row(f"a query and an fdatasync, {name}", 1e3 * floor, "ms", note=f"baseline: {note}")
        aim = 1.3e3 * floor
        yield Row(f"from put to acknowledgement, {name}", 1e3 * quantile(acks, share_), "ms", aim)


def _withdraw(bus: ZenohBus, answer: bytes) -> None:
    """Cancel what was just accepted, so that few wait at a time; it must have been accepted."""
    told = TaskAnswer.model_validate_json(answer)
    assert told.accepted, told
    _ask(bus, TASK_CANCEL.key, CancelTask(task=told.task).model_dump_json().encode())


def _ask(bus: ZenohBus, key: str, document: bytes) -> bytes:
    pending = bus.query(key, document)
    while pending.poll() is None and not pending.done():
        bus.waker.wait(0.5)
    return pending.poll() or b""


def _going_on(folder: Path, times: int) -> Iterator[Row]:
    endpoint = free_endpoint()
    with CrashRig(folder, endpoint) as rig:
        found = [_restart(rig, endpoint, number) for number in range(times)]
    note = f"median of {times}; its start included"
    told, acted = (1e3 * quantile(column, 0.5) for column in zip(*found, strict=True))
    yield Row("from the restart until the task is told to run", told, "ms", 300.0, note=note)
    yield Row("from the restart until a skill has its next goal", acted, "ms", note=note)


def _restart(rig: CrashRig, endpoint: str, number: int) -> tuple[float, float]:
    """Kill the executive in the middle of a fetch; return the seconds until the task is told, and goes on."""
    rig.reset()
    time.sleep(SPARE_AFTER)
    rig.tidy()
    time.sleep(1.0)  # it loads
    bus = ZenohBus(endpoint, RIG_PREFIX)  # of its own: the rig may join anew
    statuses = Latest(bus, TASK_STATUS, depth=1024)
    answer = rig.request({"task": "fetch", "item": ITEM, "id": str(number)}, meanwhile=lambda: None)
    _wait(bus, lambda: _searches(statuses))
    rig.kill("executive")
    began, done = time.time(), len(deeds(rig.folder))
    rig.start("executive")
    _wait(bus, lambda: any(each.task == answer.task and each.begun > 1 for each in statuses.take()))
    told = time.time() - began
    _wait(bus, lambda: any(deed.what == "began" for deed in deeds(rig.folder)[done:]))
    acted = next(deed.at for deed in deeds(rig.folder)[done:] if deed.what == "began") - began
    _wait(bus, lambda: any(status.state.terminal for status in statuses.take()))
    bus.close()
    return told, acted


def _searches(statuses: Latest[TaskStatus]) -> bool:
    return any(status.progress.phase in {"search", "pick"} for status in statuses.take())


def _wait(bus: ZenohBus, holds: Callable[[], bool]) -> None:
    end = time.monotonic() + 30.0
    while not holds():
        bus.waker.wait(0.002)
        if time.monotonic() > end:
            raise TimeoutError("nothing went on for 30 s")


def _remembering(folder: Path, count: int) -> Iterator[Row]:
    with running(["executive"], data=folder) as (endpoint, pids):
        bus = ZenohBus(endpoint, PREFIX)
        time.sleep(0.5)
        before, document = shared_memory(pids["executive"]), json.dumps(FETCH).encode()
        for _ in range(count):
            _withdraw(bus, _ask(bus, REQUEST, document))
            time.sleep(PACE)
        after = shared_memory(pids["executive"])
        bus.close()
    yield Row(f"memory after {count} tasks", after, "MB", note=f"{before:.0f} MB before")
