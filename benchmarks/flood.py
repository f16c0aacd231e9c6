"""A client that asks far too often, beside one that asks now and then: what the second one feels.

As a program, it is the one that asks too often: ``-m benchmarks.flood ENDPOINT PREFIX NAME RATE SECONDS``.
It puts nine requests and queries the tenth: Python's queries alone come to some 2,000 a second.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from typing import Final

from benchmarks.processes import PREFIX, running
from benchmarks.rows import Row, quantile
from tandem.skills.ports.tasks import REQUEST, TaskAnswer, by_client
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until

RATE: Final = 10_000
SECONDS: Final = 6.0
BATCH: Final = 50
"""Requests that are sent at once, so that the clock is not read for each."""


def main(endpoint: str, prefix: str, name: str, rate: str, seconds: str) -> None:
    """Ask as often as told; print how many were sent in how many seconds."""
    bus = ZenohBus(endpoint, prefix)
    key, document = by_client(name, REQUEST), json.dumps({"task": "fetch", "item": 29}).encode()
    began, sent = time.monotonic(), 0
    while (now := time.monotonic() - began) < float(seconds):
        if sent < now * float(rate):
            for number in range(BATCH):
                if number % 10:
                    bus.publish(key, document)
                else:
                    bus.query(key, document)
            sent += BATCH
        else:
            bus.waker.wait(0.0005)
    took = time.monotonic() - began
    print(f"{sent} {took:.3f}", flush=True)
    bus.close()


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    seconds = 2.0 if quick else SECONDS
    with running(["executive"]) as (endpoint, _):
        quiet = answer_times(endpoint, 1.0)
        argv = [sys.executable, "-m", "benchmarks.flood", endpoint, PREFIX, "flood", str(RATE), str(seconds)]
        with subprocess.Popen(argv, stdout=subprocess.PIPE, text=True) as flood:  # noqa: S603 - our own code
            time.sleep(0.7)  # its start
            beside = answer_times(endpoint, seconds - 1.0)
            said, _ = flood.communicate()
    sent, took = (float(word) for word in said.split())
    alone = 1e3 * quantile(quiet, 0.99)
    note = f"{sent / took:.0f} requests a second from another client; alone: {alone:.2g} ms"
    yield Row("a request's answer beside a flood, median", 1e3 * quantile(beside, 0.5), "ms")
    yield Row("a request's answer beside a flood, p99", 1e3 * quantile(beside, 0.99), "ms", note=note)
    lost = sum(each == float("inf") for each in beside)
    yield Row("requests without an answer beside a flood", lost, f"of {len(beside)}", aim=0)


def answer_times(endpoint: str, seconds: float) -> list[float]:
    """Return the seconds until each request of a polite client was answered; infinite for none."""
    bus = ZenohBus(endpoint, PREFIX)
    document = json.dumps({"task": "fetch", "item": 587}).encode()  # refused: the queue stays as it is
    times, end = [], time.monotonic() + seconds
    while time.monotonic() < end:
        began = time.perf_counter()
        answer = wait_until(bus, bus.query(by_client("polite", REQUEST), document), 2.0)
        right = answer is not None and bool(TaskAnswer.model_validate_json(answer).problems)
        times.append(time.perf_counter() - began if right else float("inf"))
        time.sleep(0.02)
    bus.close()
    return times


if __name__ == "__main__":
    main(*sys.argv[1:])
