"""How a command that has started processes is ended: once, by whichever signal comes first."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from types import FrameType
from typing import Final

ENDING: Final = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Ctrl-C, a service manager's end, and the end of the terminal."""


def _interrupt(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - as signal calls it
    # A second one would break off the end itself, which takes bounded time, and leave processes running.
    for each in ENDING:
        signal.signal(each, signal.SIG_IGN)
    raise KeyboardInterrupt


@contextlib.contextmanager
def ends_once() -> Iterator[None]:
    """Have the first of the signals raise KeyboardInterrupt; ignore all that follow until the process ends.

    What is ignored at the start stays so: ``nohup`` does that, and a shell
    for what it starts in the background.
    """
    before = {each: signal.getsignal(each) for each in ENDING}
    taken = [each for each, known in before.items() if each == signal.SIGTERM or known != signal.SIG_IGN]
    for each in taken:
        signal.signal(each, _interrupt)
    try:
        yield
    finally:
        for each in taken:
            if signal.getsignal(each) is _interrupt:
                signal.signal(each, before[each])
