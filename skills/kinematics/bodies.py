"""Bodies that are not links: what stands around the robot, and what it holds."""

from __future__ import annotations

from dataclasses import dataclass

import coal
import numpy as np

from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import BoxShape, CylinderShape

__all__ = ["BoxShape", "Carried", "CellsShape", "CylinderShape", "Obstacle", "Shape", "geometry"]


@dataclass(frozen=True)
class CellsShape:
    """Cubes of ``resolution`` metres, as an octree has them. Made by ``of``.

    Its frame lies in a corner of cells, near the middle; ``size`` is a box about that which holds all cells
    (m). ``packed``: the cells' centres in that frame, as bytes, so that two can be compared.
    """

    packed: bytes
    resolution: float
    size: tuple[float, float, float]

    @classmethod
    def of(cls, centres: Array, resolution: float) -> tuple[CellsShape, Vector3]:
        """Return the shape of at least one cell, and where its frame is.

        Args:
            centres: (n, 3) metres, on one lattice.
            resolution: edge of a cell (m).
        """
        corner = centres[0] + resolution / 2.0
        middle = (centres.min(axis=0) + centres.max(axis=0)) / 2.0
        frame = corner + resolution * np.rint((middle - corner) / resolution)
        inside = np.ascontiguousarray(centres - frame, np.float64)
        x, y, z = (float(each) for each in 2.0 * np.abs(inside).max(axis=0) + resolution)
        return cls(inside.tobytes(), resolution, (x, y, z)), (
            float(frame[0]),
            float(frame[1]),
            float(frame[2]),
        )

    @property
    def centres(self) -> Array:
        """The cells' centres in the shape's frame, (n, 3) metres: odd multiples of half a cell."""
        return np.frombuffer(self.packed, np.float64).reshape(-1, 3)


Shape = BoxShape | CylinderShape | CellsShape


@dataclass(frozen=True)
class Obstacle:
    """Something to keep away from.

    It is made larger on each side by ``padding`` metres: along its x and y, and along its z.
    """

    name: str
    shape: Shape
    pose_in_base: Pose
    padding: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Carried:
    """Something that moves with a link; the ``touch`` links may be in contact with it."""

    name: str
    shape: Shape
    link: str
    pose_in_link: Pose
    touch: tuple[str, ...]


def geometry(shape: Shape, padding: tuple[float, float] = (0.0, 0.0)) -> coal.CollisionGeometry:
    """Return coal's shape."""
    around, along = padding
    made: coal.CollisionGeometry
    if isinstance(shape, BoxShape):
        x, y, z = shape.size
        made = coal.Box(x + 2.0 * around, y + 2.0 * around, z + 2.0 * along)
    elif isinstance(shape, CellsShape):
        made = coal.makeOctree(shape.centres, shape.resolution)  # whose cells begin at multiples of that
    else:
        made = coal.Cylinder(shape.radius + around, shape.length + 2.0 * along)
    made.computeLocalAABB()
    return made
