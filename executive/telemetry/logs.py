"""Logs for people or as lines of JSON: UTC, level, role, event, and what it is about, the task above all.

Whoever logs says what it is about by ``extra``: ``log.info("goal ended", extra={"task": task})``.
"""

from __future__ import annotations

import json
import logging
from datetime import UTC, datetime
from typing import Final

from tandem.executive.config.log_format import LogFormat

_OWN: Final = frozenset(
    (*vars(logging.LogRecord("", 0, "", 0, "", (), None)), "message", "asctime", "taskName")
)
"""What every record has; the rest was given as ``extra``."""


def formatter(which: LogFormat, role: str) -> logging.Formatter:
    """Return what writes a process's records; ``role`` says which process it is."""
    return JsonLines(role) if which == "json" else TextLines(role)


class JsonLines(logging.Formatter):
    """A record is one line of JSON; a trace of the stack is a field of it.

    Args:
        role: the process's.
    """

    def __init__(self, role: str) -> None:
        super().__init__()
        self._role = role

    def format(self, record: logging.LogRecord) -> str:
        """Return the line."""
        document: dict[str, object] = {
            "time": _utc(record),
            "level": record.levelname.lower(),
            "role": self._role,
            "logger": record.name,
            "event": record.getMessage(),
            **_about(record),
        }
        if record.exc_info:
            document["trace"] = self.formatException(record.exc_info)
        return json.dumps(document, default=str)


class TextLines(logging.Formatter):
    """A record is a line that begins with time, level and role; what it is about stands at the end.

    Args:
        role: the process's.
    """

    def __init__(self, role: str) -> None:
        super().__init__()
        self._role = role

    def format(self, record: logging.LogRecord) -> str:
        """Return the line, and a trace of the stack below it."""
        about = "".join(f" {name}={value}" for name, value in _about(record).items())
        head = f"{_utc(record)} {record.levelname:<7} {self._role} {record.name}"
        line = f"{head}: {record.getMessage()}{about}"
        return f"{line}\n{self.formatException(record.exc_info)}" if record.exc_info else line


def _utc(record: logging.LogRecord) -> str:
    moment = datetime.fromtimestamp(record.created, UTC)
    return moment.isoformat(timespec="milliseconds").replace("+00:00", "Z")


def _about(record: logging.LogRecord) -> dict[str, object]:
    return {name: value for name, value in vars(record).items() if name not in _OWN and value != ""}
