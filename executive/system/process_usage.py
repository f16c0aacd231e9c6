"""What the kernel tells of a process: memory, processor time, handles, threads; out of Linux's ``/proc``."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Final

_PROC: Final = Path("/proc")


@dataclass(frozen=True)
class Usage:
    """Anonymous memory in megabytes, open handles, threads."""

    memory: float
    handles: int
    threads: int


def usage(pid: int) -> Usage:
    """Read a process's usage.

    Raises:
        OSError: when there is no such process.
    """
    about = _PROC / str(pid)
    return Usage(
        memory=anonymous_memory(pid) / 1e6,
        handles=len(os.listdir(about / "fd")),  # noqa: PTH208 - names are enough, and no path is made of them
        threads=len(os.listdir(about / "task")),  # noqa: PTH208
    )


def anonymous_memory(pid: int) -> int:
    """Return the bytes of a process's memory that stand for no file.

    Raises:
        OSError: when there is no such process.
    """
    kilobytes = _kilobytes(pid, "smaps_rollup", "Anonymous")
    if kilobytes is None:
        raise ProcessLookupError(f"no memory is told of process {pid}")
    return 1024 * kilobytes


def shared_memory(pid: int) -> float:
    """Return a process's proportional share of memory (PSS) in MiB; its resident size where none is told."""
    for name, about in (("smaps_rollup", "Pss"), ("status", "VmRSS")):
        try:
            kilobytes = _kilobytes(pid, name, about)
        except OSError:
            continue
        if kilobytes is not None:
            return kilobytes / 1024.0
    return float("nan")


def processor_seconds(pid: int) -> float:
    """Return the processor seconds that a process has used until now; 0 when it has ended."""
    try:
        text = (_PROC / str(pid) / "stat").read_text(encoding="utf-8")
    except OSError:
        return 0.0
    user, system = text.rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


def _kilobytes(pid: int, file: str, about: str) -> int | None:
    """Return a line of a file of a process; None where it has none."""
    text = (_PROC / str(pid) / file).read_text(encoding="utf-8")
    found = re.search(rf"^{about}:\s+(\d+) kB", text, re.MULTILINE)
    return None if found is None else int(found[1])
