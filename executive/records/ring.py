"""The last minute of a robot, in memory: bounded by seconds and by bytes, and nothing in it is decoded."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from tandem.executive.records.recording import Recorded, Span

SECONDS: Final = 60.0
"""How far back it goes, in robot time and in host time. A fetch takes 60 to 90 s; what made it fail lies in
the last phases."""
BYTES: Final = 48 * 1024 * 1024
"""A robot with two arms says 0.2 to 0.4 MB a second: a minute of it fits twice."""
KEYS: Final = 512
"""Keys whose last message from before the minute is kept. A robot has about 100, and one for each task."""
OVERHEAD: Final = 300
"""Bytes of a message besides its payload, as ``sys.getsizeof`` adds up."""
NANO: Final = 1e9


@dataclass(eq=False)
class Ring:
    """The messages of the last minute, and the last one of each key from before it.

    Args:
        seconds: what is older than this in robot time and in host time is let go.
        most: bytes that it may hold; then the oldest go.
    """

    seconds: float = SECONDS
    most: int = BYTES
    size: int = 0
    """Bytes that it holds."""
    _recent: deque[Recorded] = field(default_factory=deque)
    _before: dict[str, Recorded] = field(default_factory=dict)

    def add(self, message: Recorded) -> None:
        """Take a message in; what is too old goes."""
        self._recent.append(message)
        self.size += _weight(message)
        while self._recent and (self.size > self.most or self._is_old(self._recent[0], message)):
            self._let_go()

    @property
    def span(self) -> Span:
        """From when to when it is whole."""
        if not self._recent:
            return Span(0.0, 0.0)
        return Span(self._recent[0].at, self._recent[-1].at)

    def messages(self) -> list[Recorded]:
        """Return all, in the order in which they were heard."""
        return [*sorted(self._before.values(), key=lambda each: each.host), *self._recent]

    @property
    def before(self) -> Mapping[str, Recorded]:
        """The last message of each key from before the minute."""
        return self._before

    def _is_old(self, message: Recorded, newest: Recorded) -> bool:
        return newest.at - message.at > self.seconds and (newest.host - message.host) / NANO > self.seconds

    def _let_go(self) -> None:
        gone = self._recent.popleft()
        replaced = self._before.pop(gone.key, None)
        self._before[gone.key] = gone
        self.size -= 0 if replaced is None else _weight(replaced)
        while len(self._before) > KEYS or (self.size > self.most and not self._recent):
            first = next(iter(self._before))
            self.size -= _weight(self._before.pop(first))


def _weight(message: Recorded) -> int:
    return len(message.payload) + OVERHEAD
