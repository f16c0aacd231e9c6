"""Grasps told in an item's own frame, so that they move with the item: what a field and a planner go for.

The item's frame has its origin in the centre, z up at rest, x out of the tagged face. A tool pose is
as in ``skills/grasping/tag_grasps.py``: x out of the hand, y along the closing.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.geometry.poses import about, add, compose, invert, multiply, rotate, scale
from tandem.skills.grasping.item_frames import tag_of_item, turned_about
from tandem.skills.grasping.tag_grasps import AWAY, PITCHES, UP, grasp
from tandem.skills.ports.message import Count, Message, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import Solid, extents, seen_from, sides
from tandem.skills.ports.site import GraspPoint

MOST_AWAY: Final = math.radians(100.0)
"""Of the hand's best heading; beyond it the hand would come from behind the item."""
LEANS: Final = tuple(math.radians(angle) for angle in (15.0, 30.0, 0.0, 45.0))
"""By how much a hand that presses on a side points away from the robot, in the order in which it is tried.

Arms that come from between the things and the robot hardly point straight at each other: with none at all the
elbow would be in the room's next table.
"""
DOWNS: Final = tuple(math.radians(angle) for angle in (0.0, 20.0))
"""By how much it points downwards."""
TIP: Final = 0.015
"""Metres by which the finger tips reach past the tool's origin."""

_UP: Final[Vector3] = (0.0, 0.0, 1.0)


class HandGrasp(Message):
    """One way to take hold: which side of the item (its number, from the tagged one on), and how.

    A box has four sides, a cylinder a ring of them (``skills.ports.shapes.sides``).
    """

    face: Count
    pitch: float
    tool_in_item: Pose


def item_grasps(shape: Solid, heading: float) -> tuple[HandGrasp, ...]:
    """Return the ways in which one hand takes an item with a finger on either side, the best first.

    A box is taken by its faces, a cylinder from each direction of its ring.

    Args:
        shape: of the item.
        heading: in the item's frame (rad), in which the hand points when it works best.
    """
    through = extents(shape)[0]
    tag = tag_of_item(Pose(), through)
    ways = []
    for number, side in enumerate(sides(shape)):
        off = abs(math.remainder(math.pi + side - heading, 2.0 * math.pi))
        if off <= MOST_AWAY:
            depth, on_side = seen_from(shape, side)[0], turned_about(tag, through, side)
            ways += [
                (round(off, 3), place, number, pitch, grasp(on_side, depth, pitch).grasp)
                for place, pitch in enumerate(PITCHES)
            ]
    ways.sort(key=lambda each: each[:2])
    return tuple(HandGrasp(face=number, pitch=pitch, tool_in_item=pose) for _, _, number, pitch, pose in ways)


def side_grasps(point: GraspPoint, away: float) -> tuple[HandGrasp, ...]:
    """Return the ways in which a closed hand presses on a grasp point, finger tips on it, the best first.

    Args:
        point: where, and in which direction it presses (two-arm thesis, 4.1.1: g_L or g_R).
        away: heading in the item's frame (rad) away from the robot, towards which the hand may lean.
    """
    x, y, _ = point.inwards
    inwards = math.atan2(y, x)
    sense = math.copysign(1.0, math.remainder(away - inwards, 2.0 * math.pi))
    ways = []
    for down in DOWNS:
        for lean in LEANS:
            turned = multiply(about(_UP, inwards + sense * lean), about((0.0, 1.0, 0.0), down))
            tip = scale(rotate(turned, (1.0, 0.0, 0.0)), -TIP)
            tool = Pose(position=add(point.position, tip), orientation=turned)
            ways.append(HandGrasp(face=0, pitch=down, tool_in_item=tool))
    return tuple(ways)


def lifted(tool: Pose, away: float = AWAY, up: float = UP) -> Pose:
    """Return the tool after it drew the item back along its heading, and up (order-picking paper, eq. 2)."""
    x, y, _ = rotate(tool.orientation, (1.0, 0.0, 0.0))
    size = math.hypot(x, y) or 1.0
    by = (-away * x / size, -away * y / size, up)
    return Pose(position=add(tool.position, by), orientation=tool.orientation)


def before(tool: Pose, way: float) -> Pose:
    """Return the tool ``way`` metres before a grasp, against its x (two-arm thesis, 4.3: the goal radius)."""
    back = scale(rotate(tool.orientation, (1.0, 0.0, 0.0)), -way)
    return Pose(position=add(tool.position, back), orientation=tool.orientation)


def upright_at(point: Vector3, heading: float, way: HandGrasp) -> Pose:
    """Return the tool that holds the item upright with its middle at a point.

    Args:
        point: where the item's centre shall be (m).
        heading: of the hand, in the frame of the point (rad).
        way: how the item is held.
    """
    x, y, _ = rotate(way.tool_in_item.orientation, (1.0, 0.0, 0.0))
    turn = about(_UP, heading - math.atan2(y, x))
    return compose(Pose(position=point, orientation=turn), way.tool_in_item)


def item_in_tool(way: HandGrasp) -> Pose:
    """Return the item's centre frame in the tool, once it is held so."""
    return invert(way.tool_in_item)
