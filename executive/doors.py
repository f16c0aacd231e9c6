"""The executive's doors: who asks stands in the key, and nobody may ask for more than the bounds allow.

A client with a key of its own asks at ``task/by/<name>/request``; the access rules let nobody else there.
So the name is true, although zenoh tells no receiver who sent. The doors write it into the document as
``by``: with the document it is kept, so that it is known after a restart too. At ``task/by/<name>/cancel`` a
client cancels its own tasks.

``Doors`` is a bus around the executive's; the executive serves ``task/request`` as if there were no names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue, ValidationError

from executive.bounds import Bounds, Rates
from executive.requests import BY_FIELD, ID_FIELD
from skills.ports.bus import Bus, Desk, Inbox, Pending, Request, Sample
from skills.ports.clocks import Clocks
from skills.ports.documents import WHOLE, parse, show
from skills.ports.hearing import Ear
from skills.ports.lease import Lease
from skills.ports.message import MAX_REQUEST_BYTES
from skills.ports.tasks import (
    REQUEST,
    TASK_ANSWERS,
    TASK_CANCEL,
    CancelTask,
    ControlAnswer,
    Problem,
    TaskAnswer,
    TaskStatus,
    by_client,
)

ANYBODY: Final = ""
"""Who came by a key without a name."""
TOLD: Final = 20.0
"""Refusals that a client is told in a second; more end unanswered: an answer costs more than the reading."""


@dataclass(eq=False)
class _Sample:
    key: str
    payload: bytes


@dataclass(eq=False)
class _Request:
    """A request whose document has got a name in it."""

    inner: Request
    payload: bytes

    @property
    def key(self) -> str:
        return self.inner.key

    @property
    def selector(self) -> str:
        return self.inner.selector

    @property
    def size(self) -> int:
        return len(self.payload)

    def covers(self, key: str) -> bool:
        return self.inner.covers(key)

    def reply(self, payload: bytes) -> None:
        self.inner.reply(payload)

    def reply_each(self, answers: Mapping[str, bytes]) -> None:
        self.inner.reply_each(answers)

    def refuse(self, payload: bytes) -> None:
        self.inner.refuse(payload)

    def end(self) -> None:
        self.inner.end()


@dataclass
class Doors:
    """A ``Bus`` whose requests are bounded and named; all else passes through.

    Args:
        bus: the executive's.
        clocks: host time for rates.
        bounds: what one client may ask for.
        tasks: all that are known; set it once the executive is there.
    """

    bus: Bus
    clocks: Clocks
    bounds: Bounds = field(default_factory=Bounds)
    tasks: Callable[[], tuple[TaskStatus, ...]] = tuple
    refused: int = 0
    """Documents that were refused here."""

    def __post_init__(self) -> None:
        """Start with full buckets."""
        self._rates = Rates(self.bounds, self.clocks.monotonic)
        self._told = Rates(Bounds(rate=TOLD, burst=TOLD), self.clocks.monotonic)
        self._open: dict[str, list[JsonValue]] | None = None  # ids by client, of one reading

    @property
    def ear(self) -> Ear:
        """The inner bus's."""
        return self.bus.ear

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        self.bus.publish(key, payload)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive; of ``task/request`` also what named clients put."""
        if key != REQUEST:
            return self.bus.subscribe(key, depth=depth)
        ends = [self.bus.subscribe(each, depth=depth) for each in (key, by_client("*", key))]
        return _Puts(self, ends)

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Ask whoever serves the key."""
        return self.bus.query(key, payload, timeout=timeout)

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries; at ``task/request`` and ``task/cancel`` also those of named clients."""
        if key == REQUEST:
            ends = [self.bus.serve(each, limit=2 * limit) for each in (key, by_client("*", key))]
            return _Requests(self, ends)
        if key == TASK_CANCEL.key:
            return _Cancels(self, [self.bus.serve(each) for each in (key, by_client("*", key))])
        return self.bus.serve(key, limit=limit)

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        return self.bus.listened(key)

    def announce(self, name: str) -> None:
        """Show that this process is alive as ``name``."""
        self.bus.announce(name)

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        return self.bus.alive()

    def awake(self) -> frozenset[str]:
        """Return those of them whose process goes on."""
        return self.bus.awake()

    def lease(self) -> Lease | None:
        """Return the lease of this process's role."""
        return self.bus.lease()

    def begin(self) -> None:
        """Begin to read what has come: look anew who has how much open."""
        self._open = None

    def let_in(self, key: str, payload: bytes) -> bytes | TaskAnswer:
        """Return the document with its sender's name, or why it is refused."""
        client = name_in(key)
        wait = self._rates.take(client)
        if wait > 0.0:
            rate = f"at most {self.bounds.rate:g} requests a second of a client; ask again in {wait:.3f} s"
            return self._refuse(WHOLE, rate, "more")
        document = parse(payload)
        if not isinstance(document, dict):
            return payload  # the executive says what is wrong with it
        if BY_FIELD in document:
            return self._refuse(BY_FIELD, "no such field: the key tells who asks", show(document[BY_FIELD]))
        if client == ANYBODY:
            return payload
        if not self._has_room(client, document.get(ID_FIELD)):
            bound = f"at most {self.bounds.open} open requests of a client; ask again when one has ended"
            return self._refuse(WHOLE, bound, "as many open")
        head, _, rest = payload.partition(b"{")
        return b'%s{"%s": "%s"%s%s' % (
            head,
            BY_FIELD.encode(),
            client.encode(),
            b", " if document else b"",
            rest,
        )

    def may_tell(self, client: str) -> bool:
        """Say whether a client is told of one more refusal."""
        return self._told.take(client) <= 0.0

    def owner(self, task: str) -> str | None:
        """Return who asked for a task, or None when there is no such task."""
        for status in self.tasks():
            if status.task == task:
                return str(status.request.get(BY_FIELD, ANYBODY))
        return None

    def _has_room(self, client: str, client_id: JsonValue) -> bool:
        """Say whether a client may have one more request open, or has asked this one already."""
        if self._open is None:
            self._open = {}
            for status in self.tasks():
                if not status.state.terminal:
                    by, known = status.request.get(BY_FIELD), status.request.get(ID_FIELD)
                    self._open.setdefault(str(by), []).append(known)
        mine = self._open.setdefault(client, [])
        if client_id is not None and client_id in mine:
            return True
        if len(mine) >= self.bounds.open:
            return False
        mine.append(client_id)
        return True

    def _refuse(self, path: str, expected: str, found: str) -> TaskAnswer:
        self.refused += 1
        return TaskAnswer(accepted=False, problems=(Problem(path=path, expected=expected, found=found),))


def name_in(key: str) -> str:
    """Return the client that a key names: ``task/by/<name>/...``."""
    parts = key.split("/")
    return parts[2] if parts[:2] == ["task", "by"] and len(parts) > 3 else ANYBODY  # noqa: PLR2004


@dataclass(eq=False)
class _Puts:
    """What was put on the request's keys, with names in it."""

    doors: Doors
    ends: list[Inbox]

    def drain(self) -> list[Sample]:
        taken: list[Sample] = []
        self.doors.begin()
        for sample in (each for end in self.ends for each in end.drain()):
            passed = self.doors.let_in(sample.key, sample.payload)
            if isinstance(passed, bytes):
                taken.append(_Sample(sample.key, passed))
            elif self.doors.may_tell(name_in(sample.key)):
                TASK_ANSWERS.publish(self.doors, passed)
        return taken

    def close(self) -> None:
        for end in self.ends:
            end.close()


@dataclass(eq=False)
class _Requests:
    """Queries on the request's keys, with names in them; those that are too many are answered here."""

    doors: Doors
    ends: list[Desk]

    def drain(self) -> list[Request]:
        taken: list[Request] = []
        self.doors.begin()
        for request in (each for end in self.ends for each in end.drain()):
            passed = self.doors.let_in(request.key, request.payload)
            if isinstance(passed, bytes):
                taken.append(_Request(request, passed))
            elif self.doors.may_tell(name_in(request.key)):
                request.reply(passed.model_dump_json().encode())
        return taken

    def close(self) -> None:
        for end in self.ends:
            end.close()


@dataclass(eq=False)
class _Cancels:
    """Cancels; a named client's only of its own tasks."""

    doors: Doors
    ends: list[Desk]

    def drain(self) -> list[Request]:
        taken: list[Request] = []
        for request in (each for end in self.ends for each in end.drain()):
            why = self._why_not(request)
            if why:
                request.reply(ControlAnswer(accepted=False, reason=why).model_dump_json().encode())
            else:
                taken.append(request)
        return taken

    def close(self) -> None:
        for end in self.ends:
            end.close()

    def _why_not(self, request: Request) -> str:
        client = name_in(request.key)
        if client == ANYBODY:
            return ""
        try:
            task = CancelTask.model_validate_json(request.payload).task
        except ValidationError:
            return ""  # the executive says what is wrong with it
        owner = self.doors.owner(task)
        if owner is None or owner == client:
            return ""
        return f"{task} is not {client}'s own; an operator may cancel it"
