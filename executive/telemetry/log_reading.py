"""The logs of the processes that ``tandem up`` has started, read back: by role, by task, and as they grow."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from tandem.skills.ports.message import Message
from tandem.skills.ports.plain_json import read_json

FOLDER: Final = "logs"
"""Beside the ledger, in the folder of ``--data``."""
_TEXT: Final = re.compile(r"(?P<time>\d{4}-\d\d-\d\dT\S+Z) (?P<level>[A-Z]+) +(?P<role>\S+) (?P<rest>.*)")
"""``tandem.executive.telemetry.logs.TextLines``."""
_TASK: Final = re.compile(r"(?:^| )task=(\S+)")


class LogLine(Message):
    """A line of a process's log; one that a library printed has no time and no level."""

    time: str = ""
    """UTC, in ISO 8601."""
    level: str = ""
    role: str
    task: str = ""
    """The task that it is about."""
    text: str
    """The whole line."""


def parsed(role: str, text: str) -> LogLine:
    """Return what a line says, whether it is plain text or JSON."""
    if text.startswith("{"):
        try:
            said = read_json(text)
        except ValueError:
            said = {}
        if "event" in said:
            return LogLine(
                time=str(said.get("time", "")),
                level=str(said.get("level", "")),
                role=role,
                task=str(said.get("task", "")),
                text=text,
            )
    found = _TEXT.match(text)
    if found is None:
        return LogLine(role=role, text=text)
    task = _TASK.search(found["rest"])
    level, about = found["level"].lower(), task[1] if task else ""
    return LogLine(time=found["time"], level=level, role=role, task=about, text=text)


def roles_in(folder: Path) -> tuple[str, ...]:
    """Return the roles that have a log there."""
    return tuple(sorted(path.stem for path in folder.glob("*.log")))


@dataclass
class LogFolder:
    """What the logs of a folder have and get.

    Args:
        folder: where each process writes ``<role>.log``; the file before it is ``<role>.log.1``.
        wanted: says which lines count; a line without a time, as of a trace, goes with the one above it.
    """

    folder: Path
    wanted: Callable[[LogLine], bool]
    _read: dict[Path, int] = field(default_factory=dict)
    _going: dict[str, bool] = field(default_factory=dict)
    """By role, whether the last line with a time counted."""

    def first(self, lines: int) -> list[LogLine]:
        """Return the last ``lines`` of what is there, in the order of their times."""
        before = [self._lines(each, 0)[0] for each in sorted(self.folder.glob("*.log.1"))]
        found = [line for text in before for line in text] + self.more()
        return _in_order(found)[-lines:] if lines else []

    def more(self) -> list[LogLine]:
        """Return what has been added since."""
        found: list[LogLine] = []
        for log in sorted(self.folder.glob("*.log")):
            start = self._read.get(log, 0)
            start = 0 if log.stat().st_size < start else start  # begun anew
            lines, self._read[log] = self._lines(log, start)
            found += lines
        return _in_order(found)

    def _lines(self, log: Path, start: int) -> tuple[list[LogLine], int]:
        with log.open("rb") as stream:
            stream.seek(start)
            text = stream.read()
        whole = text[: text.rfind(b"\n") + 1]
        role = log.name.partition(".log")[0]
        return list(self._counting(role, whole.decode("utf-8", "replace"))), start + len(whole)

    def _counting(self, role: str, text: str) -> Iterator[LogLine]:
        for each in text.splitlines():
            line = parsed(role, each)
            counts = self.wanted(line) if line.time else self._going.get(role, self.wanted(line))
            if line.time:
                self._going[role] = counts
            if counts:
                yield line


def _in_order(lines: list[LogLine]) -> list[LogLine]:
    """Return lines by time; one without a time stays below the line above it."""
    at, keyed = "", list[tuple[str, int, LogLine]]()
    role = ""
    for number, line in enumerate(lines):
        at = line.time or (at if line.role == role else "")
        role = line.role
        keyed.append((at, number, line))
    return [line for _, _, line in sorted(keyed, key=lambda each: each[:2])]
