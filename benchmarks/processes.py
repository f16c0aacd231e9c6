"""Processes that benchmarks start beside themselves: router and executive, an echo, and burners."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Final

from pydantic import ValidationError

from benchmarks.machine import command, descendants
from tandem.executive.config.process_settings import WAIT, WorkerSettings
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus

PREFIX: Final = "bench/mock"
_WORKER: Final = "tandem.executive.system.worker"
_NURSERY: Final = "tandem.executive.system.nursery"
THERE_WITHIN: Final = 20.0
_BURN: Final = "import time\nend = time.monotonic() + {seconds}\nwhile time.monotonic() < end: pass"


def free_endpoint() -> str:
    """Return an endpoint on a loopback port that nobody uses."""
    with closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return f"tcp/127.0.0.1:{probe.getsockname()[1]}"


@contextmanager
def running(roles: Sequence[str], data: Path | None = None) -> Iterator[tuple[str, dict[str, int]]]:
    """Start a router and these roles; yields the router's endpoint, and the process ids by role.

    ``data``: folder of the executive's ledger; without it nothing is kept.
    """
    endpoint = free_endpoint()
    started: dict[str, subprocess.Popen[bytes]] = {}
    try:
        for role in ("router", *roles):
            started[role] = _play(role, endpoint, "lab", data)
            await_there(endpoint, "" if role == "router" else f"process/{role}")
        yield endpoint, {role: process.pid for role, process in started.items()}
    finally:
        _end(reversed(started.values()))


@contextmanager
def playing(role: str, endpoint: str, site: str) -> Iterator[None]:
    """Start a role at a router that is there, without waiting for it: its hardware is yet to come."""
    process = _play(role, endpoint, site, None)
    try:
        yield
    finally:
        _end([process])


@contextmanager
def echo(endpoint: str) -> Iterator[None]:
    """Have a process that answers each query at once."""
    process = _start("benchmarks.echo", endpoint)
    try:
        await_there(endpoint, "echo")
        yield
    finally:
        _end([process])


@contextmanager
def burners(count: int, *, most: float) -> Iterator[None]:
    """Keep so many cores busy, for ``most`` seconds at the most."""
    argv = [sys.executable, "-c", _BURN.format(seconds=most)]
    burning = [subprocess.Popen(argv) for _ in range(count)]  # noqa: S603 - our own code
    try:
        yield
    finally:
        _end(burning)


def await_there(endpoint: str, name: str) -> None:
    """Wait until the router answers and ``name`` is announced.

    Raises:
        TimeoutError: when it is not.
    """
    deadline = time.monotonic() + THERE_WITHIN
    while time.monotonic() < deadline:
        try:
            bus = ZenohBus(endpoint, PREFIX, patience=0.5)
        except BusError:
            time.sleep(0.1)
            continue
        there = not name or _hears_of(bus, name)
        bus.close()
        if there:
            return
        time.sleep(0.1)
    raise TimeoutError(f"{name or 'the router'} did not come within {THERE_WITHIN:.0f} s")


def _hears_of(bus: ZenohBus, name: str) -> bool:
    """Say whether a name is announced; a session that has just been opened hears of it after a moment."""
    deadline = time.monotonic() + 0.3
    while name not in bus.alive() and time.monotonic() < deadline:
        bus.waker.wait(0.02)
    return name in bus.alive()


def by_role(pid: int, figure: Callable[[int], float], *, above: str) -> dict[str, float]:
    """Return a figure of each role's process below ``pid`` with its workers, and of ``pid`` as ``above``."""
    found: dict[str, float] = {}
    for each in descendants(pid):
        role = _role(each)
        if role is not None:
            found[role] = found.get(role, 0.0) + sum(figure(part) for part in descendants(each))
    found[above] = figure(pid)
    return found


def _role(pid: int) -> str | None:
    arguments = command(pid)
    if _NURSERY in arguments:
        return "nursery"
    if _WORKER not in arguments:
        return None
    if WAIT in arguments:
        return "spare"
    try:
        return WorkerSettings.model_validate_json(arguments[arguments.index(_WORKER) + 1]).role
    except (ValidationError, IndexError):
        return None


def _play(role: str, endpoint: str, site: str, data: Path | None) -> subprocess.Popen[bytes]:
    settings = WorkerSettings(
        role=role, endpoint=endpoint, prefix=PREFIX, site=site, data=None if data is None else str(data)
    )
    return _start(_WORKER, settings.model_dump_json())


def _start(module: str, argument: str) -> subprocess.Popen[bytes]:
    argv = [sys.executable, "-m", module, argument]
    return subprocess.Popen(argv, stderr=subprocess.DEVNULL)  # noqa: S603 - our own code


def _end(processes: Iterator[subprocess.Popen[bytes]] | Sequence[subprocess.Popen[bytes]]) -> None:
    for process in processes:
        process.terminate()
        try:
            process.wait(5.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
