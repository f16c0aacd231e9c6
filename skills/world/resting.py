"""An item does not stand in what carries it: from afar its height is seen less well than furniture is known.

A camera whose height or pitch is off by 3 mrad sees an item 9 mm too low at 3 m. Were it believed to stand as
deep in its board, fingers at its middle would touch the board, and no arm would reach it from anywhere.
"""

from __future__ import annotations

from collections.abc import Iterable

from tandem.skills.geometry.poses import add, compose, invert
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import Shaped
from tandem.skills.ports.world import Box, Sighting


def on_top(sighting: Sighting, thing: Shaped, furniture: Iterable[Box]) -> Sighting:
    """Return the sighting, raised by as much as its item would stand in a box of the furniture.

    An item whose middle is in the box, or below it, does not stand on that box: it stays where it was seen.
    So does one that has fallen over.
    """
    stands = standing_in_map(sighting.tag_in_map, thing)
    if stands is None:
        return sighting
    sunk = max((_sunk(stands, thing.size[2], box) for box in furniture), default=0.0)
    if sunk <= 0.0:
        return sighting
    tag = sighting.tag_in_map
    raised = Pose(position=add(tag.position, (0.0, 0.0, sunk)), orientation=tag.orientation)
    return sighting.model_copy(update={"tag_in_map": raised})


def _sunk(stands: Pose, height: float, box: Box) -> float:
    """Return the metres by which an item of that height stands in a box; 0 where it does not stand on it."""
    x, y, z = compose(invert(box.pose), stands).position
    length, width, thick = box.size
    above = z - thick / 2.0
    if abs(x) > length / 2.0 or abs(y) > width / 2.0 or above <= 0.0:
        return 0.0
    return max(0.0, height / 2.0 - above)
