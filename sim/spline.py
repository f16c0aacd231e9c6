"""Piecewise cubic Hermite paths through points with given velocities."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Spline:
    """A path q(t) through points (time, positions, velocities), C1, at rest before and after (Hermite basis).

    Args:
        times: seconds, rising.
        positions: (points, joints).
        velocities: (points, joints).
    """

    def __init__(
        self,
        times: Sequence[float],
        positions: Sequence[Sequence[float]],
        velocities: Sequence[Sequence[float]],
    ) -> None:
        self._times = np.array(times, dtype=np.float64)
        self._positions = np.array(positions, dtype=np.float64)
        self._velocities = np.array(velocities, dtype=np.float64)

    @property
    def duration(self) -> float:
        """Time of the last point."""
        return float(self._times[-1])

    def _segment(self, time: float) -> tuple[int, float, float]:
        """Return the segment's index, its length, and how much of it has passed (0 to 1)."""
        last = len(self._times) - 2
        index = min(max(int(np.searchsorted(self._times, time, side="right")) - 1, 0), last)
        length = float(self._times[index + 1] - self._times[index])
        return index, length, (time - float(self._times[index])) / length

    def position(self, time: float) -> Array:
        """Return q(t); the ends are held."""
        if len(self._times) == 1 or time >= self.duration:
            return np.array(self._positions[-1])
        if time <= self._times[0]:
            return np.array(self._positions[0])
        i, h, u = self._segment(time)
        (q0, q1), (v0, v1) = self._positions[i : i + 2], self._velocities[i : i + 2]
        left = (1 + 2 * u) * (1 - u) ** 2 * q0 + u * (1 - u) ** 2 * h * v0
        right = u**2 * (3 - 2 * u) * q1 + u**2 * (u - 1) * h * v1
        result: Array = left + right
        return result

    def velocity(self, time: float) -> Array:
        """Return dq/dt; zero outside the path."""
        if len(self._times) == 1 or time >= self.duration or time < self._times[0]:
            return np.zeros(self._positions.shape[1])
        i, h, u = self._segment(time)
        (q0, q1), (v0, v1) = self._positions[i : i + 2], self._velocities[i : i + 2]
        bend = 6 * u * (1 - u) / h * (q1 - q0)
        ends = (1 - u) * (1 - 3 * u) * v0 + u * (3 * u - 2) * v1
        result: Array = bend + ends
        return result
