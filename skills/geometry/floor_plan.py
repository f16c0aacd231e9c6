"""The furniture of a site: its boxes in the map, and how much room they leave to stand."""

from __future__ import annotations

import math
from typing import NamedTuple

from tandem.skills.geometry.poses import about
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site, SiteBox
from tandem.skills.ports.world import Box


def box_in_map(box: SiteBox) -> Box:
    """Return a box of furniture with its pose in the map."""
    return Box(size=box.size, pose=Pose(position=box.centre, orientation=about((0, 0, 1), box.yaw)))


class _Rectangle(NamedTuple):
    """A box in plan: centre, direction of its length, half edges."""

    x: float
    y: float
    cos: float
    sin: float
    along: float
    across: float
    reach: float
    """Metres from the centre to a corner."""

    def distance(self, x: float, y: float) -> float:
        """Return the metres to a point; 0 within."""
        dx, dy = x - self.x, y - self.y
        along = abs(self.cos * dx + self.sin * dy) - self.along
        across = abs(self.cos * dy - self.sin * dx) - self.across
        if along <= 0.0:
            return max(0.0, across)
        return along if across <= 0.0 else math.hypot(along, across)


class FloorPlan:
    """A site's furniture in plan, for many questions. Make one when they come: a site may change.

    Args:
        site: what is known beforehand.
    """

    def __init__(self, site: Site) -> None:
        self._bounds = site.bounds
        self._rectangles = [_in_plan(box) for piece in site.furniture for box in piece.boxes]

    def room(self, x: float, y: float) -> float:
        """Return the metres in plan from a point of the floor to the nearest furniture; 0 within it."""
        x_min, y_min, x_max, y_max = self._bounds
        inside = min(x - x_min, x_max - x, y - y_min, y_max - y)
        return max(0.0, min([inside, *[each.distance(x, y) for each in self._rectangles]]))

    def has_room(self, x: float, y: float, radius: float) -> bool:
        """Return whether a disc of ``radius`` metres fits there: ``room`` at least that, found out sooner."""
        x_min, y_min, x_max, y_max = self._bounds
        if min(x - x_min, x_max - x, y - y_min, y_max - y) < radius:
            return False
        for each in self._rectangles:
            dx, dy, near = x - each.x, y - each.y, each.reach + radius
            if dx * dx + dy * dy < near * near and each.distance(x, y) < radius:
                return False
        return True


def _in_plan(box: SiteBox) -> _Rectangle:
    (x, y, _), (length, width, _), yaw = box.centre, box.size, box.yaw
    along, across = length / 2.0, width / 2.0
    return _Rectangle(x, y, math.cos(yaw), math.sin(yaw), along, across, math.hypot(along, across))
