"""Plans: what things cover of the floor, seen from above, and how far apart they are. Metres, in map."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

from tandem.sim.things import CylinderShape
from tandem.skills.geometry.poses import rotate

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tandem.sim.scene import SceneBody

Point = tuple[float, float]


@dataclass(frozen=True)
class Plan:
    """A convex polygon (``corners`` in order; one corner is a point) grown by ``radius`` on all sides."""

    corners: tuple[Point, ...]
    radius: float = 0.0

    def edges(self) -> Iterator[tuple[Point, Point]]:
        """Give each side; a point is its own only side."""
        return zip(self.corners, self.corners[1:] + self.corners[:1], strict=True)

    def covers(self, point: Point) -> bool:
        """Whether a point lies inside the polygon (the radius apart)."""
        signs = [_cross(start, end, point) for start, end in self.edges()]
        inside = all(sign > 0.0 for sign in signs) or all(sign < 0.0 for sign in signs)
        return len(self.corners) > 2 and inside


def plan_of(body: SceneBody) -> Plan:
    """Return the plan of an upright body."""
    x, y, _ = body.pose.position
    if isinstance(body.shape, CylinderShape):
        return Plan(((x, y),), body.shape.radius)
    length, width, _ = body.shape.size
    corners = []
    for along, aside in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        dx, dy, _ = rotate(body.pose.orientation, (along * length / 2, aside * width / 2, 0.0))
        corners.append((x + dx, y + dy))
    return Plan(tuple(corners))


def gap(first: Plan, second: Plan) -> float:
    """Return the shortest way between two plans; 0 when they touch or overlap."""
    if first.covers(second.corners[0]) or second.covers(first.corners[0]):
        return 0.0
    between = min(_apart(one, other) for one, other in product(first.edges(), second.edges()))
    return max(0.0, between - first.radius - second.radius)


def _cross(start: Point, end: Point, point: Point) -> float:
    return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])


def _apart(one: tuple[Point, Point], other: tuple[Point, Point]) -> float:
    """Return the distance of two line segments."""
    crosses = (
        _cross(*one, other[0]) * _cross(*one, other[1]) < 0.0
        and _cross(*other, one[0]) * _cross(*other, one[1]) < 0.0
    )
    if crosses:
        return 0.0
    ends = [_from_segment(point, *other) for point in one] + [_from_segment(point, *one) for point in other]
    return min(ends)


def _from_segment(point: Point, start: Point, end: Point) -> float:
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    along = 0.0
    if square > 0.0:
        along = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / square
        along = min(1.0, max(0.0, along))
    return math.hypot(point[0] - start[0] - along * dx, point[1] - start[1] - along * dy)
