"""Asks the robot for what stands beside a record's messages, and keeps it: who it is, its site, its trees."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

from tandem.executive.records.answers import STANDING_KEYS
from tandem.executive.records.known import names_task
from tandem.executive.records.recording import Attachment, Recorded
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.tasks import TASK_TIMELINE, TREE, NameTask

ASK_EVERY: Final = 5.0
"""Host seconds between two questions to who has not answered."""
_FIRST: Final = re.compile(rb'\{\s*"task"\s*:\s*"([^"]{1,200})"')
"""The start of a tree or a status. An id longer than 200 characters is none of a task of ours (``Word`` has
64)."""
KEPT: Final = 64
"""Trees and timelines that are kept; one has some 30 kB."""


class Attaching:
    """Asks, and keeps the answers.

    Args:
        bus: where they are asked.
        monotonic: the host's monotonic clock in seconds.
        added: told each attachment when it comes.
    """

    def __init__(self, bus: Bus, monotonic: Callable[[], float], added: Callable[[Attachment], None]) -> None:
        self._bus, self._monotonic, self._added = bus, monotonic, added
        self._asked: dict[str, tuple[float, Pending]] = {}
        self._standing: dict[str, Attachment] = {}
        self._of_tasks: dict[str, Attachment] = {}
        self._treed = ""
        self._ended: list[str] = []

    @property
    def all(self) -> tuple[Attachment, ...]:
        """What is kept."""
        return (*self._standing.values(), *self._of_tasks.values())

    def hear(self, message: Recorded) -> None:
        """Keep the first tree of each task; ask for the timeline of one that has ended."""
        if message.key == TREE.key:
            task = _task(message.payload)
            if task and task != self._treed:
                self._treed = task
                self._keep(Attachment(f"tree/{task}", message.at, message.payload))
        elif names_task(message.key) and b'"ended":null' not in message.payload:
            self._ended.append(_task(message.payload))

    def step(self, at: float) -> None:
        """Ask who has not answered yet, and take in what came. ``at``: robot seconds of the record."""
        now = self._monotonic()
        for key in STANDING_KEYS:
            if key not in self._standing:
                self._ask(key, key, b"{}", now)
        for task in self._ended:
            name = f"{TASK_TIMELINE.key}/{task}"
            self._asked.pop(name, None)
            self._ask(name, TASK_TIMELINE.key, NameTask(task=task).model_dump_json().encode(), now)
        self._ended.clear()
        for name, (_, pending) in tuple(self._asked.items()):
            answer = pending.poll()
            if answer:
                del self._asked[name]
                self._keep(Attachment(name, at, bytes(answer)))

    def _ask(self, name: str, key: str, payload: bytes, now: float) -> None:
        asked = self._asked.get(name)
        if asked is None or now - asked[0] > ASK_EVERY:
            self._asked[name] = (now, self._bus.query(key, payload))

    def _keep(self, attachment: Attachment) -> None:
        if attachment.name in STANDING_KEYS:
            self._standing[attachment.name] = attachment
        else:
            self._of_tasks.pop(attachment.name, None)
            self._of_tasks[attachment.name] = attachment
            while len(self._of_tasks) > KEPT:
                self._of_tasks.pop(next(iter(self._of_tasks)))
        self._added(attachment)


def _task(payload: bytes) -> str:
    """Return the task that a tree or a status is of, which stands first in it: a tree has 30 kB to decode."""
    found = _FIRST.match(payload)
    return "" if found is None else found[1].decode("utf-8", "replace")
