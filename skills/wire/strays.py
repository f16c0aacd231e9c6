"""What arrives under no key of its own: put on a wildcard, or a deletion. It is nobody's message.

zenoh hands what is put on ``<site>/**`` to every subscriber below, under the name ``<site>/**``. One such put
was a request, a stop that had been released and a set-point at once, to whoever listened to these. A
deletion has no payload, and would be read as an empty document.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Final

import zenoh

from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.wire.direct import direct
from tandem.skills.wire.keyed_queue import KEYS

_WHY: Final = "put on a wildcard, or a deletion: a message is put under its own key"


def is_stray(key: str, sample: zenoh.Sample) -> bool:
    """Say whether a sample is no message; ``key`` is its key expression in full."""
    return "*" in key or sample.kind != zenoh.SampleKind.PUT


class Strays:
    """Counts them for the process's ear. Any thread notes, and the loop's tells."""

    def __init__(self) -> None:
        self._noting = threading.Lock()  # several sessions of a process share one
        self._met: dict[str, int] = {}
        self._told: dict[str, int] = {}

    def note(self, heard_at: str) -> None:
        """Count one more; ``heard_at`` is the key expression of the subscription."""
        with self._noting:
            if heard_at in self._met or len(self._met) < KEYS:
                self._met[heard_at] = self._met.get(heard_at, 0) + 1

    def tell(self, ear: Ear) -> None:
        """Have the ear count what has come since the last time."""
        if self._met == self._told:
            return
        for key, count in tuple(self._met.items()):
            more = count - self._told.get(key, 0)
            self._told[key] = count
            if more:
                ear.refuse(key, Reason.STRAY, _WHY, more)


def hear(
    session: zenoh.Session,
    expression: str,
    strays: Strays,
    heard_at: str,
    take: Callable[[str, zenoh.Sample], None],
) -> zenoh.Subscriber[None]:
    """Subscribe. This is the only place that does, so that no ear forgets to tell strays from messages.

    Args:
        session: the subscription ends with it.
        expression: the key expression in full.
        strays: counts what is no message.
        heard_at: the name under which it counts them.
        take: called with each message and its key in full, in the thread that receives.
    """

    def arrived(sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        if is_stray(key, sample):
            strays.note(heard_at)
        else:
            take(key, sample)

    return session.declare_subscriber(expression, direct(arrived))
