"""How far a hand's poses may be turned about a vertical for an arm of fewer than six joints.

The fingers that close on a box turn it until it lies flat between them, so it is held as if nothing had been
turned. A cylinder looks the same from each side.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.grasping.tag_grasps import FINGER_ROOM
from tandem.skills.ports.actions.arm import TurnAbout
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import RING, BoxShape, Solid, extents, is_round, seen_from, sides

MOST: Final = math.radians(10.0)
"""Radians. A base that stands 6 cm aside (``at_pose.POSITION_TOLERANCE``), 0.5 m from the item, makes 7
degrees; the turns in which an item is put down are 20 apart (``place_above.TURNS``)."""
SPARE: Final = 0.003
"""Metres that stay free on each side of a turned box: of the 8 mm of ``FINGER_ROOM`` 5 are left for its
corners, and the rest for what the camera is off."""
SETTLED: Final = math.radians(3.0)
"""Radians. For a motion that goes on from where the hand is: the base stands, but where it believes to stand
may shift by a centimetre meanwhile."""


def to_grasp(item_at: Vector3, shape: Solid, widest: float) -> TurnAbout:
    """Return the turn of a grasp.

    Args:
        item_at: the item's middle, in the grasp's frame (m).
        shape: of the item, its x along the hand.
        widest: metres to which the hand opens.
    """
    if is_round(shape):
        return TurnAbout(point=item_at, most=math.pi / RING)
    depth, width, _ = extents(shape)
    opening = min(width + 2.0 * FINGER_ROOM, widest) - 2.0 * SPARE
    diagonal = math.hypot(depth, width)
    if opening <= width:
        return TurnAbout(point=item_at, most=0.0)
    # Turned by a, the box is w cos a + d sin a wide: the diagonal's share across the hand.
    fits = math.atan2(depth, width) - math.acos(min(1.0, opening / diagonal))
    return TurnAbout(point=item_at, most=max(0.0, min(MOST, fits)))


def of_every_side(shape: Solid, widest: float) -> float:
    """Return the radians that a grasp from any side may be turned; arguments as ``to_grasp``."""
    if is_round(shape):
        return to_grasp((0.0, 0.0, 0.0), shape, widest).most
    seen = (BoxShape(seen_from(shape, side)) for side in sides(shape))
    return min(to_grasp((0.0, 0.0, 0.0), each, widest).most for each in seen)


def to_place(slot: Vector3) -> TurnAbout:
    """Return the turn of placing: the item stands in its slot a little askew."""
    return TurnAbout(point=slot, most=MOST)


def to_go_on(pose: Pose) -> TurnAbout:
    """Return the turn of a pose that a straight motion leads to, about itself."""
    return TurnAbout(point=pose.position, most=SETTLED)
