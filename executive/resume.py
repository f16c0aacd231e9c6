"""After a start: what the ledger has that has not ended waits again, goes on, is asked about, or ends."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final, Literal

from executive.endings import no_longer_valid, not_taken_up
from executive.ledger.port import Entry, Ledger
from executive.on_restart import OnRestart
from executive.requests import Asked, Refused
from executive.task_book import KEPT, TaskBook
from skills.ports.message import RobotTime
from skills.ports.tasks import AskHistory, Question, TaskState, TaskStatus

Read = Callable[[bytes], Asked | Refused]
"""Checks a request's document."""
How = Literal["go on", "paused", "ask", "cancel"]

GO_ON: Final = "resume"
GIVE_UP: Final = "interrupt"
QUESTION: Final = Question(
    node="restart",
    text="The executive ended while this task was under way. Shall it go on from what holds now?",
    choices=(GO_ON, GIVE_UP),
)
_HOW: Final[dict[TaskState, How]] = {
    TaskState.RUNNING: "go on",
    TaskState.PAUSING: "paused",
    TaskState.PAUSED: "paused",
    TaskState.CANCELING: "cancel",
}


@dataclass(frozen=True)
class UnderWay:
    """The task that was under way, and how it is taken up again."""

    task: str
    asked: Asked
    how: How


@dataclass
class Comeback:
    """What a start has found."""

    under_way: UnderWay | None = None
    changed: list[TaskStatus] = field(default_factory=list)
    """Tasks that stand differently now, to be told."""


def take_up(
    ledger: Ledger, book: TaskBook, read: Read, default: OnRestart, now: RobotTime | None
) -> Comeback:
    """Fill the book from the ledger. ``default``: for requests that say nothing of a restart."""
    found = Comeback()
    lately = ledger.history(AskHistory(limit=KEPT)).tasks
    book.ended_lately(tuple(status for status in reversed(lately) if status.state.terminal))
    for entry in ledger.open_entries():
        book.take_up(entry)
        asked = read(json.dumps(entry.status.request).encode())
        if isinstance(asked, Refused):
            found.changed.append(_refuse(book, entry, asked, now))
        elif entry.status.state is TaskState.QUEUED:
            book.put(entry.status.task, asked)
        else:
            _go_on(book, entry, asked, now, found, entry.on_restart or default)
    book.keep()
    return found


def _refuse(book: TaskBook, entry: Entry, refused: Refused, now: RobotTime | None) -> TaskStatus:
    queued = entry.status.state is TaskState.QUEUED
    failure = no_longer_valid(entry.status.kind, refused.problems)
    if entry.status.state is TaskState.CANCELING:
        return book.end(entry.status.task, TaskState.CANCELED, now, failure)
    state = TaskState.REJECTED if queued else TaskState.INTERRUPTED
    return book.end(entry.status.task, state, now, failure)


def _go_on(  # noqa: PLR0917 - all that a decision needs
    book: TaskBook, entry: Entry, asked: Asked, now: RobotTime | None, found: Comeback, wish: OnRestart
) -> None:
    task, state = entry.status.task, entry.status.state
    if state is TaskState.CANCELING or wish == "resume":
        found.under_way = UnderWay(task, asked, _HOW[state])
    elif wish == "ask":
        found.under_way = UnderWay(task, asked, "ask")
        found.changed.append(book.change(task, TaskState.PAUSED, question=QUESTION, running=()))
    else:
        failure = not_taken_up(entry.status.kind, "is not to be taken up again (on_restart: interrupt)")
        found.changed.append(book.end(task, TaskState.INTERRUPTED, now, failure))
