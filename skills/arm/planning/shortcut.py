"""Making a path shorter: leave out waypoints, then cut corners, bounded by counts."""

from __future__ import annotations

import itertools
from collections.abc import Generator

import numpy as np

from tandem.skills.arm.planning.motions import Motions
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.kinematics.transforms import Array

CORNER = 0.15
"""Seconds that a waypoint between two segments costs, about: slowing down and speeding up."""


def shorten(
    motions: Motions, path: Array, rng: np.random.Generator, settings: PlannerSettings
) -> Generator[int, None, Array]:
    """Return a path of the same ends that takes less time.

    First waypoints are left out, from the farthest jump down; then two random points of the path are
    joined where that saves time (Geraerts and Overmars, "Creating High-quality Paths for Motion Planning",
    IJRR 26(8), 2007). It ends when nothing has been gained for a while.

    Args:
        motions: what is free.
        path: waypoints (m, n).
        rng: draws the points.
        settings: bounds.

    Yields:
        The checks just done, after each motion.
    """
    counter = motions.checker
    first = counter.checks
    points = list(path)
    points = yield from _skip(motions, points)
    misses = 0
    for _ in range(settings.shortcut_rounds):
        enough = counter.checks - first >= settings.shortcut_checks or misses >= settings.shortcut_misses
        if len(points) <= 2 or enough:  # noqa: PLR2004
            break
        before = counter.checks
        shorter = _cut(motions, points, rng)
        yield counter.checks - before
        misses = misses + 1 if shorter is None else 0
        points = points if shorter is None else shorter
    points = yield from _skip(motions, points)
    return np.array(points)


def cost(motions: Motions, points: list[Array]) -> float:
    """Return about how many seconds the path takes."""
    pairs = itertools.pairwise(points)
    return sum(motions.space.seconds(a, b) for a, b in pairs) + CORNER * (len(points) - 2)


def _skip(motions: Motions, points: list[Array]) -> Generator[int, None, list[Array]]:
    counter = motions.checker
    kept, here = [points[0]], 0
    while here < len(points) - 1:
        there = len(points) - 1
        while there > here + 1:
            before = counter.checks
            joined = motions.free(points[here], points[there])
            yield counter.checks - before
            if joined:
                break
            there -= 1
        kept.append(points[there])
        here = there
    return kept


def _cut(motions: Motions, points: list[Array], rng: np.random.Generator) -> list[Array] | None:
    lengths = np.array([motions.space.length(a, b) for a, b in itertools.pairwise(points)])
    ends = np.concatenate(([0.0], np.cumsum(lengths)))
    low, high = np.sort(rng.uniform(0.0, ends[-1], size=2))
    i = min(int(np.searchsorted(ends, low, side="right")) - 1, len(lengths) - 1)
    j = min(int(np.searchsorted(ends, high, side="right")) - 1, len(lengths) - 1)
    if i == j:
        return None
    a = points[i] + (points[i + 1] - points[i]) * (low - ends[i]) / lengths[i]
    b = points[j] + (points[j + 1] - points[j]) * (high - ends[j]) / lengths[j]
    shorter = [*points[: i + 1], a, b, *points[j + 1 :]]
    if cost(motions, shorter) >= cost(motions, points) - 1e-3 or not motions.free(a, b):
        return None
    return shorter
