"""A program that forks a worker and says what came of it; what runs tests has threads."""

from __future__ import annotations

import json
import math
import os
import signal
import sys
from collections.abc import Callable

from tandem.skills.ports.compute import Job
from tandem.skills.wire.forked_worker import fork_worker
from tandem.skills.wire.workers import ProcessCompute
from tandem.skills.wire.zenoh_ends import Waker


class OddError(Exception):
    """One that can't be read again once it is written."""

    def __init__(self, one: int, two: int) -> None:
        super().__init__(one + two)


def raise_odd(number: int) -> None:
    """Raise it."""
    raise OddError(number, number)


def process_id(_: None) -> int:
    """Return whose process this is."""
    return os.getpid()


def size_of(payload: bytes) -> int:
    """Return how much came."""
    return len(payload)


def main(*, once: bool) -> dict[str, object]:
    """Give it work of several kinds, at last its own death."""
    worker, waker = fork_worker(lambda: None), Waker()
    assert worker is not None, "this process has one thread"
    forked = worker.pid
    compute = ProcessCompute(waker.wake, worker, once=once)

    def ended(job: Job[object]) -> str:
        while not job.done():
            waker.wait(1.0)
        try:
            return str(job.result())
        except Exception as error:  # noqa: BLE001 - what it is, is what is asked for
            return type(error).__name__

    said: dict[str, object] = {"forked": forked}
    said["together"] = [
        ended(job) for job in [compute.submit(math.sqrt, float(n), cost=0.0) for n in range(3)]
    ]
    said["by"] = ended(compute.submit(process_id, None, cost=0.0))
    said["large"] = ended(compute.submit(size_of, bytes(2_000_000), cost=0.0))
    said["raised"] = ended(compute.submit(math.sqrt, -1.0, cost=0.0))
    said["odd"] = ended(compute.submit(raise_odd, 1, cost=0.0))
    kill: Callable[[int], None] = signal.raise_signal
    said["died"] = ended(compute.submit(kill, int(signal.SIGKILL), cost=0.0))
    said["after"] = ended(compute.submit(process_id, None, cost=0.0))
    compute.close()
    return said


if __name__ == "__main__":
    print(json.dumps(main(once=sys.argv[1:] == ["once"])))  # noqa: T201 - it is what the test reads
