"""``tandem demo`` as processes in real time, watched from the bus: start, standing still, memory."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from benchmarks.processes import by_role, free_endpoint
from benchmarks.rows import Row
from benchmarks.stillness import Stillness
from tandem.executive.config.run_options import BusOptions
from tandem.executive.system.crews import roles_of
from tandem.executive.system.process_usage import shared_memory
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.keys import CLOCK, Latest
from tandem.skills.ports.tasks import TASK_STATUS, TaskState, TaskStatus
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus

_TANDEM: Final = "from tandem.executive.cli.main import run; run()"
STARTED_WITHIN: Final = 60.0
WITHIN: Final = 240.0
MEMORY_EVERY: Final = 3.0
"""Seconds between two looks at the memory."""


@dataclass
class Seen:
    """What was seen of a demo. Host seconds since it was called."""

    ready: float = float("nan")
    moving: float = float("nan")
    ended: TaskStatus | None = None
    memory: dict[str, float] = field(default_factory=dict)
    """The most megabytes of each role."""


def rows() -> Iterator[Row]:
    """Measure."""
    options = BusOptions(endpoint=free_endpoint())
    with tempfile.TemporaryDirectory() as folder:
        picture = str(Path(folder) / "scene.png")
        argv = [sys.executable, "-c", _TANDEM, "demo", "--connect", options.endpoint, "--picture", picture]
        began = time.monotonic()
        demo = subprocess.Popen(argv, stdout=subprocess.DEVNULL)  # noqa: S603 - our own code
        try:
            bus = _connect(options)
            try:
                stillness = Stillness(bus)
                seen = watch(demo, bus, stillness, began)
            finally:
                bus.close()
            code = demo.wait(60.0)
        finally:
            if demo.poll() is None:
                demo.terminate()
                demo.wait(30.0)
    yield from _lines(seen, stillness, code)


def watch(demo: subprocess.Popen[bytes], bus: ZenohBus, stillness: Stillness, began: float) -> Seen:
    """Watch the demo until its task has ended."""
    seen, statuses, clock = Seen(), Latest(bus, TASK_STATUS, depth=1024), Latest(bus, CLOCK)
    looked = began
    while demo.poll() is None and time.monotonic() - began < WITHIN:
        bus.waker.wait(0.05)
        stillness.step()
        now = time.monotonic()
        clock.refresh()
        for status in statuses.take():
            if status.state is TaskState.RUNNING and seen.ready != seen.ready:
                seen.ready = now - began
            if status.state.terminal:
                seen.ended = status
        if stillness.moved_at is not None and seen.moving != seen.moving:
            seen.moving = now - began
        if seen.ended is not None:
            break
        if now - looked > MEMORY_EVERY:
            looked = now
            for role, megabytes in by_role(demo.pid, shared_memory, above="demo").items():
                seen.memory[role] = max(megabytes, seen.memory.get(role, 0.0))
    return seen


def _connect(options: BusOptions) -> ZenohBus:
    deadline = time.monotonic() + STARTED_WITHIN
    while True:
        try:
            return ZenohBus(options.endpoint, options.prefix, patience=0.2)
        except BusError:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.05)


def _lines(seen: Seen, stillness: Stillness, code: int) -> Iterator[Row]:
    ended = "no end" if seen.ended is None else seen.ended.state.value.lower()
    if seen.ended is not None and seen.ended.failure is not None:
        ended += f" ({seen.ended.failure.where}: {seen.ended.failure.message})"
    yield Row("from `tandem demo` to the task's start", seen.ready, "s")
    yield Row("from `tandem demo` to the first motion", seen.moving, "s")
    note = f"real time, processes; {ended}, exit code {code}"
    yield Row("demo, the task", stillness.total, "robot s", note=note)
    note = "standing without a look, a localisation or a grip under way"
    share = 100.0 * stillness.idle_share
    yield Row("demo, standing still for the executive's sake", share, "% of the task", 5.0, note=note)
    for what in sorted(stillness.seconds, key=lambda name: -stillness.seconds[name]):
        spent = stillness.seconds[what]
        which = "moving" if what == "moving" else f"standing, {what}"
        yield Row(f"demo, {which}", spent, "robot s", note=f"{100.0 * spent / stillness.total:.1f} %")
    for role in (*roles_of(load_scenario("Demo")), "demo"):
        if role in seen.memory:
            yield Row(f"memory, {role}", seen.memory[role], "MB", note="most, proportional share")
    yield Row("memory, all processes", sum(seen.memory.values()), "MB")
