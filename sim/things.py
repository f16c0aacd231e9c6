"""Things in the room, as scenarios and faults tell of them: items, and what nobody has a name for."""

from __future__ import annotations

import math
from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from tandem.skills.ports import shapes
from tandem.skills.ports.item_number import ITEM_OR_TAG, NamedItem
from tandem.skills.ports.message import Message
from tandem.skills.ports.shapes import Solid

FLOOR: Final = "floor"
"""The support of what stands on the ground; every other support is a piece of furniture of the site."""

Name = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$", max_length=40)]
Angle = Annotated[float, Field(ge=-2 * math.pi, le=2 * math.pi)]
Coordinate = Annotated[float, Field(ge=-50.0, le=50.0)]
Length = Annotated[float, Field(gt=0.0, le=20.0)]
Friction = Annotated[float, Field(gt=0.0, le=1.0)]
Colour = tuple[float, float, float]


class TrueItem(Message):
    """Where an item really stands at the start of the run; the site file gives its shape and looks."""

    item: NamedItem = Field(validation_alias=ITEM_OR_TAG)
    """Its number, whether it bears a tag or not. A file may say its name; ``tag`` is read, too."""
    support: Name
    """The furniture on whose top it stands, or ``floor``."""
    x: Coordinate
    y: Coordinate
    yaw: Angle = 0.0
    mass: float = Field(default=0.1, ge=0.05, le=5.0)
    friction: Friction = 0.9
    stiffness: float | None = Field(default=None, ge=500.0, le=1e6)
    """Stiffness of its walls in N/m per contact point, for soft material like cardboard; default: rigid."""


class BoxShape(Message):
    """A cuboid: edges in metres along its own x, y, z."""

    kind: Literal["box"] = "box"
    size: tuple[Length, Length, Length]

    @property
    def solid(self) -> Solid:
        """The shape that skills reckon with."""
        return shapes.BoxShape(self.size)


class CylinderShape(Message):
    """An upright cylinder, in metres."""

    kind: Literal["cylinder"] = "cylinder"
    radius: Length
    height: Length

    @property
    def solid(self) -> Solid:
        """The shape that skills reckon with."""
        return shapes.CylinderShape(self.radius, self.height)


def shape_of(solid: Solid) -> BoxShape | CylinderShape:
    """Return the shape of a body in the room."""
    if isinstance(solid, shapes.CylinderShape):
        return CylinderShape(radius=solid.radius, height=solid.length)
    return BoxShape(size=solid.size)


Shape = Annotated[BoxShape | CylinderShape, Field(discriminator="kind")]


class Drop(Message):
    """A part of the floor that lies lower, such as a step down or an open hatch: no site file has it.

    ``lower`` and ``upper`` are opposite corners in map (m). Cameras don't see it: the floor is drawn whole.
    """

    lower: tuple[Coordinate, Coordinate]
    upper: tuple[Coordinate, Coordinate]
    depth: Annotated[float, Field(ge=0.02, le=2.0)] = 0.15
    """Metres."""

    @model_validator(mode="after")
    def _ordered(self) -> Drop:
        if self.lower[0] >= self.upper[0] or self.lower[1] >= self.upper[1]:
            raise ValueError("each coordinate of lower must be below that of upper")
        return self

    def has(self, x: float, y: float) -> bool:
        """Say whether a place in map (m) is in it."""
        return self.lower[0] < x < self.upper[0] and self.lower[1] < y < self.upper[1]


class Obstacle(Message):
    """An object that is no item and not in the site file: clutter on a table, or something on the floor."""

    name: Name
    shape: Shape
    support: Name = FLOOR
    x: Coordinate
    y: Coordinate
    yaw: Angle = 0.0
    mass: float = Field(default=0.3, ge=0.0, le=50.0)
    """In kg; 0 means that it can't be pushed."""
    friction: Friction = 0.6
    colour: Colour = (0.55, 0.47, 0.38)
