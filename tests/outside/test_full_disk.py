"""The disk of the skills' host is full.

A user would have seen the processes of base and keeper end with a trace, start again three times, and take
`tandem up` with them; and, after a restart of the robot's unit, a robot that had forgotten what it holds.
"""

from __future__ import annotations

import resource
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tandem.client import Client
from tests.outside._command import free_port, running

SITE = "full-disk"
WITHIN = 180.0
"""Seconds, on a machine that others use, too."""


def pid_of(role: str) -> int:
    """Return the process that plays a role at this test's site."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes().decode("utf-8", "replace")
        except OSError:
            continue
        if f'"role":"{role}"' in words and f'"prefix":"{SITE}/' in words:
            return int(entry.name)
    raise AssertionError(f"no process plays {role}")


@contextmanager
def full(*pids: int) -> Iterator[None]:
    """Have the kernel refuse whatever these processes write to files."""
    before = [resource.prlimit(pid, resource.RLIMIT_FSIZE) for pid in pids]
    for pid, (_, hard) in zip(pids, before, strict=True):
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (0, hard))
    try:
        yield
    finally:
        for pid, limits in zip(pids, before, strict=True):
            resource.prlimit(pid, resource.RLIMIT_FSIZE, limits)


def until(holds: Callable[[], bool], what: str) -> None:
    """Wait until something holds."""
    deadline, pause = time.monotonic() + WITHIN, threading.Event()
    while not holds():
        assert time.monotonic() < deadline, f"{what} within {WITHIN:.0f} s"
        pause.wait(0.1)


@pytest.mark.processes
@pytest.mark.xdist_group("full-disk")
def test_goals_are_refused_while_the_disk_is_full_and_taken_once_there_is_space(tmp_path: Path) -> None:
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    words = ("up", "--connect", endpoint, "--site-key", SITE, "--data", str(tmp_path / "data"))
    with running(*words) as up:
        up.await_word("ready")
        assert (tmp_path / "data" / "held.jsonl").is_file()
        pids = {role: pid_of(role) for role in ("base", "keeper")}
        with Client(endpoint, site=SITE, patience=WITHIN) as client:
            with full(*pids.values()):
                refused = client.submit({"task": "fetch", "item": 29})
                until(lambda: bool(client.status(refused).tried), "something was tried in vain")
                assert client.status(refused).tried[0].failure.kind == "NOT_STORED"
                client.cancel(refused)
                until(lambda: client.status(refused).state.terminal, "the cancelled task ended")
            taken = client.submit({"task": "fetch", "item": 29})
            until(lambda: client.status(taken).progress.phase == "search", "the robot knew where it is")
            client.cancel(taken)
            until(lambda: client.status(taken).state.terminal, "the cancelled task ended")
        assert {role: pid_of(role) for role in pids} == pids
