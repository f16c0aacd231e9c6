"""Programs of other people on the robot's network: each hears everything, and stops reading when told to."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Final

_PROGRAM: Final = """
import json, sys, time, zenoh
endpoint, expression = sys.argv[1:]
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([endpoint]))
config.insert_json5("scouting/multicast/enabled", "false")
with zenoh.open(config) as session:
    subscriber = session.declare_subscriber(expression, lambda sample: None)
    print("listens", flush=True)
    sys.stdin.read()
"""


@dataclass(frozen=True)
class Reader:
    """A process that subscribes, with zenoh and nothing of ours."""

    process: subprocess.Popen[str]

    def freeze(self) -> None:
        """Stop it as a debugger does: its connection stays open, and nothing is read from it."""
        self.process.send_signal(signal.SIGSTOP)

    def thaw(self) -> None:
        """Let it go on."""
        self.process.send_signal(signal.SIGCONT)


@contextmanager
def readers(endpoint: str, expression: str, count: int) -> Iterator[list[Reader]]:
    """Start so many; they listen when this enters, and are gone when it leaves."""
    started: list[Reader] = []
    try:
        for _ in range(count):
            process = subprocess.Popen(
                [sys.executable, "-c", _PROGRAM, endpoint, expression],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            started.append(Reader(process))
        for reader in started:
            assert reader.process.stdout is not None
            assert reader.process.stdout.readline().strip() == "listens"
        yield started
    finally:
        for reader in started:
            reader.process.kill()
            reader.process.wait()
