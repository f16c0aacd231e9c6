"""`tandem up` as a process of its own, and a plain zenoh session beside it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import zenoh

READY_WITHIN: Final = 120.0
"""Seconds; 4 on an idle machine."""


@contextmanager
def up(endpoint: str, site: str, folder: Path, *, only: str = "") -> Iterator[Path]:
    """Run a system's processes, or some; entered with their log when they are ready, ended with Ctrl-C."""
    command = [sys.executable, "-m", "tandem", "up"]
    command += ["--only", only] if only else []
    command += ["--connect", endpoint, "--site-key", site, "--data", str(folder / "data")]
    path = folder / "log"
    with path.open("w") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)
        try:
            until(lambda: process.poll() is not None or "ready" in path.read_text(), READY_WITHIN)
            assert process.poll() is None, path.read_text()
            yield path
        finally:
            os.killpg(process.pid, signal.SIGINT)
            process.wait(60)


def client(endpoint: str) -> zenoh.Session:
    """Connect as any program does; leave it with ``with``."""
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps([endpoint]))
    config.insert_json5("scouting/multicast/enabled", "false")
    return zenoh.open(config)


def until(condition: Callable[[], bool], within: float) -> None:
    """Wait for something to become true, as seconds of the host go; else the test fails."""
    deadline = time.monotonic() + within
    while not condition():
        assert time.monotonic() < deadline, f"not within {within:.0f} s"
        time.sleep(0.02)
