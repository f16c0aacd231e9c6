"""What in a scan could be a person: legs, pairs of legs, bodies, out of the hits that no map explains."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray, IntArray
from tandem.skills.base.localiser import PlacedScan

FARTHEST: Final = 6.0
"""Metres: farther away a leg is hit by one beam of 0.9 degrees at the most."""
GAP: Final = 0.12
"""Metres between neighbouring hits from which on they are of two things, or twice the beams' spacing."""
LEG: Final = 0.22
"""Metres: what is wider is no leg."""
BODY: Final = 0.60
"""Metres: what is wider is no person. Two legs side by side are up to 0.35 m wide."""
LONELY: Final = 2.5
"""Metres from which on a single hit counts: nearer, a leg is hit by three beams or more."""
APART: Final = 0.50
"""Metres between the legs of one person at the most, in full stride."""
DEEPER: Final = 0.04
"""Metres behind the hits at which a leg's middle lies: hits are on its near side."""
DEEPER_SHARE: Final = 0.35
"""Share of a body's width, likewise."""


@dataclass(frozen=True)
class Candidate:
    """Something as wide as a person: its middle in map (m), and how well that is known (m)."""

    x: float
    y: float
    sigma: float
    paired: bool
    """Whether it is two legs, or a body; a single leg swings to and fro."""
    parts: tuple[tuple[float, float], ...]
    """The middles of what it is made of (m, in map)."""


@dataclass(frozen=True)
class _Segment:
    x: float
    y: float
    width: float

    @property
    def middle(self) -> tuple[float, float]:
        return self.x, self.y


def candidates(
    placed: PlacedScan, bounds: tuple[float, float, float, float], still: Callable[[float, float], bool]
) -> tuple[Candidate, ...]:
    """Return what could be a person. ``still`` says where something has stood for a while.

    What stands makes no pair with what does not: somebody who walks past a chair is not half of it.
    """
    legs: list[_Segment] = []
    standing: list[_Segment] = []
    bodies: list[Candidate] = []
    for segment in _segments(placed, bounds):
        if segment.width <= LEG:
            (standing if still(*segment.middle) else legs).append(segment)
        elif segment.width <= BODY:
            bodies.append(Candidate(segment.x, segment.y, 0.08, paired=True, parts=(segment.middle,)))
    return (*bodies, *_paired(legs), *_paired(standing))


def _paired(legs: Sequence[_Segment]) -> list[Candidate]:
    """Put legs together, the nearest to each other first."""
    distances = sorted(
        (math.dist(a.middle, b.middle), i, j) for i, a in enumerate(legs) for j, b in enumerate(legs[:i])
    )
    taken: set[int] = set()
    found: list[Candidate] = []
    for distance, i, j in distances:
        if distance > APART or taken & {i, j}:
            continue
        taken |= {i, j}
        a, b = legs[i], legs[j]
        middle = ((a.x + b.x) / 2, (a.y + b.y) / 2)
        found.append(Candidate(*middle, 0.05, paired=True, parts=(a.middle, b.middle)))
    single = [leg for i, leg in enumerate(legs) if i not in taken]
    return [*found, *(Candidate(*leg.middle, 0.12, paired=False, parts=(leg.middle,)) for leg in single)]


def _segments(placed: PlacedScan, bounds: tuple[float, float, float, float]) -> list[_Segment]:
    points, ranges = placed.points_in_map, placed.points.ranges
    beams = np.flatnonzero(~np.isnan(placed.points.all_ranges))
    index = np.flatnonzero(placed.unmapped(bounds, FARTHEST))
    if not len(index):
        return []
    laser = np.array([placed.base_in_map.x, placed.base_in_map.y])
    return [
        made
        for group in _groups(index, beams, points, ranges)
        if (made := _segment(points[group], ranges[group], laser)) is not None
    ]


def _groups(index: IntArray, beams: IntArray, points: FloatArray, ranges: FloatArray) -> list[IntArray]:
    """Cut the strange hits where the next one is on something else; the last beam is next to the first."""
    step = 2 * math.pi / max(len(beams), 1)
    following = np.roll(index, -1)
    jump = np.hypot(*(points[following] - points[index]).T)
    far = jump > np.maximum(GAP, 2.0 * step * ranges[index])
    skipped = beams[following] - beams[index] > 2  # noqa: PLR2004 - one beam may miss
    cuts = np.flatnonzero(far | skipped)
    if not len(cuts):
        return [index]
    rolled = np.roll(index, -(int(cuts[-1]) + 1))
    ends = np.cumsum(np.diff(np.concatenate(([cuts[-1] - len(index)], cuts))))
    return [np.asarray(part, dtype=np.int64) for part in np.split(rolled, ends[:-1])]


def _segment(points: FloatArray, ranges: FloatArray, laser: FloatArray) -> _Segment | None:
    if len(points) == 1 and float(ranges[0]) < LONELY:
        return None
    width = float(np.hypot(*(points[-1] - points[0])))
    middle = points.mean(axis=0)
    away = middle - laser
    deeper = DEEPER if width <= LEG else DEEPER_SHARE * width
    x, y = middle + away / max(float(np.hypot(*away)), 1e-6) * deeper
    return _Segment(float(x), float(y), width)
