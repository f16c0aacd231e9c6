"""Pull bands tight: Gauss-Newton steps with damping (Levenberg-Marquardt), all bands at once.

Why not casadi and ipopt: docs/decisions/013-elastic-band.md.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.base.band.limits import Task
from tandem.skills.base.band.terms import terms
from tandem.skills.base.band.timed import Bands
from tandem.skills.base.floor import BoolArray, FloatArray

SHORTEST: Final = 0.03
"""Seconds between two poses at least."""
LONGEST: Final = 1.0
"""Seconds between two poses at the most."""
DAMPING: Final = (0.2, 1e-5, 1e4)
"""To begin with, at least and at the most."""
EASES: Final = 0.3
HARDENS: Final = 6.0
"""Factors on the damping after a step that gains and one that does not."""
STEP: Final = 0.25
"""Metres, radians or seconds by which a step changes anything, at the most."""


def optimise(bands: Bands, task: Task, steps: int) -> Generator[None, None, tuple[Bands, FloatArray]]:
    """Return the bands after so many steps, and the sum of squares of each, shape (k,); no worse than before.

    Yields after each step.
    """
    k, n = bands.times.shape
    free = _free(n)
    values, slopes = terms(bands, task)
    cost, damping = _cost(values), np.full(k, DAMPING[0])
    for _ in range(steps):
        step = _step(values, slopes[..., free], damping)
        moved = _moved(bands, step, free)
        new_values, new_slopes = terms(moved, task)
        new_cost = _cost(new_values)
        gains = new_cost < cost
        bands = Bands(
            np.where(gains[:, None, None], moved.poses, bands.poses),
            np.where(gains[:, None], moved.times, bands.times),
        )
        values = np.where(gains[:, None], new_values, values)
        slopes = np.where(gains[:, None, None], new_slopes, slopes)
        cost = np.where(gains, new_cost, cost)
        damping = np.clip(damping * np.where(gains, EASES, HARDENS), DAMPING[1], DAMPING[2])
        yield
    return bands, cost


def _free(n: int) -> BoolArray:
    """Say which of x, y, heading and time of the poses may change: neither the start nor the end's place."""
    free = np.ones((4, n + 1), dtype=np.bool_)
    free[:3, 0] = free[:2, n] = free[3, n] = False
    return free.reshape(-1)


def _cost(values: FloatArray) -> FloatArray:
    cost = (values**2).sum(axis=1)
    return np.asarray(np.where(np.isfinite(cost), cost, np.inf))


def _step(values: FloatArray, slopes: FloatArray, damping: FloatArray) -> FloatArray:
    turned = slopes.transpose(0, 2, 1)
    square = turned @ slopes
    diagonal = np.arange(square.shape[1])
    square[:, diagonal, diagonal] += damping[:, None] * (1.0 + square[:, diagonal, diagonal])
    try:
        step = np.linalg.solve(square, -(turned @ values[..., None]))[..., 0]
    except np.linalg.LinAlgError:  # nothing that can be computed with: no step
        return np.zeros(square.shape[:2])
    return np.asarray(np.clip(np.nan_to_num(step, nan=0.0, posinf=0.0, neginf=0.0), -STEP, STEP))


def _moved(bands: Bands, step: FloatArray, free: BoolArray) -> Bands:
    k, n = bands.times.shape
    whole = np.zeros((k, free.size))
    whole[:, free] = step
    by = whole.reshape(k, 4, n + 1)
    return Bands(
        bands.poses + by[:, :3].transpose(0, 2, 1),
        np.clip(bands.times + by[:, 3, :n], SHORTEST, LONGEST),
    )
