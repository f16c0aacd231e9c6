"""What Tandem's processes cost, standing idle and in a fetch: processor seconds and memory of each.

The simulated hardware runs in real time beside them and is counted apart: a robot brings its own.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Final

from benchmarks.processes import by_role, free_endpoint
from benchmarks.rows import Row
from tandem.executive.system.process_usage import processor_seconds, shared_memory

_TANDEM: Final = "from tandem.executive.cli.main import run; run()"
UP: Final = "up"
HARDWARE: Final = "hardware"
SETTLED_AFTER: Final = 5.0
"""Host seconds from "ready" on in which what starts late, such as workers of planners, has come up."""
IDLE_FOR: Final = 30.0
FETCH_WITHIN: Final = 400.0


@dataclass(frozen=True)
class Robot:
    """What is measured of a robot; the aims are in percent of a core, and in megabytes."""

    scenario: str
    processes: str
    request: tuple[str, ...]
    idle: float
    fetch: float
    memory: float


ROBOTS: Final = (
    Robot("Demo", "many", ("fetch", "--item", "29"), idle=10.0, fetch=45.0, memory=450.0),
    Robot("Demo", "few", ("fetch", "--item", "29"), idle=10.0, fetch=45.0, memory=450.0),
    Robot("Locobot", "many", ("fetch", "--item", "5"), idle=6.0, fetch=40.0, memory=350.0),
    Robot("Locobot", "few", ("fetch", "--item", "5"), idle=6.0, fetch=40.0, memory=350.0),
)


def rows() -> Iterator[Row]:
    """Measure."""
    for robot in ROBOTS:
        yield from _rows_of(robot)


def _rows_of(robot: Robot) -> Iterator[Row]:
    endpoint = free_endpoint()
    with tempfile.TemporaryDirectory() as folder, _up(robot, endpoint, Path(folder)) as (pid, ready):
        name = f"{robot.scenario}, {robot.processes} processes"
        yield Row(f"{name}: from `tandem up` to ready", ready, "s", aim=3.0)
        time.sleep(SETTLED_AFTER)
        meter = Meter(pid)
        time.sleep(IDLE_FOR)
        yield from _spent(f"{name}, idle", *meter.spent(), robot.idle)
        yield from _memory(f"{name}, idle", by_role(pid, shared_memory, above=UP), robot.memory)
        meter = Meter(pid)
        ended = _request(robot.request, endpoint)
        yield from _spent(f"{name}, fetch", *meter.spent(), robot.fetch, ended)
        yield from _memory(f"{name}, after it", by_role(pid, shared_memory, above=UP), robot.memory)


class Meter:
    """Counts the processor seconds of each role below a process from now on."""

    def __init__(self, pid: int) -> None:
        self._pid, self._began, self._before = pid, time.monotonic(), _seconds_of(pid)

    def spent(self) -> tuple[dict[str, float], float]:
        """Return the processor seconds of each role, and how many seconds have passed."""
        after = _seconds_of(self._pid)
        return {role: after[role] - self._before.get(role, 0.0) for role in after}, (
            time.monotonic() - self._began
        )


def _seconds_of(pid: int) -> dict[str, float]:
    return by_role(pid, processor_seconds, above=UP)


def _spent(what: str, spent: Mapping[str, float], passed: float, aim: float, note: str = "") -> Iterator[Row]:
    shares = {role: 100.0 * seconds / passed for role, seconds in spent.items()}
    total = sum(share for role, share in shares.items() if role != HARDWARE)
    over = f"over {passed:.0f} s{', ' if note else ''}{note}"
    yield Row(f"{what}: all without the hardware", total, "% of a core", aim=aim, note=over)
    for role, share in sorted(shares.items(), key=lambda each: -each[1]):
        yield Row(f"{what}: {role}", share, "% of a core")


def _memory(what: str, megabytes: Mapping[str, float], aim: float) -> Iterator[Row]:
    total = sum(each for role, each in megabytes.items() if role != HARDWARE)
    each = ", ".join(f"{role} {megabytes[role]:.0f}" for role in sorted(megabytes))
    yield Row(
        f"{what}: memory without the hardware", total, "MB", aim=aim, note=f"proportional share; {each}"
    )


@contextmanager
def _up(robot: Robot, endpoint: str, data: Path) -> Iterator[tuple[int, float]]:
    """Start a system; yields its process, and the seconds until it was ready."""
    given = {"scenario": robot.scenario, "processes": robot.processes, "connect": endpoint, "data": str(data)}
    words = [word for name, value in given.items() for word in (f"--{name}", value)]
    argv = [sys.executable, "-c", _TANDEM, "up", *words]
    began = time.monotonic()
    up = subprocess.Popen(argv, stdout=subprocess.PIPE, text=True)  # noqa: S603 - our own code
    try:
        assert up.stdout is not None
        _await_ready(up.stdout)
        yield up.pid, time.monotonic() - began
    finally:
        up.terminate()
        up.wait(30.0)


def _await_ready(said: IO[str]) -> None:
    for line in said:
        if line.startswith("ready"):
            return
    raise RuntimeError("`tandem up` ended before it was ready")


def _request(words: tuple[str, ...], endpoint: str) -> str:
    argv = [sys.executable, "-c", _TANDEM, "request", *words, "--connect", endpoint, "--wait"]
    done = subprocess.run(  # noqa: S603 - our own code
        argv, capture_output=True, text=True, check=False, timeout=FETCH_WITHIN
    )
    return "succeeded" if done.returncode == 0 else f"exit code {done.returncode}"
