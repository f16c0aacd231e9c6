"""Work that is done in slices, run in one go where nobody waits: benchmarks, drawings, searches offline."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar

T = TypeVar("T")


def run_through(steps: Generator[object, None, T]) -> T:
    """Run all slices, one after the other, and return what the last one ends with."""
    while True:
        try:
            next(steps)
        except StopIteration as stop:
            ended: T = stop.value
            return ended
