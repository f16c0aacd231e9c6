"""The arithmetic of a pick and a place, on one tag pose, in the field's own frames.

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
from collections.abc import Iterable
from typing import Final

from tandem.skills.geometry.poses import (
    about,
    add,
    compose,
    from_axes,
    invert,
    rotate,
    scale,
    turned,
)
from tandem.skills.grasping.item_frames import item_in_map, outward, turned_about
from tandem.skills.ports.message import Message, Quaternion, Vector3
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.shapes import Solid, extents, within_quarter

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

STRAIGHT_DOWN: Final = 0.05
"""Sine of the angle from the vertical below which a hand has no way ahead in plan: 3 degrees."""

PALM_ROOM: Final = 0.002
"""Metres that stay free between an item and the palm."""

_Z: Final[Vector3] = (0.0, 0.0, 1.0)


class Grasp(Message):
    """The poses of the tool frame in the map for one pick, and the item in the tool once grasped."""

    pitch: float
    pre_grasp: Pose
    grasp: Pose
    retraction: Pose
    item_in_tool: Pose

    def turned(self, angle: float) -> Grasp:
        """Return the grasp turned by ``angle`` (rad) about the item's vertical.

        The item in the tool stays: fingers that close turn a box along, and a cylinder looks as before.
        """
        if angle == 0.0:
            return self
        at = compose(self.grasp, self.item_in_tool).position
        return Grasp(
            pitch=self.pitch,
            pre_grasp=turned(self.pre_grasp, at, angle),
            grasp=turned(self.grasp, at, angle),
            retraction=turned(self.retraction, at, angle),
            item_in_tool=self.item_in_tool,
        )


class Place(Message):
    """The poses of the tool frame in the map for one placing: above, down, and back."""

    above: Pose
    place: Pose
    retraction: Pose
    item_in_map: Pose

    def turned(self, angle: float) -> Place:
        """Return the place turned by ``angle`` (rad) about the item's vertical."""
        if angle == 0.0:
            return self
        at = self.item_in_map.position
        return Place(
            above=turned(self.above, at, angle),
            place=turned(self.place, at, angle),
            retraction=turned(self.retraction, at, angle),
            item_in_map=turned(self.item_in_map, at, angle),
        )


def tool_orientation(out: Vector3, pitch: float) -> Quaternion:
    """Return the tool's orientation in the map: approaching against ``out``, pitched down by ``pitch``.

    ``out`` is level and of unit length. The tool's y stays level, so that the fingers close sideways.
    """
    ahead = scale(out, -1.0)
    x = (ahead[0] * math.cos(pitch), ahead[1] * math.cos(pitch), -math.sin(pitch))
    y = (-ahead[1], ahead[0], 0.0)
    z = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return from_axes(x, y, z)


def held_back(size: Vector3, pitch: float, palm: float | None) -> float:
    """Return the metres before an item's middle at which a hand takes it, so that its palm stays clear of it.

    Args:
        size: the item's edges (m): along the hand in plan, across it, and up.
        pitch: radians by which the hand looks down.
        palm: metres from the palm to the middle of the pads; None when every item fits.
    """
    if palm is None:
        return 0.0
    reaches = (size[0] * math.cos(pitch) + size[2] * math.sin(pitch)) / 2.0
    return max(0.0, reaches + PALM_ROOM - palm)


def grasp(tag_in_map: Pose, depth: float, pitch: float, *, back: float = 0.0) -> Grasp:
    """Return the poses of a pick (eq. 1 and 2).

    Args:
        tag_in_map: the tag on one upright face of the item.
        depth: metres of the item along the tag's z; the grasp goes to its centre.
        pitch: radians by which the hand looks down.
        back: metres before the centre at which the hand stays (``held_back``).
    """
    out = outward(tag_in_map)
    item = item_in_map(tag_in_map, depth)
    orientation = tool_orientation(out, pitch)
    short = scale(rotate(orientation, (1.0, 0.0, 0.0)), -back)
    at_item = Pose(position=add(item.position, short), orientation=orientation)
    approach = scale(out, APPROACH + depth / 2.0)
    away = add(scale(out, AWAY), scale(_Z, UP))
    return Grasp(
        pitch=pitch,
        pre_grasp=_moved(at_item, approach),
        grasp=at_item,
        retraction=_moved(at_item, away),
        item_in_tool=compose(invert(at_item), item),
    )


def grasps_on(
    tag_in_map: Pose, shape: Solid, pitches: Iterable[float], palm: float | None
) -> tuple[Grasp, ...]:
    """Return the ways to take an item on one of its quarters: for each direction in it, one for each pitch.

    Args:
        tag_in_map: the tag on the face that the hand goes for, at the middle of the quarter.
        shape: of the item, its x out of that face. A box is taken by it, a cylinder from around it, too.
        pitches: radians by which the hand looks down, the preferred one first.
        palm: of the gripper (``Gripper.palm``).
    """
    size, tried = extents(shape), tuple(pitches)
    return tuple(
        grasp(on_side, size[0], pitch, back=held_back(size, pitch, palm))
        for turn in within_quarter(shape)
        for on_side in (tag_in_map if turn == 0.0 else turned_about(tag_in_map, size[0], turn),)
        for pitch in tried
    )


def place(
    slot: Vector3, facing: float, item_in_tool: Pose, height: float, *, clearance: float = 0.004
) -> Place:
    """Return the poses of placing what is in the hand, as it is held (eq. 3).

    The hand draws back level and against the way in which it looks, whichever face it holds the item by: to
    the side, a finger would take the item along.

    Args:
        slot: the point of the surface, in the map.
        facing: heading (rad) from the slot towards the robot: "away".
        item_in_tool: how the item is held; it was upright when grasped, and is put down upright.
        height: metres of the item.
        clearance: metres above the surface at which the item is let go.
    """
    item = Pose(
        position=add(slot, (0.0, 0.0, height / 2.0 + clearance)),
        orientation=about(_Z, facing),
    )
    tool = compose(item, invert(item_in_tool))
    return Place(
        above=_moved(tool, scale(_Z, UP)),
        place=tool,
        retraction=_moved(tool, scale(_backwards(tool, facing), AWAY)),
        item_in_map=item,
    )


def _backwards(tool: Pose, facing: float) -> Vector3:
    """Return the level direction out of the hand's back; ``facing`` (rad) for one that looks down."""
    x, y, _ = rotate(tool.orientation, (-1.0, 0.0, 0.0))
    length = math.hypot(x, y)
    if length < STRAIGHT_DOWN:
        return (math.cos(facing), math.sin(facing), 0.0)
    return (x / length, y / length, 0.0)


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
