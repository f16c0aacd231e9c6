"""The last minute of a robot, in memory: bounded by seconds and by bytes, and nothing in it is decoded.

All but the newest and the oldest of it is kept packed, which takes an eighth of the memory: what a robot says
repeats itself.
"""

from __future__ import annotations

import pickle
import zlib
from collections import deque
from collections.abc import Iterable, Mapping
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
"""Nanoseconds of a second: a message's host time is in them."""
BLOCK: Final = 512
"""Messages that are packed together: about a second of a robot that moves. Fewer pack worse."""
QUICK: Final = 1
"""zlib's level: the best one packs a third smaller and takes six times as long."""


def _packed(messages: Iterable[Recorded]) -> bytes:
    return zlib.compress(pickle.dumps(tuple(messages), pickle.HIGHEST_PROTOCOL), QUICK)


def _unpacked(block: bytes) -> tuple[Recorded, ...]:
    messages: tuple[Recorded, ...] = pickle.loads(zlib.decompress(block))  # noqa: S301 - packed here
    return messages


@dataclass(frozen=True)
class Kept:
    """What a ring held at a moment, most of it still packed."""

    first: tuple[Recorded, ...]
    blocks: tuple[bytes, ...]
    last: tuple[Recorded, ...]

    def messages(self) -> list[Recorded]:
        """Return all, in the order in which they were heard; it unpacks them, outside the loop."""
        packed = (message for block in self.blocks for message in _unpacked(block))
        return [*self.first, *packed, *self.last]


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
    """Bytes that it holds, as they were said."""
    _oldest: deque[Recorded] = field(default_factory=deque)
    """From here they go; when it is empty, the next block is unpacked."""
    _blocks: deque[bytes] = field(default_factory=deque)
    _recent: deque[Recorded] = field(default_factory=deque)
    _before: dict[str, Recorded] = field(default_factory=dict)

    def add(self, message: Recorded) -> None:
        """Take a message in; what is too old goes."""
        if len(self._recent) >= BLOCK:
            self._blocks.append(_packed(self._recent))
            self._recent.clear()
        self._recent.append(message)
        self.size += _weight(message)
        while (first := self._first()) and (self.size > self.most or self._is_old(first, message)):
            self._let_go()

    @property
    def span(self) -> Span:
        """From when to when it is whole."""
        first = self._first()
        if first is None:
            return Span(0.0, 0.0)
        newest = self._recent[-1] if self._recent else self._oldest[-1]
        return Span(first.at, newest.at)

    def kept(self) -> Kept:
        """Return what it holds now; later messages change nothing in it."""
        before = sorted(self._before.values(), key=lambda each: each.host)
        return Kept((*before, *self._oldest), tuple(self._blocks), tuple(self._recent))

    def messages(self) -> list[Recorded]:
        """Return all, in the order in which they were heard."""
        return self.kept().messages()

    @property
    def before(self) -> Mapping[str, Recorded]:
        """The last message of each key from before the minute."""
        return self._before

    def _is_old(self, message: Recorded, newest: Recorded) -> bool:
        return newest.at - message.at > self.seconds and (newest.host - message.host) / NANO > self.seconds

    def _first(self) -> Recorded | None:
        """Return the oldest message of the minute; None when there is none."""
        if not self._oldest and self._blocks:
            self._oldest.extend(_unpacked(self._blocks.popleft()))
        held = self._oldest or self._recent
        return held[0] if held else None

    def _let_go(self) -> None:
        gone = (self._oldest or self._recent).popleft()
        replaced = self._before.pop(gone.key, None)
        self._before[gone.key] = gone
        self.size -= 0 if replaced is None else _weight(replaced)
        while len(self._before) > KEYS or (self.size > self.most and self._first() is None):
            first = next(iter(self._before))
            self.size -= _weight(self._before.pop(first))


def _weight(message: Recorded) -> int:
    return len(message.payload) + OVERHEAD
