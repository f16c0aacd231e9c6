"""A bus around a bus that loses, delays, doubles and mixes up messages: what a bad network does.

All of it happens at the receiving end, where what has arrived is held back until its time: so nothing needs a
thread or a pump. It gets out when the node next drains its inbox, asks its desk or polls its query. Each such
call takes in what has arrived at all ends of the bus: what nobody has read for long did not arrive just now.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Annotated, Final, Generic, Protocol, TypeVar

from pydantic import Field

from tandem.skills.ports.bus import Bus, Desk, Inbox, Pending, Request, Sample
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.ports.message import MAX_REQUEST_BYTES, Message

T = TypeVar("T", Sample, Request)

HEARD_EVERY: Final = 0.005
"""Seconds after which all ends are asked again for what has arrived."""
OVERTAKEN_BY: Final = 0.1
"""Seconds that a message which others shall overtake is held back on top of its delay."""

Share = Annotated[float, Field(ge=0.0, le=1.0)]


class BusFaults(Message):
    """What goes wrong with messages under the ``keys``; shares are of all of them."""

    delay: float = Field(default=0.0, ge=0.0, le=60.0)
    """Seconds (monotonic clock) by which a message or an answer is late at the most; drawn evenly."""
    drop: Share = 0.0
    """Of messages, and of queries: half of these lose the question, the others the answer."""
    double: Share = 0.0
    """Of messages and requests: they arrive twice."""
    reorder: Share = 0.0
    """Of messages and requests: they are held back for another 0.1 s, so that later ones overtake them."""
    keys: tuple[str, ...] = ("skill/", "world/", "task/")
    """How the keys begin that this happens to."""
    spared: tuple[str, ...] = ("hw/stop", "hw/clock")
    """How the keys begin that it doesn't happen to all the same."""

    def concerns(self, key: str) -> bool:
        """Say whether messages on the key may suffer."""
        return key.startswith(self.keys) and not key.startswith(self.spared)


@dataclass(eq=False)
class _Queue(Generic[T]):
    """Holds back what has arrived until its time. Within it the order stays, but for what is overtaken."""

    faults: BusFaults
    rng: random.Random
    clocks: Clocks
    held: list[tuple[float, int, T]] = field(default_factory=list)
    count: int = 0
    last: float = 0.0

    def arrive(self, arrived: list[T], *, drop: float) -> None:
        """Take in what has arrived."""
        now = self.clocks.monotonic()
        for each in arrived:
            if not self.faults.concerns(each.key):
                self._hold(each, now)
                continue
            if self.rng.random() < drop:
                continue
            for _ in range(1 + (self.rng.random() < self.faults.double)):
                self._delay(each, now)

    def take(self) -> list[T]:
        """Return what is due, in its order."""
        now = self.clocks.monotonic()
        self.held.sort(key=lambda entry: entry[:2])
        due = [each for at, _, each in self.held if at <= now]
        del self.held[: len(due)]
        return due

    def _delay(self, each: T, now: float) -> None:
        at = now + self.rng.random() * self.faults.delay
        if self.rng.random() < self.faults.reorder:
            self._hold(each, at + OVERTAKEN_BY)
            return
        self.last = max(self.last, at)
        self._hold(each, self.last)

    def _hold(self, each: T, at: float) -> None:
        self.held.append((at, self.count, each))
        self.count += 1


class _Source(Protocol[T]):
    """An inbox or a desk."""

    def drain(self) -> list[T]: ...

    def close(self) -> None: ...


@dataclass(eq=False)
class FaultyEnd(Generic[T]):
    """A subscription, or the desk of a service, through a bad network.

    ``drop`` is the share that gets lost: of queries none, for it is who asks that loses them. Of a doubled
    query the first answer counts.
    """

    inner: _Source[T]
    queue: _Queue[T]
    bus: FaultyBus
    drop: float

    def hear(self) -> None:
        """Take in what has arrived."""
        self.queue.arrive(self.inner.drain(), drop=self.drop)

    def drain(self) -> list[T]:
        """Take all that has got through by now."""
        self.bus.hear()
        self.hear()
        return self.queue.take()

    def close(self) -> None:
        """End it; what is under way is lost, and a query that waits ends without an answer."""
        self.bus.forget(self)
        self.queue.held.clear()
        self.inner.close()


@dataclass(eq=False)
class FaultyPending:
    """A query under way through a bad network.

    ``inner`` is None when the question got lost; with ``mute`` the answer does. It ends at ``until`` then.
    """

    clocks: Clocks
    inner: Pending | None
    mute: bool
    late: float
    until: float
    answered: float | None = None

    def poll(self) -> bytes | None:
        """Return the answer once it has got through, or None."""
        if self.inner is None or self.mute:
            return None
        answer = self.inner.poll()
        now = self.clocks.monotonic()
        if answer is not None and self.answered is None:
            self.answered = now
        return answer if self.answered is not None and now >= self.answered + self.late else None

    def refusal(self) -> bytes | None:
        """Return the error that was answered, or None; an error is never late."""
        return None if self.inner is None or self.mute else self.inner.refusal()

    def done(self) -> bool:
        """Say whether no (further) answer will come."""
        if self.inner is None or self.mute:
            return self.clocks.monotonic() >= self.until
        if self.inner.poll() is not None:
            return self.poll() is not None and self.inner.done()
        return self.inner.done()


class FaultyBus(ForwardingBus):
    """Another bus through a bad network; with no faults it is the other bus.

    What goes wrong with a message goes wrong where it arrives.

    Args:
        bus: what messages travel on.
        clocks: their monotonic clock counts the delays.
        seed: of what happens to which message; the same messages in the same order suffer the same.
        faults: what may happen.
    """

    def __init__(self, bus: Bus, clocks: Clocks, seed: str, faults: BusFaults | None) -> None:
        super().__init__(bus)
        self._clocks, self._faults = clocks, faults
        self._rng = random.Random(seed)  # noqa: S311 - no secret hangs on it
        self._ends: list[FaultyEnd[Sample] | FaultyEnd[Request]] = []
        self._heard_at = float("-inf")

    def hear(self) -> None:
        """Take in what has arrived at all ends, unless that has just been done."""
        now = self._clocks.monotonic()
        if now - self._heard_at >= HEARD_EVERY:
            self._heard_at = now
            for end in self._ends:
                end.hear()

    def forget(self, end: FaultyEnd[Sample] | FaultyEnd[Request]) -> None:
        """Take an end out that is closed."""
        self._ends = [each for each in self._ends if each is not end]

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what gets through."""
        inner = super().subscribe(key, depth=depth)
        if self._faults is None:
            return inner
        queue = _Queue[Sample](self._faults, self._rng, self._clocks)
        inbox = FaultyEnd(inner, queue, self, self._faults.drop)
        self._ends.append(inbox)
        return inbox

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Ask; the question or the answer may get lost, and the answer may be late."""
        faults = self._faults
        if faults is None or not faults.concerns(key):
            return super().query(key, payload, timeout=timeout)
        fate, late = self._rng.random(), self._rng.random() * faults.delay
        lost = fate < faults.drop / 2
        inner = None if lost else super().query(key, payload, timeout=timeout)
        until = self._clocks.monotonic() + timeout
        return FaultyPending(self._clocks, inner, mute=fate < faults.drop, late=late, until=until)

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries that get through."""
        inner = super().serve(key, limit=limit)
        if self._faults is None:
            return inner
        queue = _Queue[Request](self._faults, self._rng, self._clocks)
        desk = FaultyEnd(inner, queue, self, 0.0)
        self._ends.append(desk)
        return desk
