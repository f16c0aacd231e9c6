"""A bounded queue, drained now and then, in which one key's flood takes no place from another's."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Iterator
from typing import Final, Generic, Literal, TypeVar

T = TypeVar("T")

KEYS: Final = 256
"""Keys that have a queue of their own; whoever makes up more of them shares one."""
DESK_DEPTH: Final = 128
"""Queries that wait at a key; further ones end without an answer."""


class KeyedQueue(Generic[T]):
    """Each key has room for ``depth``; taken out, all stand in the order in which they came.

    One thread puts and another drains: both only use what is atomic in a deque.

    Args:
        depth: places of a key.
        full: which goes when a key's places are taken, the oldest or the one that comes.
    """

    def __init__(self, depth: int, full: Literal["oldest goes", "newest goes"]) -> None:
        self._depth, self._full = depth, full
        self._order = itertools.count()
        self._waiting: dict[str, deque[tuple[int, T]]] = {}
        self._filled = False

    def has_room(self, key: str) -> bool:
        """Say whether one more of this key would be kept: asked before its bytes are copied."""
        return self._full == "oldest goes" or len(self._of(key)) < self._depth

    def put(self, key: str, item: T, /) -> None:
        """Keep it, unless its key's places are taken and the newest goes."""
        if self.has_room(key):
            self._of(key).append((next(self._order), item))
            self._filled = True

    def drain(self) -> list[T]:
        """Take all that is there."""
        if not self._filled:  # as it is in most turns of a loop, for most queues
            return []
        self._filled = False  # before it is looked: what comes meanwhile is taken now or the next time
        taken = [pair for waiting in tuple(self._waiting.values()) for pair in _emptied(waiting)]
        taken.sort(key=lambda pair: pair[0])
        return [item for _, item in taken]

    def _of(self, key: str) -> deque[tuple[int, T]]:
        waiting = self._waiting.get(key)
        if waiting is None:
            key = key if len(self._waiting) < KEYS else ""
            waiting = self._waiting.setdefault(key, deque(maxlen=self._depth))
        return waiting


def _emptied(waiting: deque[tuple[int, T]]) -> Iterator[tuple[int, T]]:
    for _ in range(len(waiting)):  # what comes meanwhile is for the next time
        yield waiting.popleft()
