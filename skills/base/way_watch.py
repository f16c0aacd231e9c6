"""Is the way ahead free? What the laser sees now, against the place that the base will take."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.localiser import Localiser
from tandem.skills.base.obstacles import Obstacles
from tandem.skills.base.path import Path
from tandem.skills.base.people.tracker import Tracker

AHEAD: Final = 2.2
"""Metres of path that are watched: more than the base needs to stop."""
STEP: Final = 0.04
"""Metres between watched points of the path: much less than a footprint's radius."""
SURE: Final = 0.03
"""Metres inside the footprint's radius from which a hit counts even where a map knows of something."""
HITS: Final = 3
"""Beams that must agree on it."""


@dataclass(frozen=True)
class Block:
    """Something in the way: metres along the path where the base would touch it, and where it is."""

    way: float
    x: float
    y: float


class Watch:
    """Looks along a path once a scan.

    Args:
        localiser: the newest scan, in the map.
        obstacles: what was seen and is on no map.
        radius: the footprint's (m).
        people: who walks about: they are not in the way for long.
    """

    def __init__(
        self, localiser: Localiser, obstacles: Obstacles, radius: float, people: Tracker | None = None
    ) -> None:
        self._localiser, self._obstacles, self._radius = localiser, obstacles, radius
        self._people = people
        self._number = -1
        self._found: Block | None = None

    def block(self, path: Path, way: float) -> Block | None:
        """Return the first thing that stands in the way ahead, as of the newest scan."""
        placed = self._localiser.placed
        if placed is not None and placed.number != self._number:
            self._number = placed.number
            hits = placed.points_in_map
            if self._people is not None:
                hits = hits[~self._people.hides(hits)]
            self._found = self._look(path, way, hits)
        return self._found

    def _look(self, path: Path, way: float, hits: FloatArray) -> Block | None:
        ways, centres = path.sampled(way, way + AHEAD, STEP)
        strange = self._obstacles.points
        first: Block | None = None
        for points, radius, needed in ((strange, self._radius, 1), (hits, self._radius - SURE, HITS)):
            if not len(points):
                continue
            gaps = np.hypot(*(centres[:, None, :] - points[None, :, :]).transpose(2, 0, 1))
            # What is too close already does not stop the base from leaving it.
            approached = gaps < np.minimum(radius, gaps[0] - 0.005)
            touched = approached.sum(axis=1) >= needed
            if not touched.any():
                continue
            at = int(np.argmax(touched))
            nearest = points[int(np.argmin(np.where(approached[at], gaps[at], np.inf)))]
            if first is None or ways[at] < first.way:
                first = Block(float(ways[at]), float(nearest[0]), float(nearest[1]))
        return first
