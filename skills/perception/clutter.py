"""What is untagged, out of the depth image: boxes about points that nothing known explains."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import about, compose, invert, transform
from tandem.skills.perception.depth import back_project
from tandem.skills.perception.rigid import Matrix, points_from, points_in
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box

COST: Final = 0.08
"""Robot seconds that one picture's clutter is charged in lockstep."""
STRIDE: Final = 4
"""Every how many pixels a point is taken, in both directions."""
VOXEL: Final = 0.02
"""Metres."""
RANGE: Final = (0.3, 2.2)
"""Metres along the optical axis within which depth is good enough."""
HEIGHTS: Final = (0.04, 1.7)
"""Metres above the floor."""
LEVEL_MARGIN: Final = 0.045
"""Metres by which known things are grown sideways: the robot's own pose is known no better."""
UPRIGHT_MARGIN: Final = 0.018
"""Metres by which they are grown up and down: the noise of the depth."""
ARM_RADIUS: Final = 0.14
"""Metres about the arms within which points are the robot's own."""
MIN_POINTS: Final = 3
"""In a voxel; fewer are noise."""
MIN_VOXELS: Final = 4
"""In a cluster; fewer are noise."""
STANDS_WITHIN: Final = 0.06
"""Metres above a surface up to which a box is lengthened downwards: what is near the surface was cut off."""
NEARER: Final = 0.03
"""Metres before the nearest point of a box from which on something covers it: four deviations of the depth at
2.2 m."""
COVERED: Final = 0.1
"""Share of a box's points that must be covered: two of fifteen, an upright edge of it. A tag
on that side has lost its border then and is not read."""
_NEIGHBOURS: Final = tuple(step for step in product((-1, 0, 1), repeat=3) if step != (0, 0, 0))


@dataclass(frozen=True)
class Known:
    """What explains points: boxes in the map (furniture, tagged items), and the robot itself.

    ``segments`` are the arms as lines in the base; ``body_radius`` is that of the column about the base.
    """

    furniture: tuple[Box, ...]
    items: tuple[Box, ...]
    segments: tuple[tuple[Vector3, Vector3], ...] = ()
    body_radius: float = 0.3


def unexplained(image: RgbdImage, camera_in_base: Pose, base_in_map: Pose, known: Known) -> Matrix:
    """Return (n, 3) points in the map that no known thing explains, without those that stand alone.

    Pictures of the same place add up: hand the points of all of them to ``boxes`` together.
    """
    points = points_in(compose(base_in_map, camera_in_base), _points(image))
    points = points[(points[:, 2] > HEIGHTS[0]) & (points[:, 2] < HEIGHTS[1])]
    points = without(points, (*known.furniture, *known.items))
    points = points[~of_robot(points_from(base_in_map, points), known)]
    if len(points) == 0:
        return np.zeros((0, 3))
    _, index, counts = np.unique(_cell_numbers(points), return_inverse=True, return_counts=True)
    return np.asarray(points[counts[index.reshape(-1)] >= MIN_POINTS], np.float64)


def without(points: Matrix, explained: Sequence[Box]) -> Matrix:
    """Return the points that lie in none of the boxes, grown by the margins."""
    for box in explained:
        if len(points) and _near(points, box):
            points = points[~_inside(points, box, LEVEL_MARGIN, UPRIGHT_MARGIN)]
    return points


def boxes(points: Matrix, surfaces: Sequence[Box]) -> tuple[Box, ...]:
    """Return the boxes about the clusters of points, the biggest first.

    Args:
        points: (n, 3) metres in the map, as ``unexplained`` gives them.
        surfaces: furniture; what begins just above its top, or above the floor, stands on it.
    """
    if len(points) == 0:
        return ()
    cells, index = np.unique(np.floor(points / VOXEL).astype(np.int64), axis=0, return_inverse=True)
    labels = _connected(cells)
    of_point = labels[index.reshape(-1)]
    found = [
        _box(points[of_point == label], surfaces)
        for label in range(int(labels.max()) + 1)
        if int((labels == label).sum()) >= MIN_VOXELS
    ]
    return tuple(sorted(found, key=lambda box: (-box.size[0] * box.size[1] * box.size[2], box.pose.position)))


def looked_through(image: RgbdImage, camera_in_map: Pose, believed: Sequence[Box]) -> tuple[Box, ...]:
    """Return those of the believed boxes that this picture shows wholly: seen again or gone, but not hidden.

    Corners, centres of faces and the middle are tested: each must lie in the picture and not behind something
    nearer.
    """
    return tuple(box for box in believed if _shown(image, camera_in_map, box))


def _points(image: RgbdImage) -> Matrix:
    """Return (n, 3) points in the camera's frame."""
    z = image.depth[::STRIDE, ::STRIDE].astype(np.float64) / 1000.0
    rows, columns = np.nonzero((z > RANGE[0]) & (z < RANGE[1]))
    return back_project(image.header, columns * STRIDE, rows * STRIDE, z[rows, columns])


def of_robot(points: Matrix, known: Known) -> NDArray[np.bool_]:
    """Say which points (n, 3) in the base belong to the robot itself."""
    own = np.hypot(points[:, 0], points[:, 1]) < known.body_radius
    for start, end in known.segments:
        a, way = np.array(start), np.subtract(end, start)
        share = np.clip((points - a) @ way / max(float(way @ way), 1e-9), 0.0, 1.0)
        own |= np.linalg.norm(points - a - share[:, None] * way, axis=1) < ARM_RADIUS
    return np.asarray(own, np.bool_)


def _near(points: Matrix, box: Box) -> bool:
    reach = math.dist((0.0, 0.0, 0.0), box.size) / 2.0 + LEVEL_MARGIN
    middle = np.array(box.pose.position)
    return bool(np.all(points.min(axis=0) < middle + reach) and np.all(points.max(axis=0) > middle - reach))


def _cell_numbers(points: Matrix) -> NDArray[np.int64]:
    """Return one number for each point's voxel; the map is less than 20 km wide."""
    x, y, z = (np.floor(points / VOXEL).astype(np.int64) + (1 << 19)).T
    return np.asarray((x << 40) + (y << 20) + z, np.int64)


def _inside(points: Matrix, box: Box, level: float, upright: float) -> NDArray[np.bool_]:
    half = np.array(box.size) / 2.0 + np.array([level, level, upright])
    return np.asarray(np.all(np.abs(points_from(box.pose, points)) <= half, axis=1), np.bool_)


def _connected(cells: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the number of each cell's cluster (26 neighbours), in the order of the cells."""
    where = {(int(x), int(y), int(z)): i for i, (x, y, z) in enumerate(cells)}
    labels = np.full(len(cells), -1, np.int64)
    clusters = 0
    for first, start in where.items():
        if labels[start] >= 0:
            continue
        labels[start] = clusters
        queue = deque([first])
        while queue:
            x, y, z = queue.popleft()
            for dx, dy, dz in _NEIGHBOURS:
                neighbour = (x + dx, y + dy, z + dz)
                at = where.get(neighbour)
                if at is not None and labels[at] < 0:
                    labels[at] = clusters
                    queue.append(neighbour)
        clusters += 1
    return labels


def _box(points: Matrix, surfaces: Sequence[Box]) -> Box:
    """Return the upright box of least ground area about the points, down to what it stands on."""
    plan = points[:, :2]
    middle = plan.mean(axis=0)
    (cx, cy), (width, depth), degrees = cv2.minAreaRect((plan - middle).astype(np.float32))
    bottom, top = float(points[:, 2].min()), float(points[:, 2].max())
    x, y = float(cx + middle[0]), float(cy + middle[1])
    bottom = _floor_below(x, y, bottom, surfaces)
    size = (max(float(width), VOXEL), max(float(depth), VOXEL), max(top - bottom, VOXEL))
    return Box(
        size=size,
        pose=Pose(
            position=(x, y, bottom + size[2] / 2.0),
            orientation=about((0.0, 0.0, 1.0), math.radians(float(degrees))),
        ),
    )


def _floor_below(x: float, y: float, bottom: float, surfaces: Sequence[Box]) -> float:
    """Return the height of the surface just below, or ``bottom`` where there is none."""
    tops = [0.0]
    for box in surfaces:
        local = points_from(box.pose, np.array([[x, y, box.pose.position[2]]]))[0]
        if (
            abs(local[0]) <= box.size[0] / 2 + LEVEL_MARGIN
            and abs(local[1]) <= box.size[1] / 2 + LEVEL_MARGIN
        ):
            tops.append(box.pose.position[2] + box.size[2] / 2)
    near = [top for top in tops if top - 0.01 <= bottom <= top + STANDS_WITHIN]
    return max(near, default=bottom)


def seen_through(image: RgbdImage, camera_in_map: Pose, box: Box) -> bool:
    """Say whether the depth proves that nothing is in the box: what is measured lies behind each point of it.

    Tested is the upper half, drawn in by a third: below, the surface is too near to tell, and sideways the
    robot's own pose may be some centimetres off.
    """
    width, depth, height = box.size
    upper = Pose(position=transform(box.pose, (0.0, 0.0, 0.22 * height)), orientation=box.pose.orientation)
    seen = _depths(image, camera_in_map, Box(size=(0.66 * width, 0.66 * depth, 0.4 * height), pose=upper))
    if seen is None:
        return False
    expected, measured = seen
    return bool(np.mean(measured > expected + 0.03) > 0.9)  # noqa: PLR2004


def covered(image: RgbdImage, camera_in_map: Pose, box: Box) -> bool:
    """Say whether something nearer than the box hides enough of it for a tag not to be read."""
    seen = _depths(image, camera_in_map, box)
    if seen is None:
        return False
    expected, measured = seen
    return bool(np.mean((measured > 0.0) & (measured < float(expected.min()) - NEARER)) >= COVERED)


def _shown(image: RgbdImage, camera_in_map: Pose, box: Box) -> bool:
    seen = _depths(image, camera_in_map, box)
    if seen is None:
        return False
    expected, measured = seen
    hidden = (measured > 0.0) & (measured < float(expected.min()) - 0.05)
    return bool(hidden.mean() < 0.25)  # noqa: PLR2004


def _depths(image: RgbdImage, camera_in_map: Pose, box: Box) -> tuple[Matrix, Matrix] | None:
    """Return the depths (m) of corners, faces and middle of the box, and what was measured at their pixels.

    None when a part of the box is out of the picture, too near or too far.
    """
    head = image.header
    shares = np.array([*product((-0.5, 0.5), repeat=3), *np.eye(3) / 2, *-np.eye(3) / 2, np.zeros(3)])
    box_in_camera = compose(invert(camera_in_map), box.pose)
    points = points_in(box_in_camera, shares * np.array(box.size))
    z = points[:, 2]
    if np.any(z < RANGE[0]) or np.any(z > RANGE[1]):
        return None
    columns = np.round(head.fx * points[:, 0] / z + head.cx).astype(int)
    rows = np.round(head.fy * points[:, 1] / z + head.cy).astype(int)
    if np.any((columns < 0) | (columns >= head.width) | (rows < 0) | (rows >= head.height)):
        return None
    return z, np.asarray(image.depth[rows, columns].astype(np.float64) / 1000.0, np.float64)
