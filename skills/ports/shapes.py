"""What a thing's shape comes to: the one place that tells a box from a cylinder.

On the wire and in files a thing has ``size``, the edges of the upright box about it, and ``shape``, what of
that box it fills. Whoever knows only ``size`` reckons with the box, which holds the thing. Both stand upright
with their z along the vertical and their origin in the centre. docs/decisions/017-shapes-of-items.md
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, Literal, Protocol

from tandem.skills.ports.message import Vector3

ShapeName = Literal["box", "cylinder"]

QUARTER: Final = math.pi / 2.0
"""Radians: from one side of a box to the next."""
RING: Final = 12
"""Directions in which a hand may go for a cylinder. No heading is farther than 15 degrees from one of them,
the step between two stands (``tag_grasps.STAND_ANGLES``): finer ones would be tried from the next stand. A
multiple of four, so that each quarter has as many."""
ROUND: Final = 1e-6
"""Metres by which the two level edges of the box about a cylinder may differ: digits of a file."""


@dataclass(frozen=True)
class BoxShape:
    """A box; metres along its x, y and z, its frame in the centre."""

    size: tuple[float, float, float]


@dataclass(frozen=True)
class CylinderShape:
    """A cylinder about z; metres, its frame in the centre."""

    radius: float
    length: float


Solid = BoxShape | CylinderShape


class Shaped(Protocol):
    """What a shape can be told of: a message or an entry of a file."""

    @property
    def size(self) -> Vector3:
        """Edges of the upright box about it (m)."""

    @property
    def shape(self) -> ShapeName:
        """What of the box it fills."""


def _cylinder(size: Vector3) -> CylinderShape:
    return CylinderShape(size[0] / 2.0, size[2])


_MADE: Final[Mapping[ShapeName, Callable[[Vector3], Solid]]] = {"box": BoxShape, "cylinder": _cylinder}


def solid(thing: Shaped) -> Solid:
    """Return the shape of a thing."""
    return _MADE[thing.shape](thing.size)


def extents(shape: Solid) -> Vector3:
    """Return the edges (m) of the upright box about a shape, along its x, y and z."""
    if isinstance(shape, CylinderShape):
        return (2.0 * shape.radius, 2.0 * shape.radius, shape.length)
    return shape.size


def name_of(shape: Solid) -> ShapeName:
    """Return what messages call a shape."""
    return "cylinder" if isinstance(shape, CylinderShape) else "box"


def is_round(shape: Solid) -> bool:
    """Say whether a shape is the same however it is turned about its vertical."""
    return isinstance(shape, CylinderShape)


def sides(shape: Solid) -> tuple[float, ...]:
    """Return the headings (rad, in the shape's frame) out of it against which a hand may come, from its x on.

    A box has four faces. A cylinder is taken from any side, for which a ring of ``RING`` directions stands.
    """
    number = RING if isinstance(shape, CylinderShape) else 4
    return tuple(index * 2.0 * math.pi / number for index in range(number))


def within_quarter(shape: Solid) -> tuple[float, ...]:
    """Return the ``sides`` that lie nearer to x than to another quarter, as turns from it, the least first.

    Those about the four quarters together are all ``sides``. A box has one in each: the face itself.
    """
    turns = (math.remainder(side, 2.0 * math.pi) for side in sides(shape))
    return tuple(sorted((turn for turn in turns if abs(turn) < QUARTER / 2.0), key=abs))


def seen_from(shape: Solid, side: float) -> Vector3:
    """Return the edges (m) of a shape as a hand meets it: along its heading, across it, and up.

    ``side``: one of ``sides`` (rad).
    """
    x, y, z = extents(shape)
    return (x, y, z) if round(side / QUARTER) % 2 == 0 else (y, x, z)
