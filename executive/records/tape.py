"""Walks through a record, and knows at each moment what was known then."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator
from typing import Final

from tandem.executive.records.known import Known
from tandem.executive.records.recording import Recorded, Recording

MARK_EVERY: Final = 10.0
"""Seconds of a record between two moments to which a tape goes back without reading from the beginning: about
5,000 messages, which take a few hundredths of a second."""


class Tape:
    """A record with a place in it, before its first message at the beginning.

    Args:
        record: its owner closes it.
    """

    def __init__(self, record: Recording) -> None:
        self.record = record
        self._last: dict[str, Recorded] = {}
        self._marks: list[tuple[float, dict[str, Recorded]]] = []
        """Moments, and what was known just before them."""
        self._marked = record.span.begin
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
        if at < self._at:
            self._back(at)
        for _ in self.walk(at):
            pass

    def _take(self, message: Recorded) -> None:
        if message.at - self._marked >= MARK_EVERY:
            self._marks.append((message.at, dict(self._last)))  # this is the first message of its moment
            self._marked = message.at
        self._last.pop(message.key, None)
        self._last[message.key] = message  # the newest stands last
        self._at = max(self._at, message.at)
        self._next = next(self._messages, None)

    def _back(self, at: float) -> None:
        place = bisect_right([mark for mark, _ in self._marks], at)
        if place:
            mark, known = self._marks[place - 1]
            self._begin(mark, known)
        else:
            self._begin(-math.inf, {})

    def _begin(self, since: float, known: dict[str, Recorded]) -> None:
        self._last = dict(known)
        self._at = since
        self._marked = self._marks[-1][0] if self._marks else self.record.span.begin
        self._messages = self.record.messages(since)
        self._next = next(self._messages, None)
