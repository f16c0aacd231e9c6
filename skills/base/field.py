"""A signed distance field on a grid: how far it is to the next surface, from anywhere on the floor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.base.floor import FloatArray, IntArray


@dataclass(frozen=True)
class DistanceField:
    """Distances (m) at the nodes of a grid; negative inside things. Outside the grid the rim's value holds.

    ``values[row, column]`` belongs to the point ``(x0 + column * step, y0 + row * step)`` in the map.
    """

    x0: float
    y0: float
    step: float
    values: FloatArray

    def cells(self, points: FloatArray) -> IntArray:
        """Return the flat indices, shape (n,), of the nodes next to the points, shape (n, 2)."""
        rows, columns = self.values.shape
        column = np.clip(np.rint((points[:, 0] - self.x0) / self.step), 0, columns - 1)
        row = np.clip(np.rint((points[:, 1] - self.y0) / self.step), 0, rows - 1)
        flat: IntArray = (row * columns + column).astype(np.int64)
        return flat

    def at(self, points: FloatArray) -> FloatArray:
        """Return the distances, shape (n,), at the points, shape (n, 2); bilinear between the nodes."""
        return self.with_gradient(points)[0]

    def at_point(self, x: float, y: float) -> float:
        """Return the distance at one point."""
        return float(self.at(np.array([[x, y]]))[0])

    def with_gradient(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return distances, shape (n,), and their gradients, shape (n, 2), at the points, shape (n, 2)."""
        rows, columns = self.values.shape
        u = np.clip((points[:, 0] - self.x0) / self.step, 0.0, columns - 1.001)
        v = np.clip((points[:, 1] - self.y0) / self.step, 0.0, rows - 1.001)
        column, row = u.astype(np.int64), v.astype(np.int64)
        a, b = u - column, v - row
        flat = self.values.reshape(-1)
        index = row * columns + column
        f00, f10 = flat.take(index), flat.take(index + 1)
        f01, f11 = flat.take(index + columns), flat.take(index + columns + 1)
        low, high = f00 + a * (f10 - f00), f01 + a * (f11 - f01)
        gx = (f10 - f00) + b * ((f11 - f01) - (f10 - f00))
        gradient = np.stack((gx, high - low), axis=1) / self.step
        return low + b * (high - low), gradient
