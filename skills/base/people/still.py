"""Places where something stands that no map knows: the legs of furniture. Nobody walks there."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

SAME: Final = 0.12
"""Metres: noise and a leg seen from another side shift a hit by less."""
HITS: Final = 10
"""Scans that must have shown it: somebody at 0.3 m/s is past a place in eight."""
FORGOTTEN: Final = 3.0
"""Robot seconds without a hit after which a place is free again: a thin leg is missed now and then."""
DRAWN: Final = 0.2
"""Share by which a new hit draws the place."""


@dataclass
class _Place:
    x: float
    y: float
    hits: int = 1
    unseen: float = 0.0


class StillPlaces:
    """Remembers where hits stay. Call ``see`` once a scan."""

    def __init__(self) -> None:
        self._places: list[_Place] = []

    def see(self, parts: Iterable[tuple[float, float]], seconds: float) -> None:
        """Take in the middles (m, in map) of what a scan shows, ``seconds`` after the last one."""
        for known in self._places:
            known.unseen += seconds
        fresh = []
        for x, y in parts:
            place = self._at(x, y)
            if place is None:
                fresh.append(_Place(x, y))
            elif place.unseen > 0.0:
                place.x += DRAWN * (x - place.x)
                place.y += DRAWN * (y - place.y)
                place.hits, place.unseen = place.hits + 1, 0.0
        self._places = [each for each in (*self._places, *fresh) if each.unseen < FORGOTTEN]

    def holds(self, x: float, y: float) -> bool:
        """Say whether something has stood there for a while."""
        place = self._at(x, y)
        return place is not None and place.hits >= HITS

    def clear(self) -> None:
        """Forget all."""
        self._places.clear()

    def _at(self, x: float, y: float) -> _Place | None:
        near = [(math.dist((x, y), (each.x, each.y)), each.hits, each) for each in self._places]
        near = [each for each in near if each[0] < SAME]
        return min(near, key=lambda each: (each[1] < HITS, each[0]))[2] if near else None
