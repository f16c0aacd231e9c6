"""After a start: what the ledger has that has not ended waits again, goes on, is asked about, or ends."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final, Literal

from tandem.executive.config.on_restart import OnRestart
from tandem.executive.ledger.port import Entry, Ledger
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.executive.service.intake.request_parser import Asked, Refused
from tandem.executive.service.running.endings import crashed_at, no_longer_valid, not_taken_up
from tandem.executive.service.tasks.task_book import KEPT, TaskBook
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import AskHistory, Question, TaskState, TaskStatus

Read = Callable[[bytes], Asked | Refused]
"""Checks a request's document."""
How = Literal["go on", "paused", "ask", "cancel", "step"]
RESUMES: Final = 3
"""Times that a task is taken up after a crash without having come further; after another crash it ends."""

GO_ON: Final = "resume"
GIVE_UP: Final = "interrupt"
QUESTION: Final = Question(
    node="restart",
    text="The executive ended while this task was running. Continue from the current state of the world?",
    choices=(GO_ON, GIVE_UP),
)
_HOW: Final[dict[TaskState, How]] = {
    TaskState.RUNNING: "go on",
    TaskState.PAUSING: "paused",
    TaskState.PAUSED: "paused",
    TaskState.CANCELING: "cancel",
}
"""How a task is taken up, by the state in which the crash left it."""


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
    ledger: Ledger, book: TaskBook, read: Read, default: OnRestart, now: RobotTime | None, *, died: str = ""
) -> Comeback:
    """Fill the book from the ledger.

    Args:
        ledger: what was accepted.
        book: to be filled.
        read: checks requests once more.
        default: for requests that say nothing of a restart.
        now: robot time.
        died: how the executive of before ended, in words; empty when nobody knows.
    """
    found = Comeback()
    lately = _lately(ledger)
    book.ended_lately(tuple(status for status in reversed(lately) if status.state.terminal))
    for entry in ledger.open_entries():
        book.take_up(entry)
        asked = read(json.dumps(entry.status.request).encode())
        if isinstance(asked, Refused):
            found.changed.append(_refuse(book, entry, asked, now))
        elif entry.status.state is TaskState.QUEUED:
            book.put(entry.status.task, asked)
        else:
            memory = _after_crash(ledger, entry)
            book.remember(entry.status.task, memory)
            end = memory.given_up or _poisonous(entry.status, memory, died)
            if end is not None:
                found.changed.append(book.end(entry.status.task, TaskState.INTERRUPTED, now, end))
            else:
                _go_on(book, entry, asked, now, found, entry.on_restart or default)
    book.keep()
    return found


def _after_crash(ledger: Ledger, entry: Entry) -> TaskMemory:
    """Return the task's memory with the crash counted, if there was one while its tree was at work."""
    status, memory = entry.status, entry.memory
    if memory.in_order or status.state not in {TaskState.RUNNING, TaskState.CANCELING}:
        return memory.model_copy(update={"in_order": False})
    came, fraction = ledger.nodes_done(status.task), status.progress.fraction
    further = came > memory.came or fraction > memory.fraction
    update = {"crashes": 1 if further else memory.crashes + 1, "came": came, "fraction": fraction}
    return memory.model_copy(update=update)


def _poisonous(status: TaskStatus, memory: TaskMemory, died: str) -> Failure | None:
    """Return why a task is not taken up once more, if the executive crashes at it again and again."""
    if memory.crashes <= RESUMES:
        return None
    return crashed_at(status.kind, memory.crashes, status.progress, died)


def _lately(ledger: Ledger) -> tuple[TaskStatus, ...]:
    """Return the newest tasks, as many as are kept in memory, the newest first."""
    asked, found = AskHistory(), tuple[TaskStatus, ...]()
    while True:
        page = ledger.history(asked)
        found += page.tasks
        if not page.more or len(found) >= KEPT:
            return found[:KEPT]
        asked = AskHistory(before=page.more)


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
    task, state, memory = entry.status.task, entry.status.state, entry.memory
    if state is TaskState.CANCELING or wish == "resume" or memory.go_on:
        how = "step" if state is TaskState.RUNNING and memory.step else _HOW[state]
        found.under_way = UnderWay(task, asked, how)
    elif wish == "ask":
        found.under_way = UnderWay(task, asked, "ask")
        found.changed.append(book.change(task, TaskState.PAUSED, question=QUESTION, running=()))
    else:
        failure = not_taken_up(entry.status.kind, "it is not to be resumed (on_restart: interrupt)")
        found.changed.append(book.end(task, TaskState.INTERRUPTED, now, failure))
