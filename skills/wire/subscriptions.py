"""A session's subscriptions: what many listen to in a process arrives, and is copied, once."""

from __future__ import annotations

from dataclasses import dataclass

import zenoh

from tandem.skills.ports.delivery import paced
from tandem.skills.ports.keys import CLOCK
from tandem.skills.wire.keyed_queue import KeyedQueue
from tandem.skills.wire.memory import MemorySample
from tandem.skills.wire.strays import Strays, hear
from tandem.skills.wire.zenoh_ends import Waker, ZenohInbox


@dataclass(eq=False)
class _Shared:
    """A key expression that the process hears, and who gets what comes."""

    inboxes: tuple[ZenohInbox, ...] = ()
    """Replaced, never changed: another thread goes through them."""
    subscriber: zenoh.Subscriber[None] | None = None


class Subscriptions:
    """Call it from one thread.

    Args:
        session: it ends with its owner.
        prefix: put before every key.
        waker: told when something has arrived that can't wait.
        strays: counts what is no message.
    """

    def __init__(self, session: zenoh.Session, prefix: str, waker: Waker, strays: Strays) -> None:
        self._session, self._prefix, self._waker, self._strays = session, prefix, waker, strays
        self._shared: dict[str, _Shared] = {}

    def add(self, key: str, depth: int) -> ZenohInbox:
        """Return an inbox of what is put on the key expression from now on."""
        shared = self._shared.setdefault(key, _Shared())
        inbox = ZenohInbox(KeyedQueue(depth, "oldest goes"), lambda: self._remove(key, inbox))
        shared.inboxes = (*shared.inboxes, inbox)
        if shared.subscriber is None:
            shared.subscriber = self._declare(key, shared)
        return inbox

    def _declare(self, key: str, shared: _Shared) -> zenoh.Subscriber[None]:
        start = len(self._prefix) + 1
        wake = self._waker.tick if key == CLOCK.key else None if paced(key) else self._waker.wake

        def take(whole: str, sample: zenoh.Sample) -> None:
            name = whole[start:]
            told = MemorySample(name, sample.payload.to_bytes())
            for inbox in shared.inboxes:
                inbox.waiting.put(name, told)
            if wake is not None:
                wake()

        return hear(self._session, f"{self._prefix}/{key}", self._strays, key, take)

    def _remove(self, key: str, inbox: ZenohInbox) -> None:
        shared = self._shared[key]
        shared.inboxes = tuple(each for each in shared.inboxes if each is not inbox)
        if not shared.inboxes and shared.subscriber is not None:
            del self._shared[key]
            shared.subscriber.undeclare()  # type: ignore[no-untyped-call]
