"""One question to whoever serves a key, put again while there is no answer. Clients and commands ask so.

A question or its answer may be lost: zenoh drops what has had no room on the way out for a millisecond, as on
a machine that is busy, and who asked is told when its time is over: after three minutes, if that is its
patience. So an open question is put once more after ``OPEN_FOR`` seconds, then after twice as long each time;
the first answer to any of them counts.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.tasks import TASK_STEP

AGAIN_AFTER: Final = 0.2
"""Seconds after which a question that ended without an answer is put again: zenoh may say that nobody serves
it just after somebody has come."""
OPEN_FOR: Final = 1.0
"""Seconds after which an open question is put once more. An executive answers within some milliseconds; it is
away for 1 s after a crash."""
NOT_TWICE: Final = frozenset({TASK_STEP.key})
"""Questions that are put again only when they have ended unanswered: two steps are not one. Whatever else is
asked twice is done once."""


class Asking:
    """A question under way.

    Args:
        bus: where it is put.
        key: who serves this.
        payload: the question.
        monotonic: seconds of the host's monotonic clock.
        patience: host seconds after which it is given up.
    """

    def __init__(
        self, bus: Bus, key: str, payload: bytes, monotonic: Callable[[], float], patience: float
    ) -> None:
        self._bus, self._key, self._payload, self._monotonic = bus, key, payload, monotonic
        self._deadline = monotonic() + patience
        self._open: list[Pending] = []
        self._pause = OPEN_FOR
        self._put_at = 0.0
        self._refusal: bytes | None = None
        self.answer: bytes | None = None
        """The first answer, None while there is none."""
        self._put()

    def left(self) -> float:
        """Return seconds for which it may be left alone, unless a message comes; 0.0 when it is over."""
        now = self._monotonic()
        self._look()
        if self.answer is not None or now >= self._deadline:
            return 0.0
        due = self._due()
        if now >= due:
            self._put()
            due = self._due()
        return min(due, self._deadline) - now

    def refusal(self) -> bytes | None:
        """Return the error with which the question ended last, or None when it ended without one."""
        return self._refusal

    def _look(self) -> None:
        for pending in self._open:
            if self.answer is None:
                self.answer = pending.poll()
            if pending.done():
                self._refusal = pending.refusal()
        self._open = [pending for pending in self._open if not pending.done()]

    def _due(self) -> float:
        if not self._open:
            return self._put_at + AGAIN_AFTER
        return self._deadline if self._key in NOT_TWICE else self._put_at + self._pause

    def _put(self) -> None:
        if self._open:
            self._pause *= 2.0
        self._put_at = self._monotonic()
        within = max(0.0, self._deadline - self._put_at)
        self._open.append(self._bus.query(self._key, self._payload, timeout=within))
