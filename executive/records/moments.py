"""What happened in a record, and when: tasks that began and ended, stops, processes that died."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from tandem.executive.records.incidents import Incidents
from tandem.executive.records.known import ALIVE, Alive, names_task, said
from tandem.executive.records.recording import Recorded, Recording, Span
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.tasks import TaskState, TaskStatus


class Moment(Message):
    """Something that happened."""

    at: float
    """Robot seconds since the recorder began."""
    stamp: RobotTime | None
    """The robot's time."""
    kind: Literal["accepted", "started", "ended", "failed", "stop", "death"]
    words: str
    task: str = ""


def moments(record: Recording) -> tuple[Moment, ...]:
    """Return what happened, in order; what a record begins with happened before it."""
    return tuple(_Seeing(record.span).through(record))


def span_of(record: Recording, task: str) -> Span | None:
    """Return from when to when a task runs in a record; None if it is not in it.

    It begins with its start; one that was never started, with what is first said of it. The time in the
    queue is another task's.
    """
    key = f"task/{task}/status"
    found = [max(each.at, record.span.begin) for each in record.messages(-math.inf) if each.key == key]
    if not found:
        return None
    own = [each for each in moments(record) if each.task == task]
    ends = [each.at for each in own if each.kind in {"ended", "failed"}]
    starts = [each.at for each in own if each.kind == "started"]
    return Span(starts[0] if starts else found[0], ends[-1] if ends else record.span.end)


def at_of(record: Recording, seconds: float) -> float:
    """Return ``at`` of a robot time, as `tandem why` shows it: in the last boot that has it.

    Of a time that no boot has, the nearest within the record.
    """
    boots = record.boots()
    within = [each.offset for each in boots if each.begin <= seconds <= each.end]
    offset = within[-1] if within else boots[0].offset if boots else 0.0
    return record.span.clipped(seconds + offset)


@dataclass
class _Seeing:
    span: Span

    def __post_init__(self) -> None:
        self._incidents = Incidents()
        self._states: dict[str, TaskState] = {}

    def through(self, record: Recording) -> Iterator[Moment]:
        for message in record.messages(-math.inf):
            for moment in self._of(message):
                if message.at >= self.span.begin:
                    yield moment

    def _of(self, message: Recorded) -> Iterator[Moment]:
        if names_task(message.key):
            status = said(TaskStatus, message)
            if status is not None:
                yield from self._task(message, status)
            return
        if message.key == ALIVE:
            alive = said(Alive, message)
            cause = None if alive is None else self._incidents.look(frozenset(alive.names), message)
        else:
            cause = self._incidents.hear(message)
        if cause is not None and cause.kind in {"stop", "death"}:
            kind: Literal["stop", "death"] = "stop" if cause.kind == "stop" else "death"
            yield Moment(at=message.at, stamp=message.stamp, kind=kind, words=cause.words, task=cause.task)

    def _task(self, message: Recorded, status: TaskStatus) -> Iterator[Moment]:
        self._incidents.hear(message)
        task, before = status.task, self._states.get(status.task)
        self._states[task] = status.state
        if before is not None and (before is status.state or before.terminal):
            return
        if status.state.terminal:
            why = "" if status.failure is None else f": {status.failure.kind}: {status.failure.message}"
            kind: Literal["ended", "failed"] = "ended" if status.failure is None else "failed"
            yield _moment(message, kind, f"{task} {status.state}{why}", task)
        elif status.started is not None and (before is None or before is TaskState.QUEUED):
            yield _moment(message, "started", f"{task} started", task)
        elif before is None:
            yield _moment(message, "accepted", f"{task} accepted: {status.kind}", task)


def _moment(
    message: Recorded, kind: Literal["accepted", "started", "ended", "failed"], words: str, task: str
) -> Moment:
    return Moment(at=message.at, stamp=message.stamp, kind=kind, words=words, task=task)
