"""What a record answers to who asks: the questions of a client, at the moment that is played.

``hw/description``, ``task/site``, ``task/info`` and ``task/kinds`` as the robot answered when recorded.
``task/list``, ``task/history``, ``task/timeline`` and ``tree/now`` as things were at that moment. No verb is
served: the past takes no orders.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Final, TypeVar

from tandem.executive.records.known import Known
from tandem.executive.records.recording import Attachment
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import Endpoint, answering
from tandem.skills.ports.keys import DESCRIPTION, Nothing, Service
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.tasks import (
    TASK_HISTORY,
    TASK_INFO,
    TASK_KINDS,
    TASK_LIST,
    TASK_SITE,
    TASK_TIMELINE,
    TREE_NOW,
    AskHistory,
    AskTasks,
    History,
    NameTask,
    NodeStatus,
    Span,
    TaskList,
    TaskStatus,
    Timeline,
)

M = TypeVar("M", bound=Message)
STANDING_KEYS: Final = (DESCRIPTION.key, TASK_SITE.key, TASK_INFO.key, TASK_KINDS.key)
"""What a recorder asks once and attaches under these names."""


class Answers:
    """Serves the questions.

    Args:
        bus: where they are asked.
        monotonic: the host's monotonic clock in seconds.
        attachments: of the record.
        known: returns what is known at the moment that is played.
    """

    def __init__(
        self,
        bus: Bus,
        monotonic: Callable[[], float],
        attachments: Iterable[Attachment],
        known: Callable[[], Known],
    ) -> None:
        self._attached = {each.name: each for each in attachments}
        self._known = known
        served: list[Endpoint] = [
            answering(TASK_LIST, self._list),
            answering(TASK_HISTORY, self._history),
            answering(TASK_TIMELINE, self._timeline),
            answering(TREE_NOW, lambda _: known().tree()),
        ]
        served += self._attachment(DESCRIPTION) + self._attachment(TASK_SITE)
        served += self._attachment(TASK_INFO) + self._attachment(TASK_KINDS)
        self._endpoints = Endpoints(bus, monotonic, served)

    def step(self) -> bool:
        """Answer what waits; return whether more does."""
        return self._endpoints.step()

    def _data(self, name: str) -> bytes | None:
        found = self._attached.get(name)
        return None if found is None else found.data

    def _attachment(self, service: Service[Nothing, M]) -> list[Endpoint]:
        data = self._data(service.key)
        return [] if data is None else [answering(service, partial(_same, data))]

    def _list(self, asked: AskTasks) -> TaskList:
        tasks = self._known().statuses()
        upto = len(tasks) if asked.before == 0 else asked.before - 1
        first = max(0, upto - asked.limit)
        return TaskList(tasks=tasks[first:upto], more=first + 1 if first else 0)

    def _history(self, asked: AskHistory) -> History:
        tasks = self._known().statuses()
        upto = len(tasks) if asked.before == 0 else asked.before - 1
        found: list[TaskStatus] = []
        place = upto
        while place and len(found) < asked.limit:
            place -= 1
            if _wanted(tasks[place], asked):
                found.append(tasks[place])
        return History(tasks=tuple(found), more=place + 1 if place else 0)

    def _timeline(self, asked: NameTask) -> Timeline:
        data, now = self._data(f"{TASK_TIMELINE.key}/{asked.task}"), self._known().stamp
        if data is None or now is None:
            return Timeline(task=asked.task)
        whole = Timeline.model_validate_json(data)
        begun = tuple(_as_at(now, each) for each in whole.spans if each.begin.is_after(now) is not True)
        return Timeline(task=asked.task, spans=begun)


def _as_at(now: RobotTime, span: Span) -> Span:
    """Return a run as it was at a moment: one that ended later still ran."""
    if span.end is None or not span.end.is_after(now):
        return span
    return span.model_copy(update={"end": None, "status": NodeStatus.RUNNING, "message": ""})


def _same(data: bytes, asked: Nothing) -> bytes:
    del asked
    return data


def _wanted(status: TaskStatus, asked: AskHistory) -> bool:
    return (
        (not asked.states or status.state in asked.states)
        and (not asked.task or asked.task in {status.task, status.client_id})
        and status.accepted_at >= asked.since
    )
