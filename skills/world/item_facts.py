"""A sighting as a fact, and the box that a fact says an item to be in."""

from __future__ import annotations

from tandem.skills.geometry.poses import about, rotate
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import Shaped
from tandem.skills.ports.site import SiteItem
from tandem.skills.ports.world import Box, ItemFact, Sighting


def fact_of(sighting: Sighting, item: SiteItem) -> ItemFact:
    """Return what a sighting says of its item."""
    return ItemFact(
        item=sighting.item,
        size=item.size,
        shape=item.shape,
        tag_in_map=sighting.tag_in_map,
        seen=sighting.stamp,
        quality=sighting.quality,
        position_sigma=sighting.position_sigma,
    )


def item_box(tag_in_map: Pose, thing: Shaped) -> Box:
    """Return the item behind a tag, with its shape; one that has fallen over is in a cube that holds it."""
    stands = standing_in_map(tag_in_map, thing)
    if stands is not None:
        return Box(size=thing.size, pose=stands, shape=thing.shape)
    edge = max(thing.size)
    out = rotate(tag_in_map.orientation, (0.0, 0.0, -edge / 2.0))
    x, y, z = tag_in_map.position
    middle = (x + out[0], y + out[1], z + out[2])
    return Box(size=(edge, edge, edge), pose=Pose(position=middle, orientation=about((0, 0, 1), 0.0)))
