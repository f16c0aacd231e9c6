"""How fast the executive reacts, over zenoh: to a request with a first tick, to an event with the next goal.

Router and executive are processes of their own; the skills are mocked in this one, so that both ends of each
reaction are read off one clock: the end of a skill's goal is put on the bus, and the next skill's goal comes.
Beside them, as baseline, a query that is answered at once.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from benchmarks.echo import KEY
from benchmarks.machine import frozen
from benchmarks.processes import PREFIX, burners, echo, running
from benchmarks.rows import Row, quantile, spread
from benchmarks.ticks import FETCH, ITEMS, forget
from tandem.executive.system.process_usage import shared_memory
from tandem.skills.ports.bus import Bus, Desk, Inbox, Pending
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.keys import CLOCK, Latest
from tandem.skills.ports.lease import Lease
from tandem.skills.ports.message import MAX_REQUEST_BYTES, RobotTime
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TASK_STATUS, TREE, CancelTask
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.keyed_queue import DESK_DEPTH, KeyedQueue
from tandem.skills.wire.zenoh_bus import ZenohBus
from tandem.skills.wire.zenoh_ends import ZenohDesk, ZenohRequest

FETCHES: Final = 24
REQUESTS: Final = 100
PINGS: Final = 400
SKILL_SECONDS: Final = 0.03
PATIENCE: Final = 10.0
"""Seconds that one request is waited for: beside as many burners as cores 2 s were too few at times."""
FIRST_MEDIAN: Final = 4.0
"""Milliseconds from a request's put to the first tick: somebody who pressed a button sees no delay."""
FIRST_P99: Final = 10.0
"""Likewise of the slow ones: one period of the hardware."""
SYNCS: Final = 200
COMMITTED: Final = 8192
"""Bytes: a commit with one task appends two pages of the ledger's write-ahead log."""
LOADED_FOR: Final = 120.0
"""Seconds after which the burners end by themselves."""


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    share = 12 if quick else 1
    cores = os.cpu_count() or 1
    with running(["executive"]) as (endpoint, pids), echo(endpoint):
        yield from _once(endpoint, share, "", aim=2.0)
        with burners(cores, most=LOADED_FOR):
            yield from _once(endpoint, share * 2, f" ({cores} burners on {cores} cores)", aim=None)
        yield Row("memory of the executive alone", shared_memory(pids["executive"]), "MB")
    yield from _with_ledger(share)


def _once(endpoint: str, share: int, under: str, *, aim: float | None) -> Iterator[Row]:
    pings = ping_times(endpoint, PINGS // share)
    yield Row(
        f"query and answer{under}, median",
        1e3 * quantile(pings, 0.5),
        "ms",
        note=f"baseline: the bus alone; p99 {1e3 * quantile(pings, 0.99):.2g} ms",
    )
    reactions = reaction_times(endpoint, max(1, FETCHES // share))
    yield from spread(f"from a skill's end to the next goal{under}", reactions, aim=aim)
    yield from _firsts(
        f"from a request's put to the first tick{under}", endpoint, share, aims=aim is not None
    )


def _firsts(what: str, endpoint: str, share: int, *, aims: bool) -> Iterator[Row]:
    firsts = request_times(endpoint, REQUESTS // share)
    note = f"of {len(firsts)}, until a client has the tree"
    for name, quota, aim in (("median", 0.5, FIRST_MEDIAN), ("p99", 0.99, FIRST_P99)):
        yield Row(f"{what}, {name}", 1e3 * quantile(firsts, quota), "ms", aim if aims else None, note=note)


def _with_ledger(share: int) -> Iterator[Row]:
    """Measure the first tick of an executive with a ledger, and what its disk takes to keep something."""
    with tempfile.TemporaryDirectory(prefix="tandem-bench-") as name:
        folder = Path(name)
        with running(["executive"], data=folder) as (endpoint, _):
            syncs = [*sync_times(folder / "synced", SYNCS // share)]
            note = f"baseline: the disk alone; p99 {1e3 * quantile(syncs, 0.99):.2g} ms"
            yield Row("an fdatasync, median", 1e3 * quantile(syncs, 0.5), "ms", note=note)
            yield from _firsts(
                "from a request's put to the first tick, with a ledger", endpoint, share, aims=True
            )


def sync_times(path: Path, count: int) -> Iterator[float]:
    """Yield the seconds of so many fdatasyncs, each of some kilobytes as a commit of the ledger has."""
    file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    try:
        for _ in range(count):
            began = time.perf_counter()
            os.write(file, b"x" * COMMITTED)
            os.fdatasync(file)
            yield time.perf_counter() - began
    finally:
        os.close(file)


def ping_times(endpoint: str, count: int) -> list[float]:
    """Return the seconds of so many queries."""
    bus = ZenohBus(endpoint, PREFIX)
    found: list[float] = []
    try:
        for _ in range(count):
            began = time.perf_counter()
            pending = bus.query(KEY, FETCH)
            while pending.poll() is None and not pending.done():
                bus.waker.wait(0.5)
            found.append(time.perf_counter() - began)
            time.sleep(0.001)
    finally:
        bus.close()
    return found


def reaction_times(endpoint: str, fetches: int) -> list[float]:
    """Return the seconds from each end of a skill's goal to the next goal, over some fetches."""
    bus = ZenohBus(endpoint, PREFIX)
    spy, clocks = Spy(bus), ProcessClocks(bus)
    robot = MockRobot(spy, clocks, load("lab"), items=ITEMS, duration=SKILL_SECONDS, localised=True)
    try:
        with frozen():  # this process's collector is none of the executive's time
            _fetch(spy, bus, robot, clocks, fetches)
    finally:
        bus.close()
    return spy.reactions


def request_times(endpoint: str, count: int) -> list[float]:
    """Return the seconds from a request's put to its first tick's tree, each task being cancelled then."""
    bus = ZenohBus(endpoint, PREFIX)
    trees, statuses = Latest(bus, TREE), Latest(bus, TASK_STATUS)
    # A robot that has told where it is: the queue is held for one that has not.
    clocks = ProcessClocks(bus)
    robot = MockRobot(bus, clocks, load("lab"), items=ITEMS, duration=SKILL_SECONDS, localised=True)
    found: list[float] = []
    seen: set[str] = set()  # what is kept for who comes late may come once more
    since = time.monotonic()
    while time.monotonic() - since < 0.5:
        _tick(bus, since)
        clocks.refresh()
        robot.step()
        bus.waker.wait(0.01)
    robot.tell()
    try:
        for _ in range(count):
            trees.take()
            _tick(bus, since)
            began = time.perf_counter()
            bus.publish(REQUEST, FETCH)
            tree = None
            while tree is None and time.perf_counter() - began < PATIENCE:
                bus.waker.wait(0.5)
                arrived = time.perf_counter()
                told = (each for each in trees.take() if each.tick == 1 and each.task not in seen)
                tree = next(told, None)
            if tree is None:
                continue
            seen.add(tree.task)
            found.append(arrived - began)
            TASK_CANCEL.query(bus, CancelTask(task=tree.task))
            over = False
            while not over and time.perf_counter() - began < PATIENCE:
                _tick(bus, since)
                clocks.refresh()
                robot.step()
                bus.waker.wait(0.01)
                over = any(each.state.terminal for each in statuses.take() if each.task == tree.task)
    finally:
        bus.close()
    return found


def _tick(bus: ZenohBus, since: float) -> None:
    """Tell the robot's clock: no task begins while the hardware is silent."""
    seconds = time.monotonic() - since
    CLOCK.publish(bus, Clock(stamp=RobotTime(boot="requests", seconds=seconds), tick=int(seconds * 100.0)))


class Arrivals(KeyedQueue[ZenohRequest]):
    """What waits at a desk; tells a spy the moment that something comes."""

    def __init__(self, spy: Spy) -> None:
        """Start empty."""
        super().__init__(DESK_DEPTH, "newest goes")
        self._spy = spy

    def put(self, key: str, request: ZenohRequest, /) -> None:
        """Take a query in."""
        now, began = time.perf_counter(), self._spy.ended_at
        if began is not None:
            self._spy.reactions.append(now - began)
            self._spy.ended_at = None
        super().put(key, request)


class Spy:
    """A bus that notes when a goal has ended, and when the next one comes."""

    def __init__(self, bus: Bus) -> None:
        """Stand before ``bus``."""
        self.bus = bus
        self.reactions: list[float] = []
        self.ended_at: float | None = None

    @property
    def ear(self) -> Ear:
        """The inner bus's."""
        return self.bus.ear

    def publish(self, key: str, payload: bytes) -> None:
        """Send; an end of a goal starts the stop-watch."""
        if key.startswith("skill/") and key.endswith("/status") and b'"SUCCEEDED"' in payload:
            self.ended_at = time.perf_counter()
        self.bus.publish(key, payload)

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries; a goal stops the stop-watch."""
        desk = self.bus.serve(key, limit=limit)
        if key.endswith("/goal") and isinstance(desk, ZenohDesk):
            desk.waiting = Arrivals(self)
        return desk

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """As the bus."""
        return self.bus.subscribe(key, depth=depth)

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """As the bus."""
        return self.bus.query(key, payload, timeout=timeout)

    def listened(self, key: str) -> bool:
        """As the bus."""
        return self.bus.listened(key)

    def announce(self, name: str) -> None:
        """As the bus."""
        self.bus.announce(name)

    def alive(self) -> frozenset[str]:
        """As the bus."""
        return self.bus.alive()

    def awake(self) -> frozenset[str]:
        """As the bus."""
        return self.bus.awake()

    def goes_on(self, name: str) -> bool:
        """As the bus."""
        return self.bus.goes_on(name)

    def lease(self) -> Lease | None:
        """Return the lease of this process's role."""
        return self.bus.lease()


def _fetch(spy: Spy, bus: ZenohBus, robot: MockRobot, clocks: ProcessClocks, fetches: int) -> None:
    statuses = Latest(bus, TASK_STATUS)
    began, ended, tick = time.monotonic(), 0, 0
    _settle(bus, robot, clocks, began)
    bus.publish(REQUEST, FETCH)
    while ended < fetches and time.monotonic() - began < LOADED_FOR:
        tick = _beat(bus, robot, clocks, began, tick)
        over = [status for status in statuses.take() if status.state.terminal]
        ended += len(over)
        if over and ended < fetches:
            spy.ended_at = None
            forget(robot)
            bus.publish(REQUEST, FETCH)
        bus.waker.wait(0.002)


def _settle(bus: ZenohBus, robot: MockRobot, clocks: ProcessClocks, began: float) -> None:
    """Let subscriptions find each other, and the executive learn what is believed."""
    tick = 0
    while time.monotonic() - began < 2.0:
        tick = _beat(bus, robot, clocks, began, tick)
        if tick % 50 == 0:
            robot.tell()
        bus.waker.wait(0.01)


def _beat(bus: ZenohBus, robot: MockRobot, clocks: ProcessClocks, began: float, tick: int) -> int:
    """Let the mocked robot live for a moment; its clock ticks a hundred times a second."""
    seconds = time.monotonic() - began
    now = int(seconds * 100.0)
    if now > tick:
        stamp = RobotTime(boot="bench", seconds=seconds)
        CLOCK.publish(bus, Clock(stamp=stamp, tick=now))
    clocks.refresh()
    robot.step()
    return max(now, tick)
