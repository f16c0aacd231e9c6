"""The site's map for the base: what the laser sees, and where the robot may stand.

Both are signed distance fields worked out from the furniture's boxes themselves, not from a raster of
them, so that walls lie where the site file says and not where the next cell begins. What the raster would
have needed (Felzenszwalb & Huttenlocher 2012) the boxes give exactly and sooner.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import BoolArray, FloatArray
from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import rotate, to_floor
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site, SiteBox

STEP: Final = 0.025
"""Metres between the fields' nodes."""
RIM: Final = 0.2
"""Metres that the fields reach beyond the floor's bounds."""
PIECE: Final = 0.02
"""Metres: edges are cut into pieces of this length when hidden parts are dropped."""
TOUCHING: Final = 1e-3
"""Metres: boxes as near as this make one body."""


@dataclass(frozen=True)
class SiteMap:
    """What is known beforehand of the floor.

    ``laser``: distance to what crosses the laser's plane. ``plan``: distance to what the robot's body could
    hit, at any height, and to the floor's end. ``laser_in_base``: the sensor's pose.
    """

    bounds: tuple[float, float, float, float]
    laser: DistanceField
    plan: DistanceField
    laser_in_base: FloorPose


def build_map(site: Site, description: RobotDescription) -> SiteMap:
    """Return the map of a site for a robot.

    Raises:
        ValueError: when the laser's frame is not in the URDF, or the laser does not lie level.
    """
    mount = Chain.from_urdf(description.urdf, description.base_frame, description.laser.frame).pose({})
    if rotate(mount.orientation, (0.0, 0.0, 1.0))[2] < math.cos(math.radians(0.5)):
        raise ValueError(f"{description.laser.frame}: expected a laser that lies level, z up")
    height = mount.position[2]
    boxes = [box for furniture in site.furniture for box in furniture.boxes]
    seen = [b for b in boxes if abs(b.centre[2] - height) <= b.size[2] / 2]
    return SiteMap(
        bounds=site.bounds,
        laser=surface_field(seen, site.bounds),
        plan=floor_field(site, description.height),
        laser_in_base=to_floor(mount),
    )


def box_distances(box: SiteBox, points: FloatArray) -> FloatArray:
    """Return the signed distances, shape (n,), in plan from points, shape (n, 2), to a box."""
    c, s = math.cos(box.yaw), math.sin(box.yaw)
    dx, dy = points[:, 0] - box.centre[0], points[:, 1] - box.centre[1]
    ex = np.abs(c * dx + s * dy) - box.size[0] / 2
    ey = np.abs(c * dy - s * dx) - box.size[1] / 2
    outside = np.hypot(np.maximum(ex, 0.0), np.maximum(ey, 0.0))
    return np.asarray(outside + np.minimum(np.maximum(ex, ey), 0.0), dtype=np.float64)


def _inside_bounds(points: FloatArray, bounds: tuple[float, float, float, float]) -> FloatArray:
    """Return how far inside the floor's bounds the points lie (m); negative outside."""
    x_min, y_min, x_max, y_max = bounds
    x, y = points[:, 0], points[:, 1]
    return np.minimum(np.minimum(x - x_min, x_max - x), np.minimum(y - y_min, y_max - y))


def _nodes(bounds: tuple[float, float, float, float]) -> tuple[FloatArray, tuple[int, int]]:
    x_min, y_min, x_max, y_max = bounds
    columns = math.ceil((x_max - x_min + 2 * RIM) / STEP) + 1
    rows = math.ceil((y_max - y_min + 2 * RIM) / STEP) + 1
    x = x_min - RIM + STEP * np.arange(columns)
    y = y_min - RIM + STEP * np.arange(rows)
    grid = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    return grid, (rows, columns)


def _field(
    bounds: tuple[float, float, float, float], values: FloatArray, shape: tuple[int, int]
) -> DistanceField:
    return DistanceField(bounds[0] - RIM, bounds[1] - RIM, STEP, np.ascontiguousarray(values.reshape(shape)))


def floor_field(site: Site, height: float) -> DistanceField:
    """Return the distance to what a robot so high (m) could hit, and to the floor's end."""
    boxes = [box for furniture in site.furniture for box in furniture.boxes]
    return clearance_field([box for box in boxes if box.centre[2] - box.size[2] / 2 < height], site.bounds)


def clearance_field(boxes: list[SiteBox], bounds: tuple[float, float, float, float]) -> DistanceField:
    """Return the distance to the nearest box or to the floor's end."""
    points, shape = _nodes(bounds)
    values = _inside_bounds(points, bounds)
    for box in boxes:
        values = np.minimum(values, box_distances(box, points))
    return _field(bounds, values, shape)


def surface_field(boxes: list[SiteBox], bounds: tuple[float, float, float, float]) -> DistanceField:
    """Return the signed distance to the surfaces that can be seen from the floor.

    Where boxes touch, and behind the walls, the distance inside counts to the visible surface only: a
    scan point a little too deep is drawn back to where it was seen and not to a face that nobody sees.
    """
    points, shape = _nodes(bounds)
    values = np.full(len(points), 2 * RIM + max(bounds[2] - bounds[0], bounds[3] - bounds[1]))
    for box in boxes:
        values = np.minimum(values, box_distances(box, points))
    inside = (values <= 0.0) | (_inside_bounds(points, bounds) < -TOUCHING)
    starts, ends = visible_pieces(boxes, bounds)
    if len(starts):
        values[inside] = -_piece_distances(points[inside], starts, ends)
    return _field(bounds, values, shape)


def visible_pieces(
    boxes: list[SiteBox], bounds: tuple[float, float, float, float]
) -> tuple[FloatArray, FloatArray]:
    """Return starts and ends, shape (n, 2), of the parts of the boxes' edges that are not hidden."""
    starts: list[FloatArray] = []
    ends: list[FloatArray] = []
    for box in boxes:
        for a, b in _edges(box):
            count = max(1, math.ceil(float(np.linalg.norm(b - a)) / PIECE))
            cuts = a + (b - a) * np.linspace(0.0, 1.0, count + 1)[:, None]
            middle = (cuts[1:] + cuts[:-1]) / 2
            shown = _inside_bounds(middle, bounds) >= -TOUCHING
            for other in boxes:
                if other is not box:
                    shown &= box_distances(other, middle) > TOUCHING
            for first, last in _runs(shown):
                starts.append(cuts[first])
                ends.append(cuts[last])
    return np.array(starts).reshape(-1, 2), np.array(ends).reshape(-1, 2)


def _runs(shown: BoolArray) -> list[tuple[int, int]]:
    """Return (first, one past the last) of each unbroken row of True."""
    changes = np.flatnonzero(np.diff(np.concatenate(([False], shown, [False])).astype(np.int8)))
    return [(int(changes[i]), int(changes[i + 1])) for i in range(0, len(changes), 2)]


def _edges(box: SiteBox) -> list[tuple[FloatArray, FloatArray]]:
    c, s = math.cos(box.yaw), math.sin(box.yaw)
    half_x, half_y = box.size[0] / 2, box.size[1] / 2
    corners = [
        np.array([box.centre[0] + c * x - s * y, box.centre[1] + s * x + c * y])
        for x, y in ((-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y))
    ]
    return [(corners[i], corners[(i + 1) % 4]) for i in range(4)]


def _piece_distances(points: FloatArray, starts: FloatArray, ends: FloatArray) -> FloatArray:
    """Return the distances, shape (n,), from points to the nearest of the pieces."""
    nearest = np.full(len(points), np.inf)
    for start, end in zip(starts, ends, strict=True):
        along, offset = end - start, points - start
        share = np.clip(offset @ along / (along @ along), 0.0, 1.0)
        gap = offset - share[:, None] * along
        nearest = np.minimum(nearest, np.hypot(gap[:, 0], gap[:, 1]))
    return nearest
