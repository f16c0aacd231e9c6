"""Walks through a record, and knows at each moment what was known then."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from tandem.executive.records.known import Known
from tandem.executive.records.recording import Recorded, Recording

FAR: Final = 10.0
"""Seconds of a record that are skipped rather than walked through: about 5,000 messages, which take a few
hundredths of a second. What was known beyond is looked up."""


class Tape:
    """A record with a place in it, before its first message at the beginning.

    Args:
        record: its owner closes it.
    """

    def __init__(self, record: Recording) -> None:
        self.record = record
        self._last: dict[str, Recorded] = {}
        self._at = -math.inf
        self._messages = record.messages()
        self._next = next(self._messages, None)

    @property
    def at(self) -> float:
        """Where it is, in robot seconds since the recorder began; before the first message minus infinity."""
        return self._at

    def known(self) -> Known:
        """Return what is known here."""
        newest = next(reversed(self._last.values()), None)
        at = self._at if math.isfinite(self._at) else self.record.span.begin
        return Known(at, None if newest is None else newest.stamp, dict(self._last))

    def walk(self, until: float) -> Iterator[Recorded]:
        """Yield the messages up to and with a moment that is not before this one, taking each in."""
        while self._next is not None and self._next.at <= until:
            message = self._next
            self._take(message)
            yield message
        self._at = max(self._at, until)

    def go(self, at: float) -> None:
        """Go to a moment, forward or back."""
        if at < self._at or at - self._at > FAR:
            self._last = dict(self.record.known(at))
            self._at = at
            self._messages = self.record.messages(math.nextafter(at, math.inf))
            self._next = next(self._messages, None)
        for _ in self.walk(at):
            pass

    def _take(self, message: Recorded) -> None:
        self._last.pop(message.key, None)
        self._last[message.key] = message  # the newest stands last
        self._at = max(self._at, message.at)
        self._next = next(self._messages, None)
