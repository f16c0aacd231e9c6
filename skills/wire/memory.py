"""The bus in memory: delivers in order, in one thread, and never loses anything. For lockstep and tests."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from tandem.skills.ports.bus import Desk, Inbox, Pending, Request, Sample
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.lease import Lease
from tandem.skills.ports.match import intersects, matches
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.wire.keyed_queue import DESK_DEPTH


@dataclass(frozen=True)
class MemorySample:
    """One message that arrived."""

    key: str
    payload: bytes


@dataclass(eq=False)
class MemoryInbox:
    """What a subscription holds until it is drained."""

    hub: MemoryHub
    expression: str
    depth: int
    waiting: deque[MemorySample] = field(default_factory=deque)

    def drain(self) -> list[Sample]:
        """Take all that has arrived."""
        taken: list[Sample] = list(self.waiting)
        self.waiting.clear()
        return taken

    def close(self) -> None:
        """End the subscription."""
        self.hub.forget(self)


@dataclass(eq=False)
class MemoryPending:
    """A query under way in memory."""

    replies: dict[str, bytes] = field(default_factory=dict)
    """Every answer by its key: a selector may get many."""
    error: bytes | None = None
    under_way: int = 0
    """Requests of it that have not ended."""

    def poll(self) -> bytes | None:
        """Return the first answer, or None while there is none."""
        return next(iter(self.replies.values()), None)

    def refusal(self) -> bytes | None:
        """Return the error that was answered, or None."""
        return self.error

    def done(self) -> bool:
        """Say whether no (further) answer will come."""
        return self.under_way == 0


@dataclass(eq=False)
class MemoryRequest:
    """One query that waits for its answer."""

    hub: MemoryHub
    key: str
    selector: str
    size: int
    payload: bytes
    pending: MemoryPending
    ended: bool = False

    def __post_init__(self) -> None:
        self.pending.under_way += 1

    def covers(self, key: str) -> bool:
        """Say whether the selector stands for the key."""
        return matches(self.selector, key)

    def reply(self, payload: bytes) -> None:
        """Answer; a second answer is ignored."""
        self.reply_each({self.key: payload})

    def reply_each(self, answers: Mapping[str, bytes]) -> None:
        """Answer under each key."""
        if self.ended:
            return
        for key, payload in answers.items():
            if not self.covers(key):
                raise ValueError(f"{key} is not among the keys that {self.selector} stands for")
            self.pending.replies.setdefault(key, payload)
            self.hub.record("reply", key, payload)
        self.end()

    def refuse(self, payload: bytes) -> None:
        """Answer with an error."""
        if not self.ended:
            self.pending.error = payload
            self.hub.record("reply", self.key, payload)
            self.end()

    def end(self) -> None:
        """End without an answer."""
        if not self.ended:
            self.ended = True
            self.pending.under_way -= 1

    def __del__(self) -> None:
        """Unanswered, it ends empty when dropped."""
        self.end()


@dataclass(eq=False)
class MemoryDesk:
    """Queries that wait at a key."""

    hub: MemoryHub
    expression: str
    limit: int
    waiting: deque[MemoryRequest] = field(default_factory=deque)

    def ask(self, selector: str, payload: bytes, pending: MemoryPending) -> None:
        """Have a query wait here; more than there is room for end unanswered."""
        if sum(each.selector == selector for each in self.waiting) >= DESK_DEPTH:
            return
        key = next((each for each in (self.expression, selector) if "*" not in each), "")
        kept = payload if len(payload) <= self.limit else b""
        self.waiting.append(MemoryRequest(self.hub, key, selector, len(payload), kept, pending))

    def drain(self) -> list[Request]:
        """Take all that has arrived."""
        if not self.waiting:  # as it is in most steps
            return []
        taken: list[Request] = list(self.waiting)
        self.waiting.clear()
        return taken

    def close(self) -> None:
        """Stop serving; what waits ends without an answer."""
        for request in self.waiting:
            request.end()
        self.waiting.clear()
        self.hub.forget(self)


Kind = Literal["put", "query", "reply"]
Recorder = Callable[[Kind, str, bytes], None]


class MemoryHub:
    """What all endpoints of one in-memory bus share."""

    def __init__(self) -> None:
        """Start with nobody connected."""
        self.inboxes: list[MemoryInbox] = []
        self.desks: list[MemoryDesk] = []
        self.names: dict[str, None] = {}
        self._recorders: list[Recorder] = []
        self._routes: dict[str, tuple[MemoryInbox, ...]] = {}

    def endpoint(self) -> MemoryBus:
        """Return a bus for one node or process."""
        return MemoryBus(self)

    def watch(self, recorder: Recorder) -> None:
        """Have ``recorder`` called with each message, in order."""
        self._recorders.append(recorder)

    def record(self, kind: Kind, key: str, payload: bytes) -> None:
        """Tell the recorders."""
        for recorder in self._recorders:
            recorder(kind, key, payload)

    def add(self, inbox: MemoryInbox) -> None:
        """Connect a subscription."""
        self.inboxes.append(inbox)
        self._routes.clear()

    def forget(self, end: MemoryInbox | MemoryDesk) -> None:
        """Disconnect a subscription or a desk."""
        if isinstance(end, MemoryInbox):
            self.inboxes = [each for each in self.inboxes if each is not end]
            self._routes.clear()
        else:
            self.desks = [each for each in self.desks if each is not end]

    def listeners(self, key: str) -> tuple[MemoryInbox, ...]:
        """Return the subscriptions that a key reaches, in the order in which they were made."""
        route = self._routes.get(key)
        if route is None:
            route = tuple(inbox for inbox in self.inboxes if matches(inbox.expression, key))
            self._routes[key] = route
        return route


class MemoryBus:
    """One node's end of a ``MemoryHub``; implements ``tandem.skills.ports.bus.Bus``."""

    def __init__(self, hub: MemoryHub | None = None) -> None:
        """Join ``hub``, or a new one."""
        self.hub = hub or MemoryHub()
        self.ear = Ear()
        self._announced: list[str] = []
        self.held: Lease | None = None
        """This end's lease, where one is granted."""

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        self.hub.record("put", key, payload)
        for inbox in self.hub.listeners(key):
            if len(inbox.waiting) >= inbox.depth:
                inbox.waiting.popleft()
            inbox.waiting.append(MemorySample(key, payload))

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        inbox = MemoryInbox(self.hub, key, depth)
        self.hub.add(inbox)
        return inbox

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:  # noqa: ARG002
        """Ask the first who serves the key, or with a selector all; where nobody does, it ends at once."""
        pending = MemoryPending()
        self.hub.record("query", key, payload)
        asked = [desk for desk in self.hub.desks if intersects(desk.expression, key)]
        for desk in asked if "*" in key else asked[:1]:
            desk.ask(key, payload, pending)
        return pending

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression."""
        desk = MemoryDesk(self.hub, key, limit)
        self.hub.desks.append(desk)
        return desk

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        return bool(self.hub.listeners(key))

    def announce(self, name: str) -> None:
        """Show that ``name`` is alive until ``close``; twice is once."""
        if name in self._announced:
            return
        self.hub.names[name] = None
        self._announced.append(name)

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        return frozenset(self.hub.names)

    def awake(self) -> frozenset[str]:
        """Return the same: in one thread nobody hangs alone."""
        return self.alive()

    def goes_on(self, name: str) -> bool:
        """Say whether one name is among those."""
        return name in self.awake()

    def lease(self) -> Lease | None:
        """Return the lease of this process's role."""
        return self.held

    def close(self) -> None:
        """Take back what was announced here."""
        for name in self._announced:
            self.hub.names.pop(name, None)
        self._announced.clear()
