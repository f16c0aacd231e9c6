"""Where an item is: from the tag on one of its faces to the frame in its centre, and back.

The item's frame has its origin in the centre, z up at rest, x out of the tagged face. An item carries its
tag on all four sides, as a shipping label does, so the frame is known up to quarter turns about z. A cylinder
has its four tags on flat labels that touch its side, so that its frame and the frame of the box about it are
one.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.geometry.poses import (
    about,
    add,
    angle_between,
    compose,
    from_axes,
    multiply,
    rotate,
    scale,
    subtract,
)
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import Shaped, is_round, solid

TAG_TURN: Final = from_axes((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
"""The tag on the face along the item's x: x_tag = y_item, y_tag = z_item, z_tag = x_item."""
UPRIGHT: Final = 0.6
"""Cosine of the angle between a tag's up and the map's, to which a tag may be stuck on askew."""
CUBE: Final = 0.001
"""Metres by which the edges of a cube may differ."""

_Y: Final[Vector3] = (0.0, 1.0, 0.0)
_Z: Final[Vector3] = (0.0, 0.0, 1.0)


def outward(tag_in_map: Pose) -> Vector3:
    """Return the level unit vector out of the tag's face (its z in plan).

    Raises:
        ValueError: for a tag that lies flat: it has no level direction.
    """
    x, y, _ = rotate(tag_in_map.orientation, _Z)
    size = math.hypot(x, y)
    if size < 0.5:  # noqa: PLR2004
        raise ValueError("expected the tag on an upright face; this one lies flat")
    return (x / size, y / size, 0.0)


def item_in_map(tag_in_map: Pose, depth: float) -> Pose:
    """Return the item's centre frame: upright, x out of the tagged face; ``depth`` (m) is along x."""
    out = outward(tag_in_map)
    centre = add(tag_in_map.position, scale(rotate(tag_in_map.orientation, _Z), -depth / 2.0))
    return Pose(position=centre, orientation=about(_Z, math.atan2(out[1], out[0])))


def upright_in_map(tag_in_map: Pose, depth: float) -> Pose | None:
    """Return ``item_in_map``, or None for an item that has fallen over: its tag lies flat, or on its side."""
    if rotate(tag_in_map.orientation, _Y)[2] < UPRIGHT:
        return None
    return item_in_map(tag_in_map, depth)


def standing_in_map(tag_in_map: Pose, thing: Shaped) -> Pose | None:
    """Return the item's centre frame, its z up, or None for an item that has fallen over.

    A cube stands on whichever face it lies: x is out of one of its sides then. A cylinder never does.
    """
    size = thing.size
    stands = upright_in_map(tag_in_map, size[0])
    if stands is not None or max(size) - min(size) > CUBE or is_round(solid(thing)):
        return stands
    try:
        return item_in_map(tag_in_map, size[0])
    except ValueError:  # the tag is on top, or below
        x, y, _ = rotate(tag_in_map.orientation, (1.0, 0.0, 0.0))
        middle = add(tag_in_map.position, scale(rotate(tag_in_map.orientation, _Z), -size[0] / 2.0))
        return Pose(position=middle, orientation=about(_Z, math.atan2(y, x)))


def tag_of_item(item: Pose, depth: float) -> Pose:
    """Return the tag on the face along an item's x, in the frame that the item's centre is told in.

    ``depth``: the item's edge along x (m).
    """
    return compose(item, Pose(position=(depth / 2.0, 0.0, 0.0), orientation=TAG_TURN))


def turned_like(frame: Pose, known: Pose) -> Pose:
    """Return an item's frame, turned by quarters about its vertical until it is nearest to a known one.

    An item carries its tag on all four sides, and the side that was seen last gives its frame: it turns by
    quarters though the item stands still, and a grasp that was told in it would turn along.
    """
    turns = [
        Pose(
            position=frame.position,
            orientation=multiply(frame.orientation, about(_Z, k * math.pi / 2.0)),
        )
        for k in range(4)
    ]
    return min(turns, key=lambda each: round(angle_between(each.orientation, known.orientation), 6))


def face(tag_in_map: Pose, depth: float, quarter_turns: int) -> Pose:
    """Return the tag on another upright face of a square item: turned about the item's own vertical.

    An item carries its tag on all four sides, as a shipping label does. ``depth``: metres through the item.
    """
    return turned_about(tag_in_map, depth, quarter_turns * math.pi / 2.0)


def turned_about(tag_in_map: Pose, depth: float, angle: float) -> Pose:
    """Return the tag where it would be, were the item turned about its vertical by an angle (rad).

    Of a cylinder that is a tag on another side, be there one or not. ``depth``: metres through the item.
    """
    item = item_in_map(tag_in_map, depth)
    turn = about(_Z, angle)
    arm = rotate(turn, subtract(tag_in_map.position, item.position))
    return Pose(position=add(item.position, arm), orientation=multiply(turn, tag_in_map.orientation))


def face_towards(tag_in_map: Pose, depth: float, heading: float) -> Pose:
    """Return the tag on that face of a square item that looks most in the direction of ``heading`` (rad)."""
    out = outward(tag_in_map)
    away = math.remainder(heading - math.atan2(out[1], out[0]), 2.0 * math.pi)
    return face(tag_in_map, depth, round(away / (math.pi / 2.0)))
