"""A process's command line, as others see it."""

from __future__ import annotations

import ctypes
from pathlib import Path


def show(words: list[str]) -> None:
    """Write this process's command line anew, for ``ps`` and for who looks for a role; if there is room."""
    fields = Path("/proc/self/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    start, end = int(fields[45]), int(fields[46])
    text = b"\0".join(word.encode() for word in words) + b"\0"
    if start and len(text) <= end - start:
        ctypes.memmove(start, text.ljust(end - start, b"\0"), end - start)
