"""What zenoh's callbacks fill and the loop drains: inboxes, desks, queries. Callbacks only enqueue."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import zenoh

from tandem.skills.ports.bus import Request, Sample
from tandem.skills.wire.keyed_queue import DESK_DEPTH, KeyedQueue
from tandem.skills.wire.memory import MemorySample


@dataclass(eq=False)
class Waker:
    """Wakes the loop when something has arrived."""

    calm: float = 0.0
    """Host seconds between two ticks of the clock that wake the loop; those in between wait for whatever
    wakes it next."""
    monotonic: Callable[[], float] = time.monotonic
    _event: threading.Event = field(default_factory=threading.Event)
    _ticked_at: float = float("-inf")

    def wake(self) -> None:
        """Let ``wait`` return; may be called from any thread."""
        self._event.set()

    def tick(self) -> None:
        """Wake the loop for a tick of the hardware's clock, unless one has just done so."""
        now = self.monotonic()
        if now - self._ticked_at >= self.calm:
            self._ticked_at = now
            self.wake()

    @property
    def woken(self) -> bool:
        """Whether ``wait`` returns at once."""
        return self._event.is_set()

    def wait(self, timeout: float) -> None:
        """Wait until woken, at most ``timeout`` seconds."""
        self._event.wait(timeout)
        self._event.clear()


@dataclass(eq=False)
class ZenohInbox:
    """What a subscription holds until it is drained."""

    waiting: KeyedQueue[MemorySample]
    end: Callable[[], None] | None = None
    """Ends the subscription."""

    def drain(self) -> list[Sample]:
        """Take all that has arrived."""
        return [*self.waiting.drain()]

    def close(self) -> None:
        """End the subscription."""
        if self.end is not None:
            self.end()
            self.end = None


@dataclass(eq=False)
class ZenohPending:
    """A query under way."""

    waker: Waker
    answer: bytes | None = None
    error: bytes | None = None
    ended: bool = False

    def poll(self) -> bytes | None:
        """Return the answer, or None while there is none."""
        return self.answer

    def refusal(self) -> bytes | None:
        """Return the error that was answered, or None."""
        return self.error

    def done(self) -> bool:
        """Say whether no (further) answer will come."""
        return self.ended

    def take(self, reply: zenoh.Reply) -> None:
        """Keep the first answer."""
        if reply.ok is not None and self.answer is None:
            self.answer = reply.ok.payload.to_bytes()
        elif reply.err is not None and not _from_zenoh(reply.err):
            self.error = reply.err.payload.to_bytes()
        self.waker.wake()

    def end(self) -> None:
        """No more will come."""
        self.ended = True
        self.waker.wake()


def _from_zenoh(error: zenoh.ReplyError) -> bool:
    """Say whether zenoh itself made an error: its time-out is no answer of anybody's."""
    return error.encoding != zenoh.Encoding.APPLICATION_JSON


@dataclass(eq=False)
class ZenohRequest:
    """One query that waits for its answer."""

    key: str
    selector: str
    size: int
    payload: bytes
    prefix: str
    query: zenoh.Query | None

    def covers(self, key: str) -> bool:
        """Say whether the selector stands for the key."""
        return self.query is not None and self.query.key_expr.includes(zenoh.KeyExpr(f"{self.prefix}{key}"))

    def reply(self, payload: bytes) -> None:
        """Answer; a second answer is ignored."""
        self.reply_each({self.key: payload})

    def reply_each(self, answers: Mapping[str, bytes]) -> None:
        """Answer under each key."""
        if self.query is not None:
            for key, payload in answers.items():
                self.query.reply(f"{self.prefix}{key}", payload, express=True)
            self.end()

    def refuse(self, payload: bytes) -> None:
        """Answer with an error."""
        if self.query is not None:
            self.query.reply_err(payload, encoding=zenoh.Encoding.APPLICATION_JSON)
            self.end()

    def end(self) -> None:
        """End without an answer."""
        if self.query is not None:
            self.query.drop()  # type: ignore[no-untyped-call]
            self.query = None


@dataclass(eq=False)
class ZenohDesk:
    """Queries that wait at a key."""

    waiting: KeyedQueue[ZenohRequest] = field(default_factory=lambda: KeyedQueue(DESK_DEPTH, "newest goes"))
    queryable: zenoh.Queryable[None] | None = None

    def drain(self) -> list[Request]:
        """Take all that has arrived."""
        return [*self.waiting.drain()]

    def close(self) -> None:
        """Stop serving; what waits ends without an answer."""
        if self.queryable is not None:
            self.queryable.undeclare()  # type: ignore[no-untyped-call]
            self.queryable = None
        for request in self.waiting.drain():
            request.end()
