"""Smooth curves in joint space: splines through many points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.kinematics.transforms import Array

GRID = 240
"""Points on a curve's grid."""


@dataclass(frozen=True)
class Curve:
    """A curve over (nearly) its length.

    Attributes:
        s: length so far (m,), radians (Euclidean over the joints), even steps from 0.
        points: joint positions (m, n).
        slope: dq/ds (m, n).
        bend: d2q/ds2 (m, n).
    """

    s: Array
    points: Array
    slope: Array
    bend: Array

    def at(self, s: Array) -> Array:
        """Return the positions (k, n) at the lengths (k,): cubic between the grid's points."""
        step = self.s[1] - self.s[0]
        k = np.clip((s / step).astype(int), 0, len(self.s) - 2)
        u = ((s - self.s[k]) / step)[:, None]
        a, b, va, vb = self.points[k], self.points[k + 1], self.slope[k] * step, self.slope[k + 1] * step
        return np.asarray(
            (2 * u**3 - 3 * u**2 + 1) * a + (u**3 - 2 * u**2 + u) * va
            + (3 * u**2 - 2 * u**3) * b + (u**3 - u**2) * vb
        )  # fmt: skip

    def slope_at(self, s: Array) -> Array:
        """Return dq/ds (k, n) at the lengths (k,)."""
        return np.stack([np.interp(s, self.s, column) for column in self.slope.T], axis=1)

    def bend_at(self, s: Array) -> Array:
        """Return d2q/ds2 (k, n) at the lengths (k,)."""
        return np.stack([np.interp(s, self.s, column) for column in self.bend.T], axis=1)


def through(points: Array) -> Curve:
    """Return a natural cubic spline through the points (m, n), over the length of their polyline."""
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    kept = np.concatenate(([True], lengths > 1e-6))  # noqa: PLR2004
    points = points[kept]
    knots = np.concatenate(([0.0], np.cumsum(lengths[kept[1:]])))
    if len(points) == 1:
        rest = np.zeros((2, points.shape[1]))
        return Curve(np.zeros(2), np.repeat(points, 2, axis=0), rest, rest)
    second = _natural(knots, points)
    s = np.linspace(0.0, knots[-1], GRID)
    k = np.clip(np.searchsorted(knots, s, side="right") - 1, 0, len(knots) - 2)
    h = (knots[k + 1] - knots[k])[:, None]
    a, b = (knots[k + 1] - s)[:, None] / h, (s - knots[k])[:, None] / h
    at = a * points[k] + b * points[k + 1]
    at += ((a**3 - a) * second[k] + (b**3 - b) * second[k + 1]) * h**2 / 6.0
    slope = (points[k + 1] - points[k]) / h
    slope += ((3 * b**2 - 1) * second[k + 1] - (3 * a**2 - 1) * second[k]) * h / 6.0
    return Curve(s, at, slope, a * second[k] + b * second[k + 1])


def _natural(knots: Array, points: Array) -> Array:
    """Return the second derivatives (m, n) of the natural spline (de Boor 1978, IV)."""
    count = len(knots)
    h = np.diff(knots)
    system = np.eye(count)
    right = np.zeros_like(points)
    for i in range(1, count - 1):
        system[i, i - 1 : i + 2] = (h[i - 1], 2.0 * (h[i - 1] + h[i]), h[i])
        right[i] = 6.0 * (
            (points[i + 1] - points[i]) / h[i] - (points[i] - points[i - 1]) / h[i - 1]
        )  # fmt: skip
    return np.asarray(np.linalg.solve(system, right))
