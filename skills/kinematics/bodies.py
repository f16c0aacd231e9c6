"""Bodies that are not links: what stands around the robot, and what it holds."""

from __future__ import annotations

from dataclasses import dataclass

import coal

from tandem.skills.ports.pose import Pose


@dataclass(frozen=True)
class BoxShape:
    """A box; metres along its x, y and z, its frame in the centre."""

    size: tuple[float, float, float]


@dataclass(frozen=True)
class CylinderShape:
    """A cylinder about z; metres, its frame in the centre."""

    radius: float
    length: float


Shape = BoxShape | CylinderShape


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
    else:
        made = coal.Cylinder(shape.radius + around, shape.length + 2.0 * along)
    made.computeLocalAABB()
    return made
