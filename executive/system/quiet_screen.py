"""Keeps the user's screen for our own words: what libraries print from C goes to the log.

pybullet tells which driver it has (``ven = Mesa/X.org``). The bindings of OMPL and ruckig (nanobind) list, at
the end of a process, every object that still lives: a plan that was under way, and all that ``gc.freeze`` has
kept. No switch of theirs is reachable from Python. So Python's streams get file descriptors of their own, and
those of C, 1 and 2, lead elsewhere.
"""

from __future__ import annotations

import io
import os
import sys
from pathlib import Path
from typing import Final, TextIO

FROM_C: Final = (1, 2)
"""What C knows as standard output and standard error."""
STANDARD: Final = (0, *FROM_C)
"""Those, and standard input."""


class Screen:
    """The screen, taken from C for as long as the process lives. Made once, by a program's entry point."""

    def __init__(self) -> None:
        _open_all()
        self._error = os.dup(2)
        sys.stdout, sys.stderr = _ours(sys.stdout, 1), _ours(sys.stderr, 2)
        self.lead_to(None)

    def lead_to(self, log: Path | None, *, verbose: bool = False) -> None:
        """Say where the words of libraries go: to a log, with ``verbose`` to standard error, else nowhere."""
        if verbose:
            _lead(os.dup(self._error))
        else:
            _lead(os.open(log or os.devnull, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o666))


def end_unheard() -> None:
    """Let a process end without a word: what there was to say stands in its log already."""
    sys.stdout.flush()
    sys.stderr.flush()
    _lead(os.open(os.devnull, os.O_WRONLY))


def _open_all() -> None:
    """Open what was closed at the start (``tandem ... >&-``): the next file would take its place."""
    for number in STANDARD:
        try:
            os.fstat(number)
        except OSError:
            nowhere = os.open(os.devnull, os.O_RDWR)
            if nowhere != number:
                os.dup2(nowhere, number)
                os.close(nowhere)


def _ours(stream: TextIO | None, number: int) -> TextIO:
    """Return a stream like the one given, on a file descriptor that C does not know.

    Python has none for what was closed at the start; then all that is said goes nowhere.
    """
    if stream is None:
        return io.TextIOWrapper(os.fdopen(os.dup(number), "wb"), encoding="utf-8")
    stream.flush()
    assert isinstance(stream, io.TextIOWrapper), "an entry point finds the streams that Python made"
    return io.TextIOWrapper(
        os.fdopen(os.dup(number), "wb"),
        encoding=stream.encoding,
        errors=stream.errors,
        line_buffering=stream.line_buffering,
        write_through=stream.write_through,
    )


def _lead(target: int) -> None:
    for number in FROM_C:
        os.dup2(target, number)
    os.close(target)
