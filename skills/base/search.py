"""Where on the whole floor the robot could be: a correlative search (Olson 2009) in slices.

Each heading is a slice: the scan's beams become offsets in a score grid, and each standing place one sum.
The best places, apart from each other, are then matched finely, and the best of those and the best elsewhere
are returned.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray, points_in
from tandem.skills.base.map import SiteMap
from tandem.skills.base.matcher import diagonal, match
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

CELL: Final = 0.05
"""Metres: the score grid."""
PLACE_STEP: Final = 0.1
"""Metres between two places that are scored; the fine match makes up for the rest."""
HEADINGS: Final = 120
"""Of a whole circle: 3 degrees apart."""
BEAMS: Final = 50
"""Beams that a coarse score takes, spread evenly."""
FINE_BEAMS: Final = 360
"""Beams that a fine match takes."""
SPREAD: Final = 0.12
"""Metres: scale of a beam's coarse score."""
FINE: Final = 0.04
"""Metres: scale of a beam's fine score."""
TOP: Final = 6
"""Places that each heading may put forward."""
KEPT: Final = 40
"""Coarse poses that are matched finely."""
STANDING: Final = 0.15
"""Metres from anything at which the base's axis can be."""
DISTINCT: Final = (0.2, 0.15)
"""Metres, radians: of nearer coarse poses only the best is matched finely."""
APART: Final = (0.35, 0.35)
"""Metres, radians: nearer poses are the same one."""
SOLID: Final = 0.08
"""Metres deep in a mapped thing: no beam goes through there."""


@dataclass(frozen=True)
class Found:
    """A pose and how the scan fits: ``fit`` is the share of beams within 10 cm, ``score`` is finer."""

    pose: FloorPose
    fit: float
    score: float


@dataclass(frozen=True)
class Region:
    """Poses to search: places, shape (n, 2), and headings (rad)."""

    places: FloatArray
    headings: FloatArray


def whole_floor(site_map: SiteMap) -> Region:
    """Return all places where the robot can stand, and all headings."""
    x_min, y_min, x_max, y_max = site_map.bounds
    x = np.arange(x_min, x_max + PLACE_STEP, PLACE_STEP)
    y = np.arange(y_min, y_max + PLACE_STEP, PLACE_STEP)
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    standing = site_map.plan.at(places) > STANDING
    return Region(places[standing], np.linspace(-math.pi, math.pi, HEADINGS, endpoint=False))


def near(hint: FloorPose) -> Region:
    """Return the poses within 0.6 m and 0.6 rad of a hint."""
    steps = np.arange(-0.6, 0.61, PLACE_STEP)
    places = np.stack(np.meshgrid(hint.x + steps, hint.y + steps), axis=-1).reshape(-1, 2)
    return Region(places, hint.yaw + np.linspace(-0.6, 0.6, 25))


class Search:
    """One search: iterate over ``slices`` to the end, then read ``best`` and ``runner_up``.

    Args:
        site_map: the map.
        points_in_base: what the laser hit, shape (n, 2); of one scan, or of several at rest.
        region: where to look.
    """

    def __init__(self, site_map: SiteMap, points_in_base: FloatArray, region: Region) -> None:
        self._map, self._region = site_map, region
        self._points = points_in_base
        self._fewer = points_in_base[:: max(1, len(points_in_base) // FINE_BEAMS)]
        self._coarse: list[tuple[float, float, float, float]] = []
        self._fine: list[Found] = []

    def slices(self) -> Iterator[float]:
        """Search on; yields the share done after each slice of a few ms at most."""
        reach = float(np.hypot(self._points[:, 0], self._points[:, 1]).max()) + CELL
        scores = _ScoreGrid.around(self._map, reach)
        beams = self._points[:: max(1, len(self._points) // BEAMS)]
        total = len(self._region.headings) + KEPT
        yield 0.0  # the grid is a slice of its own
        for done, heading in enumerate(self._region.headings):
            self._coarse += scores.best_places(self._region.places, beams, float(heading))
            yield done / total
        kept = _apart(self._coarse)
        yield len(self._region.headings) / total
        for done, (_, x, y, yaw) in enumerate(kept):
            self._fine.append(self._refine(FloorPose(x=x, y=y, yaw=wrap(yaw))))
            yield (len(self._region.headings) + done) / total

    @property
    def best(self) -> Found | None:
        """The best pose, or None."""
        return max(self._fine, key=lambda each: each.score, default=None)

    @property
    def runner_up(self) -> Found | None:
        """The best pose that is another one, or None."""
        best = self.best
        others = [each for each in self._fine if best is not None and not _same(each.pose, best.pose)]
        return max(others, key=lambda each: each.score, default=None)

    def _refine(self, start: FloorPose) -> Found:
        found = match(
            self._map.laser,
            self._fewer,
            start,
            diagonal(0.2, 0.2),
            (0.4, 0.4, 0.3, 0.3, 0.2, 0.15, 0.1, 0.08, 0.05, 0.05),
        )
        score = float(np.mean(np.exp(-0.5 * (found.residual / FINE) ** 2)))
        standing = self._map.plan.at_point(found.pose.x, found.pose.y) > STANDING - PLACE_STEP
        score -= self._passing_through(found.pose) if standing else 1.0
        return Found(found.pose, found.fit, score)

    def _passing_through(self, pose: FloorPose) -> float:
        """Return the share of beams that would have gone through something."""
        laser = np.array([[self._map.laser_in_base.x, self._map.laser_in_base.y]])
        start, ends = points_in(pose, laser), points_in(pose, self._fewer[::2])
        shares = np.linspace(0.1, 0.9, 17)[:, None, None]
        along = (start + shares * (ends - start)).reshape(-1, 2)
        deep = self._map.laser.at(along).reshape(len(shares), -1) < -SOLID
        return float(np.mean(deep.any(axis=0)))


@dataclass(frozen=True)
class _ScoreGrid:
    """A beam's score by the flat index of its end's cell; padded so that no beam leaves it."""

    x0: float
    y0: float
    columns: int
    scores: FloatArray

    @classmethod
    def around(cls, site_map: SiteMap, reach: float) -> _ScoreGrid:
        x_min, y_min, x_max, y_max = site_map.bounds
        pad = reach + 0.5
        columns = math.ceil((x_max - x_min + 2 * pad) / CELL)
        rows = math.ceil((y_max - y_min + 2 * pad) / CELL)
        x0, y0 = x_min - pad, y_min - pad
        scores = np.zeros((rows, columns))
        field = site_map.laser
        first = (math.ceil((field.y0 - y0) / CELL), math.ceil((field.x0 - x0) / CELL))
        count = ((field.values.shape[0] - 1) // 2, (field.values.shape[1] - 1) // 2)
        y = y0 + CELL * np.arange(first[0], first[0] + count[0])
        x = x0 + CELL * np.arange(first[1], first[1] + count[1])
        nodes = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
        values = np.exp(-0.5 * (field.at(nodes) / SPREAD) ** 2).reshape(count)
        scores[first[0] : first[0] + count[0], first[1] : first[1] + count[1]] = values
        return cls(x0, y0, columns, scores.reshape(-1))

    def best_places(
        self, places: FloatArray, beams: FloatArray, heading: float
    ) -> list[tuple[float, float, float, float]]:
        """Return the best few (score, x, y, heading) at this heading."""
        offsets = np.rint(points_in(FloorPose(x=0.0, y=0.0, yaw=heading), beams) / CELL).astype(np.int32)
        cells = np.rint((places - (self.x0, self.y0)) / CELL).astype(np.int32)
        flat = (cells[:, 1] * self.columns + cells[:, 0])[:, None]
        score = self.scores.take(flat + (offsets[:, 1] * self.columns + offsets[:, 0])[None, :]).mean(axis=1)
        top = np.argsort(-score, kind="stable")[:TOP]
        return [(float(score[i]), float(places[i, 0]), float(places[i, 1]), heading) for i in top]


def _apart(poses: list[tuple[float, float, float, float]]) -> list[tuple[float, float, float, float]]:
    """Return the best poses that lie apart from all better ones."""
    kept: list[tuple[float, float, float, float]] = []
    for pose in sorted(poses, reverse=True):
        if len(kept) == KEPT:
            break
        if all(
            math.hypot(pose[1] - other[1], pose[2] - other[2]) > DISTINCT[0]
            or abs(wrap(pose[3] - other[3])) > DISTINCT[1]
            for other in kept
        ):
            kept.append(pose)
    return kept


def _same(a: FloorPose, b: FloorPose) -> bool:
    return math.hypot(a.x - b.x, a.y - b.y) < APART[0] and abs(wrap(a.yaw - b.yaw)) < APART[1]
