"""The machine: what it is, and how busy others keep it while something is measured."""

from __future__ import annotations

import gc
import os
import platform
import resource
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from tandem.executive.trials.provenance import installed_packages, processor

_PROC: Final = Path("/proc")


def describe() -> str:
    """Return processor, cores, system, versions and load in one line."""
    versions = ", ".join(f"{name} {version}" for name, version in installed_packages().items())
    load = os.getloadavg()[0]
    return (
        f"{processor()}, {os.cpu_count()} cores, load average {load:.1f} before; {platform.system()} "
        f"{platform.release()}; Python {platform.python_version()}; {versions}"
    )


class Others:
    """Counts the processor time of everybody but this process and the children that it has waited for."""

    def __init__(self) -> None:
        """Count from now on."""
        self._began, self._busy, self._own = time.monotonic(), _busy_seconds(), _own_seconds()

    def cores(self) -> float | None:
        """Return how many cores others kept busy since this was made; None where the system tells nothing."""
        busy, own = _busy_seconds() - self._busy, _own_seconds() - self._own
        passed = time.monotonic() - self._began
        if not self._busy or passed <= 0.0:
            return None
        return max(0.0, (busy - own) / passed)


@contextmanager
def frozen() -> Iterator[None]:
    """Keep the collector away from all that was made until now, as a process of the system does."""
    gc.collect()
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()


def descendants(pid: int) -> list[int]:
    """Return a process and all below it."""
    below: list[int] = []
    for children in (_PROC / str(pid) / "task").glob("*/children"):
        try:
            below += [int(child) for child in children.read_text(encoding="utf-8").split()]
        except OSError:
            continue  # ended meanwhile
    return [pid, *(each for child in below for each in descendants(child))]


def command(pid: int) -> list[str]:
    """Return a process's arguments; empty when it has ended."""
    try:
        return (_PROC / str(pid) / "cmdline").read_text(encoding="utf-8").split("\0")
    except OSError:
        return []


def _busy_seconds() -> float:
    try:
        first = (_PROC / "stat").read_text(encoding="utf-8").split("\n", 1)[0]
    except OSError:
        return 0.0
    user, nice, system, _idle, _wait, irq, soft, steal = (int(each) for each in first.split()[1:9])
    return (user + nice + system + irq + soft + steal) / os.sysconf("SC_CLK_TCK")


def _own_seconds() -> float:
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, kinds))
