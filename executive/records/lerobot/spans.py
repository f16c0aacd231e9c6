"""The tasks of a record whose whole run is in it: each can be an episode. Of the others it says why not."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from pydantic import JsonValue, ValidationError

from tandem.executive.records.known import names_task
from tandem.executive.records.recording import Recording
from tandem.skills.ports.message import read_leniently
from tandem.skills.ports.tasks import TaskState, TaskStatus

NO_LEAF: Final = "none"
"""The subtask of a frame at which no leaf ran."""
_NOT_ASKED: Final = frozenset(
    {"task", "id", "priority", "not_before", "expires", "on_restart", "test_run", "labels", "retry_of"}
)
"""Of a request: its kind stands first, and the rest says how it is queued, not what is to be done."""


@dataclass(frozen=True)
class TaskSpan:
    """A task that began and ended in a record."""

    task: str
    kind: str
    text: str
    """What was asked for, as words."""
    request: Mapping[str, JsonValue]
    begin: float
    """Robot seconds since the recorder began, at the task's start."""
    end: float
    state: TaskState
    failure: str
    """Kind of its failure; empty if there is none."""
    leaves: tuple[tuple[float, str], ...]
    """From when on which leaves ran."""
    boots: int = 1
    """Of the robot, in which it ran: between two, nobody knows what it did."""


@dataclass(frozen=True)
class LeftOut:
    """A task that is no episode, and why."""

    task: str
    reason: str


def spans(record: Recording) -> tuple[tuple[TaskSpan, ...], tuple[LeftOut, ...]]:
    """Return the tasks that began and ended in a record, in order, and those that did not."""
    said: dict[str, list[tuple[float, TaskStatus]]] = {}
    for message in record.messages():
        if names_task(message.key):
            try:
                status = read_leniently(TaskStatus, message.payload)
            except ValidationError:
                continue  # a wrong message is as good as none
            said.setdefault(status.task, []).append((message.at, status))
    found, left_out = [], []
    for task, statuses in said.items():
        made = _span(record, task, statuses)
        if isinstance(made, TaskSpan):
            found.append(made)
        else:
            left_out.append(made)
    return tuple(sorted(found, key=lambda each: each.begin)), tuple(left_out)


def words_of(kind: str, request: Mapping[str, JsonValue]) -> str:
    """Return a request as words: ``fetch item 3 to depot``."""
    told = [
        f"{name.replace('_', ' ')} {_value(value)}"
        for name, value in request.items()
        if name not in _NOT_ASKED and value is not None
    ]
    return " ".join((kind, *told))


def _value(value: JsonValue) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return ", ".join(_value(each) for each in value)
    return json.dumps(value, ensure_ascii=False)


def _span(record: Recording, task: str, said: list[tuple[float, TaskStatus]]) -> TaskSpan | LeftOut:
    running = [(at, each) for at, each in said if each.started is not None and not each.state.terminal]
    ended = [(at, each) for at, each in said if each.state.terminal]
    if not running:
        return LeftOut(task, "it did not start in the record")
    begin, first = running[0]
    if begin < record.span.begin:
        return LeftOut(task, "it had begun before the record does")
    if not ended:
        return LeftOut(task, "its end is not in the record")
    end, last = ended[0]
    return TaskSpan(
        task=task,
        kind=first.kind,
        text=words_of(first.kind, first.request),
        request=first.request,
        begin=begin,
        end=end,
        state=last.state,
        failure="" if last.failure is None else last.failure.kind.value,
        boots=sum(
            each.begin + each.offset <= end and each.end + each.offset >= begin for each in record.boots()
        ),
        leaves=tuple((at, " and ".join(each.running) or NO_LEAF) for at, each in running),
    )
