"""A program that reads the robot's topics is stopped in a debugger. The robot must not stop with it.

A user saw: with ``hw/camera/head/rgbd`` or ``**`` subscribed by a process under SIGSTOP, the hardware's
clock, its dead man's switch and its stop stood still for 5 to 20 s, and tasks failed with SKILL_LOST.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import pytest
import zenoh

from tests.fakes.ports import free_endpoint
from tests.outside._readers import readers

SITE: Final = "frozen"
PREFIX: Final = f"{SITE}/tiago"
FROZEN_FOR: Final = 7.0
"""Seconds: a publisher that waits for a reader was held for 5 s, from the second picture on."""
BOUND: Final = 2.0
"""Seconds between two messages; 0.02 on an idle machine, and the machine of the tests is not idle."""


@contextmanager
def hardware(endpoint: str, folder: Path) -> Iterator[None]:
    """Run router and simulated robot, without skills; entered when the robot is ready."""
    command = [sys.executable, "-c", "from executive.cli.main import run; run()", "up"]
    command += ["--connect", endpoint, "--site-key", SITE, "--only", "router,hardware"]
    command += ["--data", str(folder)]
    with (folder / "log").open("w+") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)
        try:
            deadline = time.monotonic() + 90.0
            while "ready" not in (folder / "log").read_text() and time.monotonic() < deadline:
                assert process.poll() is None, (folder / "log").read_text()
                time.sleep(0.1)
            yield
        finally:
            os.killpg(process.pid, signal.SIGINT)
            process.wait(30)


class Gaps:
    """When messages of a key came: the longest time without one."""

    def __init__(self, session: zenoh.Session, key: str) -> None:
        self.count, self.longest, self._last = 0, 0.0, time.monotonic()
        self._subscriber = session.declare_subscriber(key, self._came)

    def _came(self, _: zenoh.Sample) -> None:
        now = time.monotonic()
        self.count, self.longest, self._last = self.count + 1, max(self.longest, now - self._last), now

    def begin(self) -> None:
        """Count from now on."""
        self.count, self.longest, self._last = 0, 0.0, time.monotonic()


def client(endpoint: str) -> zenoh.Session:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps([endpoint]))
    return zenoh.open(config)


@pytest.mark.processes
def test_the_robot_goes_on_while_its_readers_stand_still(tmp_path: Path) -> None:
    endpoint = free_endpoint()
    with (
        hardware(endpoint, tmp_path),
        client(endpoint) as session,
        readers(endpoint, "**", 2) as everything,
        readers(endpoint, f"{PREFIX}/hw/camera/head/rgbd", 1) as pictures,
    ):
        heard = {key: Gaps(session, f"{PREFIX}/{key}") for key in ("hw/clock", "hw/joints/state", "beat")}
        seen = Gaps(session, f"{PREFIX}/hw/camera/head/rgbd")
        until(lambda: seen.count > 1, 30.0)
        for reader in (*everything, *pictures):
            reader.freeze()
        for each in (*heard.values(), seen):
            each.begin()
        end = time.monotonic() + FROZEN_FOR
        until(lambda: time.monotonic() >= end, FROZEN_FOR + 1.0)
        longest = {key: max(each.longest, time.monotonic() - each._last) for key, each in heard.items()}
        assert max(longest.values()) < BOUND, longest
        assert seen.count > 5, "a reader that reads gets its pictures"


def until(condition: object, within: float) -> None:
    deadline = time.monotonic() + within
    assert callable(condition)
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)
