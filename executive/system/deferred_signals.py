"""Ctrl-C and SIGTERM that wait while something is done that must not be left half done."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Iterator
from types import FrameType


@contextlib.contextmanager
def signals_later() -> Iterator[None]:
    """Have Ctrl-C and SIGTERM wait: a process that was just started, and is not noted yet, would be left."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[tuple[int, FrameType | None]] = []
    numbers = (signal.SIGINT, signal.SIGTERM)
    handlers = [signal.getsignal(number) for number in numbers]
    caught = [number for number, known in zip(numbers, handlers, strict=True) if callable(known)]
    for number in caught:
        signal.signal(number, lambda which, frame: came.append((which, frame)))
    try:
        yield
    finally:
        for number, known in zip(numbers, handlers, strict=True):
            if number in caught:
                signal.signal(number, known)
        for which, frame in came:
            known = signal.getsignal(which)
            if callable(known):
                known(which, frame)
