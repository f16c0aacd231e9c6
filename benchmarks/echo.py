"""A process that answers each query with what was asked: the baseline of every answer over the bus."""

from __future__ import annotations

import os
import signal
import sys
from types import FrameType

from benchmarks.processes import PREFIX
from tandem.skills.wire.zenoh_bus import ZenohBus

KEY = "bench/echo"


def main(endpoint: str) -> None:
    """Answer until told to end, or until the parent is gone."""
    told: list[int] = []

    def end(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - as signal calls it
        told.append(number)

    signal.signal(signal.SIGTERM, end)
    bus, parent = ZenohBus(endpoint, PREFIX), os.getppid()
    desk = bus.serve(KEY)
    bus.announce("echo")
    while not told and os.getppid() == parent:
        bus.waker.wait(0.1)
        for request in desk.drain():
            request.reply(request.payload)
    bus.close()


if __name__ == "__main__":
    main(sys.argv[1])
