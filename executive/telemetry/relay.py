"""Brings the lines of all processes' logs together while they are written.

Where lines are JSON, what a library prints past the logs becomes JSON as well: a program that reads them
finds nothing else.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from tandem.executive.config.log_format import LogFormat
from tandem.executive.telemetry.logs import JsonLines
from tandem.skills.ports.plain_json import read_json


@dataclass(eq=False)
class LogRelay:
    """Reads what has been added to logs, and writes it on, line by line.

    Args:
        logs: returns the files that are read, each a process's own (``<role>.log``).
        sinks: take a line each.
        form: what the processes write.
    """

    logs: Callable[[], Iterable[Path]]
    sinks: tuple[Callable[[str], None], ...]
    form: LogFormat = "text"
    _read: dict[Path, int] = field(default_factory=dict)

    def step(self, *, last: bool = False) -> None:
        """Write on what is whole; with ``last`` also what is not."""
        if not self.sinks:
            return
        for log in sorted(self.logs()):
            self._relay(log, last=last)

    def _relay(self, log: Path, *, last: bool) -> None:
        start, size = self._read.get(log, 0), log.stat().st_size
        if size == start:
            return
        if size < start:  # begun anew (`tandem.executive.telemetry.log_files`)
            start = 0
        with log.open("rb") as stream:
            stream.seek(start)
            text = stream.read()
        whole = text if last else text[: text.rfind(b"\n") + 1]
        self._read[log] = start + len(whole)
        for line in self._lines(log.stem, whole.decode("utf-8", "replace")):
            for sink in self.sinks:
                sink(line)

    def _lines(self, role: str, text: str) -> Iterator[str]:
        for line in text.splitlines():
            if self.form == "text" or _is_object(line):
                yield line
            elif line.strip():
                printed = logging.LogRecord("output", logging.INFO, "", 0, "%s", (line.rstrip(),), None)
                yield JsonLines(role).format(printed)


def _is_object(line: str) -> bool:
    try:
        return isinstance(read_json(line), dict)
    except ValueError:
        return False
