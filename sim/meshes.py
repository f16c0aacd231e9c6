"""Plain boxes and cylinders as OBJ files with flat faces.

pybullet's own shapes share the normals of their corners in EGL, so that a box is shaded as if it were round.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.things import BoxShape, CylinderShape

if TYPE_CHECKING:
    from pathlib import Path

    from tandem.skills.ports.message import Vector3

SEGMENTS: Final = 32
"""Sides of a prism that stands for a cylinder: it is nowhere off by more than 0.5 % of the radius."""
_BOX_SIDES: Final = (
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
    ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    ((0, 0, -1), (1, 0, 0), (0, -1, 0)),
)
"""Normal, right and up of each side as seen from outside."""

Corner = tuple["Vector3", "Vector3"]
"""A point and the normal there."""


def write_shape(folder: Path, stem: str, shape: BoxShape | CylinderShape) -> Path:
    """Write a shape about its centre and return the OBJ's path.

    Raises:
        OSError: when the folder can't be written to.
    """
    triangles = _box(shape.size) if isinstance(shape, BoxShape) else cylinder(shape.radius, shape.height)
    lines: list[str] = []
    faces: list[str] = []
    for number, triangle in enumerate(triangles):
        for point, normal in triangle:
            lines.append("v " + " ".join(f"{value:.6f}" for value in point))
            lines.append("vn " + " ".join(f"{value:.6f}" for value in normal))
        faces.append("f " + " ".join(f"{3 * number + k}//{3 * number + k}" for k in (1, 2, 3)))
    path = folder / f"{stem}.obj"
    path.write_text("\n".join([*lines, *faces]) + "\n", encoding="ascii")
    return path


def _box(size: Vector3) -> list[tuple[Corner, Corner, Corner]]:
    triangles: list[tuple[Corner, Corner, Corner]] = []
    for normal, right, up in _BOX_SIDES:
        corners: list[Corner] = []
        for r, u in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            point = [size[i] / 2 * (normal[i] + r * right[i] + u * up[i]) for i in range(3)]
            corners.append(((point[0], point[1], point[2]), normal))
        triangles += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return triangles


def cylinder(radius: float, height: float) -> list[tuple[Corner, Corner, Corner]]:
    """Return the triangles of an upright cylinder about its centre, smooth about its side (m)."""
    triangles: list[tuple[Corner, Corner, Corner]] = []
    top, bottom = height / 2, -height / 2
    for segment in range(SEGMENTS):
        a, b = (2 * math.pi * (segment + k) / SEGMENTS for k in (0, 1))
        na, nb = (math.cos(a), math.sin(a), 0.0), (math.cos(b), math.sin(b), 0.0)
        low_a, low_b = (radius * na[0], radius * na[1], bottom), (radius * nb[0], radius * nb[1], bottom)
        high_a, high_b = (low_a[0], low_a[1], top), (low_b[0], low_b[1], top)
        triangles.append(((low_a, na), (low_b, nb), (high_b, nb)))
        triangles.append(((low_a, na), (high_b, nb), (high_a, na)))
        up, down = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
        triangles.append((((0.0, 0.0, top), up), (high_a, up), (high_b, up)))
        triangles.append((((0.0, 0.0, bottom), down), (low_b, down), (low_a, down)))
    return triangles
