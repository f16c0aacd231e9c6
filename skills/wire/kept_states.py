"""What a process keeps of the states that it has told: said once more, and answered to who asks."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator
from typing import Final

from tandem.skills.ports.delivery import AGAIN_AFTER, KEPT_KEYS

AT_ONCE: Final = 8
"""States that are said again with one beat, and questions that are answered: a turn must stay short."""


class Kept:
    """The latest payload of each state, and which of them have been said once only.

    Args:
        monotonic: the host's clock, in seconds.
    """

    def __init__(self, monotonic: Callable[[], float]) -> None:
        self._monotonic = monotonic
        self.latest: OrderedDict[str, bytes] = OrderedDict()
        """By key, the one that was said last at the end."""
        self._once: OrderedDict[str, float] = OrderedDict()

    def note(self, key: str, payload: bytes) -> None:
        """Keep what was just said."""
        self.latest[key] = payload
        self.latest.move_to_end(key)
        self._once[key] = self._monotonic()
        self._once.move_to_end(key)
        while len(self.latest) > KEPT_KEYS:
            gone, _ = self.latest.popitem(last=False)
            self._once.pop(gone, None)

    def due(self) -> Iterator[tuple[str, bytes]]:
        """Yield what is to be said once more, key and payload; each time once."""
        before = self._monotonic() - AGAIN_AFTER
        for _ in range(AT_ONCE):
            key = next(iter(self._once), None)
            if key is None or self._once[key] > before:
                return
            del self._once[key]
            yield key, self.latest[key]
