"""One line for each task that is accepted, starts and ends: what ``tandem up`` says of its robot's work."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import TASK_STATUS, TaskState, TaskStatus

DEPTH: Final = 1024
"""Statuses that may wait to be read."""
SHOWN: Final = 100
"""Characters of a request that are shown."""
_NOT_OF_THE_WORK: Final = frozenset({"task", "id", "by"})


class TaskLines:
    """Says what becomes of tasks.

    Args:
        bus: where their statuses are told.
        say: takes a line.
    """

    def __init__(self, bus: Bus, say: Callable[[str], None]) -> None:
        self._statuses = Latest(bus, TASK_STATUS, depth=DEPTH)
        self._say = say
        self._started: dict[str, bool] = {}
        """Tasks that have not ended, and whether they have started."""

    def step(self) -> None:
        """Say what is new."""
        for status in self._statuses.take():
            self._note(status)

    def _note(self, status: TaskStatus) -> None:
        task, known = status.task, status.task in self._started
        if status.state.terminal:
            if self._started.pop(task, None) is not None:
                self._say(ended(status))
            return
        begun = status.started is not None and status.state is not TaskState.QUEUED
        if not known and not begun:
            self._say(accepted(status))
        if begun and not self._started.get(task, False):
            again = " again" if status.begun > 1 else ""
            self._say(f"{task} started{again}")
        self._started[task] = begun


def accepted(status: TaskStatus) -> str:
    """Return the line of a task that was taken."""
    said = {name: value for name, value in status.request.items() if name not in _NOT_OF_THE_WORK}
    text = json.dumps(said, ensure_ascii=False)
    words = text if len(text) <= SHOWN else f"{text[: SHOWN - 1]}…"
    return f"{status.task} accepted: {status.kind} {words}"


def ended(status: TaskStatus) -> str:
    """Return the line of a task that has ended."""
    took = ""
    if status.started is not None and status.ended is not None:
        seconds = status.ended.since(status.started)
        took = "" if seconds is None else f" after {seconds:.1f} s of robot time"
    why = "" if status.failure is None else f": {status.failure.kind}: {status.failure.message}"
    return f"{status.task} ended: {status.state}{took}{why}"
