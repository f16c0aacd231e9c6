"""A way over the floor: straight pieces, and where on them the base is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.geometry.poses import wrap


@dataclass(frozen=True)
class Path:
    """Corner points in the map, shape (n, 2), n at least 2."""

    points: FloatArray

    @cached_property
    def ways(self) -> FloatArray:
        """Metres from the start to each point."""
        steps = np.hypot(*np.diff(self.points, axis=0).T)
        return np.concatenate(([0.0], np.cumsum(steps)))

    @property
    def length(self) -> float:
        """Metres from start to end."""
        return float(self.ways[-1])

    @cached_property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """(metres from the start, radians turned there) of each inner point."""
        headings = [self._heading(i) for i in range(len(self.points) - 1)]
        return tuple(
            (float(self.ways[i]), abs(wrap(headings[i] - headings[i - 1]))) for i in range(1, len(headings))
        )

    def _heading(self, piece: int) -> float:
        step = self.points[piece + 1] - self.points[piece]
        return math.atan2(float(step[1]), float(step[0]))

    def heading_at(self, way: float) -> float:
        """Return the direction (rad) of the piece at that many metres."""
        return self._heading(self._piece(way))

    def _piece(self, way: float) -> int:
        piece = int(np.searchsorted(self.ways, way, side="right")) - 1
        return min(max(piece, 0), len(self.points) - 2)

    def at(self, way: float) -> tuple[float, float]:
        """Return the point at that many metres; beyond the end on the last piece's line."""
        piece = self._piece(way)
        start, end = self.points[piece], self.points[piece + 1]
        span = float(self.ways[piece + 1] - self.ways[piece])
        share = (way - float(self.ways[piece])) / max(span, 1e-9)
        return (
            float(start[0] + share * (end[0] - start[0])),
            float(start[1] + share * (end[1] - start[1])),
        )

    def sampled(self, start: float, end: float, step: float) -> tuple[FloatArray, FloatArray]:
        """Return (metres, points) each ``step`` metres between two places, the ends with them."""
        start, end = max(start, 0.0), min(end, self.length)
        ways = np.linspace(start, max(start, end), max(2, math.ceil((end - start) / step) + 1))
        x = np.interp(ways, self.ways, self.points[:, 0])
        y = np.interp(ways, self.ways, self.points[:, 1])
        return ways, np.stack((x, y), axis=1)

    def project(self, x: float, y: float, after: float, window: float = 0.8) -> float:
        """Return the metres to the path's point nearest (x, y), between ``after`` and ``window`` farther on.

        On the last piece it may run beyond the end, so that having gone too far is seen.
        """
        # A base that rolls back a little is still at ``after``, not at the next corner.
        best, best_gap = after, math.dist(self.at(after), (x, y))
        for piece in range(self._piece(after), self._piece(after + window) + 1):
            start, step = self.points[piece], self.points[piece + 1] - self.points[piece]
            span = float(np.hypot(step[0], step[1]))
            if span < 1e-9:  # noqa: PLR2004 - two equal points
                continue
            along = float(((x - start[0]) * step[0] + (y - start[1]) * step[1]) / span)
            last = piece == len(self.points) - 2
            along = max(along, 0.0) if last else min(max(along, 0.0), span)
            gap = math.hypot(
                float(start[0] + along / span * step[0]) - x, float(start[1] + along / span * step[1]) - y
            )
            way = float(self.ways[piece]) + along
            if gap < best_gap and way >= after - 1e-9:
                best, best_gap = way, gap
        return best
