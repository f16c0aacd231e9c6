"""All the arithmetic of a pick and a place, on one tag pose, in the field's own frames.

The method is the order-picking paper's (III-D): the pre-grasp lies 10 cm along the tag's z (eq. 1), the grasp
at the item, the retraction 10 cm away and 10 cm up (eq. 2), after placing 10 cm back (eq. 3). Its words put
"away" on the tag's x, its equation 2 on other axes; here it is the tag's z, out of the face, because that
draws the item away from where it stood, and "up" is the map's z, because a tag may be stuck on askew.

The tool frame has x out of the hand and y along the closing. The hand is pitched down by an angle of
choice, so that it clears what the item stands on; the fingers close along the tag's x, which is level.

See docs/conventions.md and docs/decisions/004-any-face-hand-inwards.md.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.ports.geometry import (
    FloorPose,
    Pose,
    about,
    add,
    angle_between,
    compose,
    from_axes,
    invert,
    multiply,
    rotate,
    scale,
    subtract,
)
from tandem.skills.ports.message import Message, Quaternion, Vector3

TAG_TURN: Final = from_axes((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
"""The tag on the face along the item's x: x_tag = y_item, y_tag = z_item, z_tag = x_item."""
APPROACH: Final = 0.10
"""Metres between pre-grasp and grasp, eq. 1."""
AWAY: Final = 0.10
"""Metres of retraction along the tag's z, eq. 2 and 3."""
UP: Final = 0.10
"""Metres of retraction upwards, eq. 2."""
PITCHES: Final = tuple(math.radians(angle) for angle in (45.0, 30.0, 60.0, 15.0, 75.0))
"""Downward pitches of the hand, in the order in which they are tried."""

STAND_ANGLES: Final = tuple(math.radians(angle) for angle in (0, 15, -15, 30, -30, 45, -45, 60, -60))
"""By which the base is turned about the target, in the order of preference."""
STAND_DISTANCES: Final = (0.0, 0.06, -0.06, 0.12)
"""Metres by which the base stands farther off, in the order of preference."""

FINGER_ROOM: Final = 0.008
"""Metres on each side between an item and a finger before it closes."""

UPRIGHT: Final = 0.6
"""Cosine of the angle between a tag's up and the map's, to which a tag may be stuck on askew."""
CUBE: Final = 0.001
"""Metres by which the edges of a cube may differ."""

_Y: Final[Vector3] = (0.0, 1.0, 0.0)
_Z: Final[Vector3] = (0.0, 0.0, 1.0)


class Grasp(Message):
    """The poses of the tool frame in the map for one pick, and the item in the tool once grasped."""

    pitch: float
    pre_grasp: Pose
    grasp: Pose
    retraction: Pose
    item_in_tool: Pose


class Place(Message):
    """The poses of the tool frame in the map for one placing: above, down, and back."""

    above: Pose
    place: Pose
    retraction: Pose
    item_in_map: Pose


def outward(tag_in_map: Pose) -> Vector3:
    """Return the level unit vector out of the tag's face (its z in plan).

    Raises:
        ValueError: for a tag that lies flat: it has no level direction.
    """
    x, y, _ = rotate(tag_in_map.orientation, _Z)
    size = math.hypot(x, y)
    if size < 0.5:  # noqa: PLR2004
        raise ValueError("the tag was expected on an upright face; this one lies flat")
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


def standing_in_map(tag_in_map: Pose, size: Vector3) -> Pose | None:
    """Return the item's centre frame, its z up, or None for an item that has fallen over.

    A cube stands on whichever face it lies: x is out of one of its sides then. ``size``: along x, y, z (m).
    """
    stands = upright_in_map(tag_in_map, size[0])
    if stands is not None or max(size) - min(size) > CUBE:
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
    item = item_in_map(tag_in_map, depth)
    turn = about(_Z, quarter_turns * math.pi / 2.0)
    arm = rotate(turn, subtract(tag_in_map.position, item.position))
    return Pose(position=add(item.position, arm), orientation=multiply(turn, tag_in_map.orientation))


def face_towards(tag_in_map: Pose, depth: float, heading: float) -> Pose:
    """Return the tag on that face of a square item that looks most in the direction of ``heading`` (rad)."""
    out = outward(tag_in_map)
    away = math.remainder(heading - math.atan2(out[1], out[0]), 2.0 * math.pi)
    return face(tag_in_map, depth, round(away / (math.pi / 2.0)))


def tool_orientation(out: Vector3, pitch: float) -> Quaternion:
    """Return the tool's orientation in the map: approaching against ``out``, pitched down by ``pitch``.

    ``out`` is level and of unit length. The tool's y stays level, so that the fingers close sideways.
    """
    ahead = scale(out, -1.0)
    x = (ahead[0] * math.cos(pitch), ahead[1] * math.cos(pitch), -math.sin(pitch))
    y = (-ahead[1], ahead[0], 0.0)
    z = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return from_axes(x, y, z)


def grasp(tag_in_map: Pose, depth: float, pitch: float) -> Grasp:
    """Return the poses of a pick (eq. 1 and 2).

    Args:
        tag_in_map: the tag on one upright face of the item.
        depth: metres of the item along the tag's z; the grasp goes to its centre.
        pitch: radians by which the hand looks down.
    """
    out = outward(tag_in_map)
    item = item_in_map(tag_in_map, depth)
    at_item = Pose(position=item.position, orientation=tool_orientation(out, pitch))
    back = scale(out, APPROACH + depth / 2.0)
    away = add(scale(out, AWAY), scale(_Z, UP))
    return Grasp(
        pitch=pitch,
        pre_grasp=_moved(at_item, back),
        grasp=at_item,
        retraction=_moved(at_item, away),
        item_in_tool=compose(invert(at_item), item),
    )


def place(
    slot: Vector3, facing: float, item_in_tool: Pose, height: float, *, clearance: float = 0.004
) -> Place:
    """Return the poses of placing what is in the hand, as it is held (eq. 3).

    Args:
        slot: the point of the surface, in the map.
        facing: heading (rad) from the slot towards the robot: "away".
        item_in_tool: how the item is held; it was upright when grasped, and is put down upright.
        height: metres of the item.
        clearance: metres above the surface at which the item is let go.
    """
    out = (math.cos(facing), math.sin(facing), 0.0)
    item = Pose(
        position=add(slot, (0.0, 0.0, height / 2.0 + clearance)),
        orientation=about(_Z, facing),
    )
    tool = compose(item, invert(item_in_tool))
    return Place(
        above=_moved(tool, scale(_Z, UP)),
        place=tool,
        retraction=_moved(tool, scale(out, AWAY)),
        item_in_map=item,
    )


def _moved(pose: Pose, by: Vector3) -> Pose:
    return Pose(position=add(pose.position, by), orientation=pose.orientation)


def proximity_poses(
    target: Vector3,
    facing: float,
    work_point: tuple[float, float],
    work_heading: float = 0.0,
) -> tuple[FloorPose, ...]:
    """Return base poses from which a hand gets at ``target``, best first (order-picking paper, III-A.3).

    Args:
        target: the point in the map.
        facing: heading (rad) from the target against which the hand will point.
        work_point: x and y of the target in the base, where the hand works best (m).
        work_heading: heading (rad) in the base in which the hand points when it works best.
    """
    poses = []
    for angle in STAND_ANGLES:
        yaw = math.remainder(facing + math.pi - work_heading + angle, 2 * math.pi)
        cos, sin = math.cos(yaw), math.sin(yaw)
        for further in STAND_DISTANCES:
            x, y = work_point[0] + further, work_point[1]
            poses.append(FloorPose(x=target[0] - cos * x + sin * y, y=target[1] - sin * x - cos * y, yaw=yaw))
    return tuple(poses)
