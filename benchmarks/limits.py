"""What a stranger's questions and documents do to the executive's beats: the longest time between two.

As a program, it is the stranger: ``-m benchmarks.limits ENDPOINT PREFIX BYTES`` sends so much as a cancel.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from typing import Final

from benchmarks.processes import PREFIX, running
from benchmarks.rows import Row
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TASK_INFO, TASK_LIST, AskTasks
from tandem.skills.wire.beats import key_of
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until

TASKS: Final = 990
"""Tasks that are stored; a thousand may wait."""
QUESTIONS: Final = 120
HUGE: Final = 200_000_000
AIM: Final = 0.15
"""Seconds: half of what counts as a process that hangs."""


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    with running(["executive"]) as (endpoint, _):
        bus = ZenohBus(endpoint, PREFIX)
        try:
            _fill(bus, 100 if quick else TASKS)
            yield Row(
                "longest gap between the executive's beats, at rest", _gap(bus, lambda: True, 3.0), "s", AIM
            )
            asked = _gap(bus, Asking(bus), 1.0)
            yield Row(f"the same, {QUESTIONS} task/list of {TASKS} tasks", asked, "s", AIM)
            sent = _gap(bus, Sending(endpoint, 1_000_000 if quick else HUGE), 1.0)
            yield Row(f"the same, a task/cancel of {HUGE // 1_000_000} MB", sent, "s", AIM)
        finally:
            bus.close()


def _fill(bus: ZenohBus, count: int) -> None:
    """Have so many tasks wait: without hardware none begins."""
    document, deadline = json.dumps({"task": "fetch", "item": 29}).encode(), time.monotonic() + 120.0
    while _queued(bus) < count:
        if time.monotonic() > deadline:
            raise RuntimeError(f"only {_queued(bus)} of {count} requests were taken")
        for _ in range(min(50, count - _queued(bus))):
            bus.publish(REQUEST, document)
        bus.waker.wait(0.5)


def _queued(bus: ZenohBus) -> int:
    answer = wait_until(bus, bus.query(TASK_INFO.key, b""), 5.0)
    return 0 if answer is None else TASK_INFO.decode_answer(answer).queued


def _gap(bus: ZenohBus, trouble: Callable[[], bool], seconds: float) -> float:
    """Return the longest time between two beats, from before the trouble until some time after it."""
    beats = bus.subscribe(key_of("executive"))
    last, longest, over, done = time.monotonic(), 0.0, time.monotonic() + seconds, False
    while not done or time.monotonic() < over:
        if not done and trouble():
            done, over = True, time.monotonic() + seconds
        bus.waker.wait(0.005)
        if any(b"executive" in sample.payload.split(b"\n") for sample in beats.drain()):
            longest, last = max(longest, time.monotonic() - last), time.monotonic()
    beats.close()
    return max(longest, time.monotonic() - last)


class Asking:
    """All questions at once; called until all have ended."""

    def __init__(self, bus: ZenohBus) -> None:
        self._bus, self._asked = bus, list[Pending]()

    def __call__(self) -> bool:
        """Ask, the first time; say whether all have ended."""
        if not self._asked:
            self._asked = [TASK_LIST.query(self._bus, AskTasks(), timeout=10.0) for _ in range(QUESTIONS)]
        return all(pending.done() for pending in self._asked)


class Sending:
    """A process of its own sends the huge document, so that it does not stop who listens."""

    def __init__(self, endpoint: str, size: int) -> None:
        argv = [sys.executable, "-m", "benchmarks.limits", endpoint, PREFIX, str(size)]
        self._process = subprocess.Popen(argv)  # noqa: S603 - our own code

    def __call__(self) -> bool:
        """Say whether it has been sent."""
        return self._process.poll() is not None


def main(endpoint: str, prefix: str, size: str) -> None:
    """Send one huge document."""
    bus = ZenohBus(endpoint, prefix)
    wait_until(bus, bus.query(TASK_CANCEL.key, b"x" * int(size)), 5.0)
    bus.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
