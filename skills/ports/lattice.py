"""The cells of occupied space as arrays: where each lies, and which one a point lies in."""

from __future__ import annotations

import base64
import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.ports.message import Vector3
from tandem.skills.ports.occupancy import LARGEST, Occupancy, OccupancySetting
from tandem.skills.ports.site import Site

Numbers = NDArray[np.int64]
Matrix = NDArray[np.float64]
TOP: Final = 1.7
"""Metres above the floor up to which space is mapped: higher than the robots are."""
OUTSIDE: Final = -1
"""Stands for the index of a cell where there is none."""
U32: Final = np.dtype("<u4")


@dataclass(frozen=True)
class Lattice:
    """Cubes of ``resolution`` metres from ``origin`` on along the map's axes, ``shape`` of them."""

    origin: Vector3
    shape: tuple[int, int, int]
    resolution: float

    @classmethod
    def over(cls, bounds: tuple[float, float, float, float], height: float, resolution: float) -> Lattice:
        """Return the lattice over a floor.

        Args:
            bounds: x_min, y_min, x_max, y_max (m, in the map).
            height: metres above the floor that it reaches.
            resolution: edge of a cell (m).

        Raises:
            ValueError: when it would have more cells than can be numbered.
        """
        x_min, y_min, x_max, y_max = bounds
        spans = (x_max - x_min, y_max - y_min, height)
        nx, ny, nz = (max(1, math.ceil(span / resolution - 1e-9)) for span in spans)
        if nx * ny * nz > LARGEST:
            raise ValueError(
                f"a resolution of {resolution:g} m makes {nx * ny * nz} cells; expected a larger one"
            )
        return cls((x_min, y_min, 0.0), (nx, ny, nz), resolution)

    @classmethod
    def of_site(cls, site: Site, setting: OccupancySetting) -> Lattice:
        """Return the cells of a site."""
        return cls.over(site.bounds, TOP, setting.resolution)

    @classmethod
    def of(cls, message: Occupancy) -> Lattice:
        """Return the lattice of a message."""
        return cls(message.origin, message.shape, message.resolution)

    @property
    def halved(self) -> Lattice:
        """The same space in cells of half the edge."""
        nx, ny, nz = self.shape
        return Lattice(self.origin, (2 * nx, 2 * ny, 2 * nz), self.resolution / 2.0)

    def numbers(self, points: Matrix) -> Numbers:
        """Return the number of the cell that each point (n, 3), m in the map, lies in; -1 outside."""
        index = np.floor((points - np.array(self.origin)) / self.resolution).astype(np.int64)
        nx, ny, _ = self.shape
        inside = np.all((index >= 0) & (index < np.array(self.shape)), axis=1)
        return np.where(inside, index[:, 0] + nx * (index[:, 1] + ny * index[:, 2]), OUTSIDE)

    def centres(self, numbers: Numbers) -> Matrix:
        """Return the centres of cells, (n, 3) metres in the map."""
        nx, ny, _ = self.shape
        index = np.stack((numbers % nx, numbers // nx % ny, numbers // (nx * ny)), axis=1)
        return np.asarray(np.array(self.origin) + (index + 0.5) * self.resolution, np.float64)


def numbers_of(message: Occupancy) -> Numbers:
    """Return the numbers of the occupied cells, rising."""
    return np.frombuffer(base64.b64decode(message.cells), U32).astype(np.int64)


def centres_of(message: Occupancy) -> Matrix:
    """Return the centres of the occupied cells, (n, 3) metres in the map."""
    return Lattice.of(message).centres(numbers_of(message))


def packed(numbers: Numbers) -> str:
    """Return rising cell numbers as ``Occupancy.cells`` has them."""
    return base64.b64encode(numbers.astype(U32).tobytes()).decode("ascii")
