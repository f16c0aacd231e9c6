"""The tasks: those that wait or run, and the newest that ended. What changes is written down first."""

from __future__ import annotations

import heapq
import logging
import uuid
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Final

from pydantic import JsonValue

from tandem.executive.ledger.port import Entry, Ledger, LedgerError
from tandem.executive.ledger.sender import asked_by
from tandem.executive.ledger.stubs import same_request
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.executive.service.intake.request_parser import Asked
from tandem.executive.service.tasks.task_queue import TaskQueue, Waiting
from tandem.executive.service.tasks.task_states import FIRST, check
from tandem.executive.service.tasks.wall_clock import WallClock
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.problems import WHOLE, Problem, show
from tandem.skills.ports.tasks import Attempt, TaskAnswer, TaskState, TaskStatus
from tandem.skills.ports.utc import iso

MAX_WAITING: Final = 1000
"""Tasks that may wait; one more is refused."""
KEPT: Final = 200
"""Ended tasks that are in memory, for ``task/list``; the ledger has all."""

_LOG = logging.getLogger(__name__)
TURN: Final = "its turn"
"""What a task waits for that nothing keeps from beginning."""
NOTE_EVERY: Final = 600.0
"""Host seconds between two notes of the clocks in the ledger."""


@dataclass(frozen=True)
class AtOnce:
    """A task that began with its acceptance: one commit has both."""

    accepted: TaskStatus
    """How it was queued."""
    begun: TaskStatus
    """How it runs."""
    asked: Asked


def start_id() -> str:
    """Return a name of this start of the executive, drawn at random.

    Servers of skills journal the ids of goals, which begin with the task's. So a task's id must never come
    again: not when the ledger has been put away and numbers begin anew, not when an old copy of it was put
    back, and not when the clock was. Within a ledger the number alone makes it unique.
    """
    return uuid.uuid4().hex[:8]


class TaskBook:
    """Every task that is known, by its id: ``<kind>-<start>-<number>``, such as ``fetch-5d1f0a7c-0001``.

    A change is written into the ledger at once and is on disk after ``keep``. Tell nobody before.

    Args:
        ledger: where all is written down.
        wall: the clock of what is stored, and of earliest and latest starts.
        start: name of this start of the executive (``start_id``); empty in lockstep, where a run has one
            start only and ids are ``fetch-0001``.
        bound: tasks that may wait.
        bound_of_one: tasks of one named client that may be open.
    """

    def __init__(
        self,
        ledger: Ledger,
        wall: WallClock,
        start: str = "",
        *,
        bound: int = MAX_WAITING,
        bound_of_one: int = MAX_WAITING,
    ) -> None:
        self.queue, self._open = TaskQueue(), bound_of_one
        self._ledger, self._wall, self._start, self._bound = ledger, wall, start, bound
        self._utc, self._noted_at = wall.utc, float("-inf")
        self._numbered = ledger.last_number()
        self._entries: dict[str, Entry] = {}
        self._ended: dict[str, TaskStatus] = {}
        self._fresh: list[str] = []  # accepted, and not yet on disk
        self._at_once: AtOnce | None = None
        self.hold: Callable[[str], str] = lambda _: ""
        """Returns why no task of a kind may begin now, in words after "waits for"; or nothing."""

    # Requests.

    def accept(self, asked: Asked) -> TaskAnswer:
        """Queue a request and answer with its id, or say why it can't be queued. Valid once kept.

        The same document under the same client's id is not queued again; its answer is the first one's.
        """
        by = asked_by(asked.document)
        known = self._ledger.of_client(asked.client_id, by) if asked.client_id else None
        if known is not None:
            return _again(asked, known.status)
        problem = self._no_room(asked, by)
        if problem is not None:
            return TaskAnswer(accepted=False, problems=(problem,), client_id=asked.client_id)
        self._numbered += 1
        envelope = asked.envelope
        parts = (asked.kind.name, self._start, f"{self._numbered:04d}")
        status = TaskStatus(
            task="-".join(part for part in parts if part),
            kind=asked.kind.name,
            request=asked.document,
            state=FIRST,
            accepted_at=self._utc(),
            client_id=asked.client_id,
            priority=envelope.priority,
            not_before=envelope.not_before,
            expires=envelope.expires,
        )
        entry = Entry(status, self._numbered, envelope.on_restart, envelope.test_run)
        try:
            self._ledger.enter(entry)
        except LedgerError:
            self.drop_fresh()  # the ledger has taken all back that was not committed
            raise
        self._entries[status.task] = entry
        self._fresh.append(status.task)
        self.put(status.task, asked)
        return TaskAnswer(accepted=True, task=status.task, client_id=asked.client_id)

    def keep(self) -> None:
        """Have all that was changed on disk.

        Raises:
            LedgerError: when that can't be; then what was accepted since the last time is not there.
        """
        try:
            self._ledger.commit()
        except LedgerError:
            self.drop_fresh()
            raise
        self._fresh.clear()

    def begin_at_once(self, now: RobotTime | None) -> None:
        """Note that the next task runs, if it is one that was accepted since all was kept the last time.

        So it is accepted and runs with one commit, and not with one after the other. ``take_at_once`` has it.

        Raises:
            LedgerError: when that can't be written; then what was accepted is not there either.
        """
        waits = self.next() if self._fresh else None
        if waits is None or waits.task not in self._fresh:
            return
        accepted = self._entries[waits.task].status
        try:
            begun = self.begin(waits.task, now)
        except LedgerError:
            self.drop_fresh()
            raise
        self.queue.remove(waits.task)
        self._at_once = AtOnce(accepted, begun, waits.asked)

    def take_at_once(self) -> AtOnce | None:
        """Return the task that was begun with its acceptance, once: its tree is to be built."""
        taken, self._at_once = self._at_once, None
        return taken

    def look_at_the_clock(self, now: float) -> None:
        """Follow the wall clock; from time to time have the clocks on disk. ``now``: host seconds."""
        self._wall.look()
        if now - self._noted_at < NOTE_EVERY:
            return
        self._noted_at = now
        try:
            self._ledger.note(self._wall.reading())
            self._ledger.commit()
        except LedgerError:  # nobody was told: the next start knows an older time, and is the more careful
            _LOG.exception("could not record the clocks in the ledger")

    def drop_fresh(self) -> None:
        """Forget what was accepted and is not on disk."""
        for task in self._fresh:
            self.queue.remove(task)
            self._entries.pop(task, None)
        self._fresh.clear()
        self._at_once = None

    def take_up(self, entry: Entry) -> None:
        """Know a task of before a restart again."""
        self._entries[entry.status.task] = entry

    def put(self, task: str, asked: Asked) -> None:
        """Let a task wait, in its place."""
        entry = self._entries[task]
        self.queue.put(task, asked, entry.status.priority, entry.number, begun=entry.status.begun > 0)

    # Questions.

    @property
    def waiting(self) -> tuple[str, ...]:
        """The ids of those that wait, in their order."""
        return tuple(each.task for each in self.queue)

    def get(self, task: str) -> TaskStatus | None:
        """Return a task that has not ended or ended lately, or None."""
        entry = self._entries.get(task)
        return self._ended.get(task) if entry is None else entry.status

    def find(self, task: str) -> TaskStatus | None:
        """Return a task, also an old one, or None when it is not known (any more)."""
        status = self.get(task)
        if status is None:
            entry = self._ledger.entry(task)
            status = None if entry is None else entry.status
        return status

    def named(self, name: str, by: str | None = None) -> tuple[str, ...]:
        """Return the ids of the tasks that a client may mean by a name: a task's id, or a request's ``id``.

        A task's own id comes first, so that no client's choice can hide a task. Of requests with one ``id``
        those that have not ended count, and without any the newest that ended and is still in memory.

        Args:
            name: as the client says it.
            by: only this client's requests, by its ``id``; None: anybody's.
        """
        if self.find(name) is not None or not name:
            return (name,)

        def meant(status: TaskStatus) -> bool:
            return status.client_id == name and by in {None, asked_by(status.request)}

        found = tuple(task for task, entry in self._entries.items() if meant(entry.status))
        return found or tuple(task for task, status in self._ended.items() if meant(status))[-1:]

    def entry(self, task: str) -> Entry:
        """Return what was accepted; KeyError when it has ended."""
        return self._entries[task]

    @property
    def count(self) -> int:
        """How many tasks are in memory."""
        return len(self._entries) + len(self._ended)

    def page(self, before: int, limit: int) -> tuple[tuple[TaskStatus, ...], int]:
        """Return the newest of those in memory, oldest first, and the place before which there are more.

        Args:
            before: only those that came before this place in the order of arrival; 0: from the newest.
            limit: how many.
        """
        known = [(_number(task), task) for task in (*self._ended, *self._entries)]
        older = [each for each in known if not before or each[0] < before]
        newest = heapq.nlargest(limit + 1, older)
        found = [self.get(task) for _, task in reversed(newest[:limit])]
        more = newest[limit - 1][0] if len(newest) > limit else 0
        return tuple(status for status in found if status is not None), more

    def all(self) -> tuple[TaskStatus, ...]:
        """Return those that have not ended and those that ended lately, oldest first."""
        waits = {each.task: self.waits_for(each) for each in self.queue}
        open_ones = (
            entry.status.model_copy(update={"waits_for": waits[task]}) if task in waits else entry.status
            for task, entry in self._entries.items()
        )
        known = [*self._ended.values(), *open_ones]
        return tuple(sorted(known, key=lambda status: _number(status.task)))

    def ended_lately(self, tasks: tuple[TaskStatus, ...]) -> None:
        """Remember what ended before a restart; the oldest first."""
        self._ended.update({status.task: status for status in tasks})

    # Changes.

    def begin(self, task: str, now: RobotTime | None) -> TaskStatus:
        """Note that the task runs: its tree begins (once more)."""
        status = self._entries[task].status
        # One that is taken up after a restart stays paused or cancelled.
        state = TaskState.RUNNING if status.state is TaskState.QUEUED else status.state
        return self.change(task, state, started=status.started or now, begun=status.begun + 1)

    def rank(self, task: str, priority: int) -> TaskStatus:
        """Give a task that waits another priority."""
        self.queue.rank(task, priority)
        return self.change(task, TaskState.QUEUED, priority=priority)

    def learn(self, kind: str, remaining: Mapping[str, float]) -> None:
        """Note what a task took from each phase on, for those to come."""
        self._ledger.learn(kind, remaining)

    def change(self, task: str, state: TaskState, **update: object) -> TaskStatus:
        """Note another state, or other facts of a task; checked against the table of states."""
        entry = self._entries[task]
        check(task, entry.status.state, state)
        status = entry.status.model_copy(update={**update, "state": state})
        self._ledger.change(status, self._utc())
        self._entries[task] = replace(entry, status=status)
        return status

    def note(self, task: str, **update: object) -> TaskStatus:
        """Note what need not be on disk before it is told: it is written with the next change."""
        entry = self._entries[task]
        status = entry.status.model_copy(update=update)
        self._entries[task] = replace(entry, status=status)
        return status

    def remember(self, task: str, memory: TaskMemory) -> None:
        """Note what a restart must know of a task that has not ended, if that is something new."""
        entry = self._entries[task]
        if entry.memory != memory:
            self._ledger.remember(task, memory)
            self._entries[task] = replace(entry, memory=memory)

    def tried(self, task: str, tried: tuple[Attempt, ...]) -> TaskStatus | None:
        """Note what went wrong so far; also of a task that has just ended, whose picture came late."""
        if task in self._entries:
            return self.note(task, tried=tried)
        status = self._ended.get(task)
        if status is not None:
            self._ended[task] = status = status.model_copy(update={"tried": tried})
            self._ledger.change(status, self._utc())
        return status

    def end(
        self,
        task: str,
        state: TaskState,
        now: RobotTime | None,
        failure: Failure | None = None,
        result: dict[str, JsonValue] | None = None,
    ) -> TaskStatus:
        """Note how the task ended; the oldest of those that ended long ago are in the ledger only."""
        facts: dict[str, object] = {"running": (), "time_left": None, "question": None, "result": result}
        ended = self.change(task, state, ended=now, failure=failure, ended_at=self._utc(), **facts)
        del self._entries[task]
        self._ended[task] = ended
        while len(self._ended) > KEPT:
            del self._ended[next(iter(self._ended))]
        return ended

    def withdraw(self, task: str, state: TaskState, now: RobotTime | None) -> TaskStatus:
        """End a task that waits."""
        self.queue.remove(task)
        return self.end(task, state, now)

    def expire(self, now: RobotTime | None) -> tuple[TaskStatus, ...]:
        """End those whose latest start has gone by."""
        return tuple(
            self.end(each.task, TaskState.EXPIRED, now) for each in self.queue.take_late(self._wall.earliest)
        )

    def next(self) -> Waiting | None:
        """Return the one whose turn it is, without taking it out."""
        held = {name for name in self.queue.kinds if self.hold(name)}
        if len(held) == len(self.queue.kinds):
            return None
        return self.queue.ready(self._wall.earliest, self._wall.latest, held)

    def waits_for(self, each: Waiting) -> str:
        """Return what a waiting task waits for, in words."""
        wall = self._wall
        if each.not_before > wall.latest:
            return f"its earliest start, {iso(each.not_before)}"
        if each.not_before > wall.earliest or each.expires < wall.latest:
            return f"a clock that can be trusted: {wall.trouble()}"
        return self.hold(each.asked.kind.name) or TURN

    def explained(self, status: TaskStatus) -> TaskStatus:
        """Return a task's status with what it waits for, if it does."""
        waits = self.waits(status)
        return status.model_copy(update={"waits_for": waits}) if waits else status

    def waits(self, status: TaskStatus) -> str:
        """Return what a task waits for, in words; nothing when it does not wait."""
        found = self.queue.find(status.task) if status.state is TaskState.QUEUED else None
        return "" if found is None else self.waits_for(found)

    def _no_room(self, asked: Asked, by: str) -> Problem | None:
        last, now = asked.envelope.expires, self._wall.earliest
        if last is not None and last < now:
            return Problem(
                path="expires", expected=f"a time in the future (it is {iso(now)} now)", found=iso(last)
            )
        if by and self._open_of(by) >= self._open:
            bound = f"at most {self._open} open requests per client; try again when one has ended"
            return Problem(path=WHOLE, expected=bound, found=f"{self._open} open")
        if len(self.queue) < self._bound:
            return None
        return Problem(
            path=WHOLE,
            expected=f"at most {self._bound} queued tasks; try again later",
            found=f"{len(self.queue)} queued",
            code="QUEUE_FULL",
        )

    def _open_of(self, by: str) -> int:
        """Return how many requests of a client have not ended, those not yet on disk included."""
        return sum(asked_by(entry.status.request) == by for entry in self._entries.values())


def _again(asked: Asked, first: TaskStatus) -> TaskAnswer:
    if same_request(first.request, asked.document):
        return TaskAnswer(accepted=True, task=first.task, client_id=asked.client_id)
    found = f"{show(asked.client_id)}, already used by {first.task} with different contents"
    problem = Problem(path="id", expected="a new id", found=found)
    return TaskAnswer(accepted=False, problems=(problem,), client_id=asked.client_id)


def _number(task: str) -> int:
    last = task.rpartition("-")[2]
    return int(last) if last.isdigit() else 0
