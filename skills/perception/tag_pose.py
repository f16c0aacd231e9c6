"""The pose of a tag from its four corners, the depth on its face, and the knowledge that items stand upright.

The tag's frame has its origin in the tag's centre, x to the right as printed, y up as printed, and z out of
the face; x = y cross z. This is also the frame of OpenCV's IPPE_SQUARE, whose object points are (-s/2, s/2),
(s/2, s/2), (s/2, -s/2), (-s/2, -s/2), in the order in which OpenCV gives a marker's corners (top left, then
clockwise as printed). So no conversion is left to do; the camera's frame is the optical one (z forward, x
right, y down).

A square seen from four corners has two poses (Collins and Bartoli, IJCV 2014, "Infinitesimal plane-based
pose estimation"). Both are refined, and the one with the least cost is taken. The cost is a sum of squares:
corners against their pixels, depth points against the tag's plane with one offset common to all of them
(the camera's own bias), and, for a tag that stands upright within some degrees anyway, its y against up.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from tandem.skills.perception import depth as depth_image
from tandem.skills.perception.rigid import Matrix, pose_of, rotation_about, skew
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.pose import Pose

_CORNER_SIGMA: Final = 0.06
"""Pixels; what the edge fits leave in pictures with noise."""
_DEPTH_BIAS: Final = 0.002
"""Metres; the offset that all depth pixels of a face may share."""
_NEIGHBOURS: Final = 9.0
"""Depth pixels that are as good as one independent one."""
_UPRIGHT_SIGMA: Final = math.radians(0.7)
"""Radians, chosen: by which an item that stands may lean, and the camera's own tilt be off."""
_UPRIGHT_LIMIT: Final = math.radians(15.0)
"""Tilted more than this, an item does not stand upright, and nothing is assumed."""
_TILTED_COST: Final = 300.0
"""What it costs a solution not to be upright: believed only if the picture clearly says so."""
_ROUNDS: Final = 6
"""Of Gauss-Newton at the most."""
_OUTLIER: Final = 4.0
"""Standard deviations of the depth from which on a point is not on the face."""


@dataclass(frozen=True)
class DepthPoints:
    """Points measured on the face, (n, 3) metres in the camera, and the pixels they stand for."""

    points: Matrix
    pixels: int


@dataclass(frozen=True)
class Estimate:
    """A tag's pose in the camera and how far to trust it."""

    tag_in_camera: Pose
    position_sigma: float
    """Metres, root of the summed variances."""
    yaw_sigma: float
    """Radians, of the face's direction."""
    pixel_error: float
    """Root mean square distance of the corners in pixels."""
    viewing_angle: float
    """Radians between the face's normal and the line of sight."""
    depth_gap: float | None
    """Metres from the tag's plane to the depth on it (median); None without depth."""
    upright: bool


@dataclass(frozen=True)
class _Problem:
    header: RgbdHeader
    corners: Matrix
    square: Matrix
    depth: DepthPoints | None
    up: Matrix | None


@dataclass(frozen=True)
class _Solution:
    rotation: Matrix
    position: Matrix
    covariance: Matrix
    cost: float
    upright: bool


def estimate(
    header: RgbdHeader,
    corners: Matrix,
    tag_size: float,
    depth: DepthPoints | None = None,
    up_in_camera: Matrix | None = None,
) -> Estimate | None:
    """Return the tag's pose.

    Args:
        header: the picture's intrinsics.
        corners: (4, 2) pixels, in OpenCV's order.
        tag_size: edge of the black square in metres.
        depth: what was measured on the face.
        up_in_camera: the map's up as a unit vector in the camera's frame.

    Returns:
        The pose, or None when the corners are no square before the camera, or when the depth says that it is
        another distance away than the size says (then it is no such tag).
    """
    half = tag_size / 2.0
    square = np.array([[-half, half, 0.0], [half, half, 0.0], [half, -half, 0.0], [-half, -half, 0.0]])
    problem = _Problem(header, corners, square, depth, up_in_camera)
    starts = _ippe(header, corners, square)
    solutions = [found for start in starts if (found := _refine(problem, *start)) is not None]
    if not solutions:
        return None
    best = min(solutions, key=lambda each: each.cost)
    gap = _gap(best, depth)
    distance = float(np.linalg.norm(best.position))
    if gap is not None and abs(gap) > 0.03 + 0.1 * distance:
        return None
    facing = float(-best.rotation[:, 2] @ best.position) / distance
    if facing <= 0.0:
        return None
    return Estimate(
        tag_in_camera=pose_of(best.rotation, best.position),
        position_sigma=float(np.sqrt(np.trace(best.covariance[3:6, 3:6]))),
        yaw_sigma=float(np.sqrt(best.covariance[1, 1])),
        pixel_error=float(np.sqrt(np.mean(np.sum(_misses(problem, best.rotation, best.position) ** 2, 1)))),
        viewing_angle=math.acos(min(facing, 1.0)),
        depth_gap=gap,
        upright=best.upright,
    )


def _ippe(header: RgbdHeader, corners: Matrix, square: Matrix) -> list[tuple[Matrix, Matrix]]:
    """Return the two poses, as rotation and position."""
    intrinsics = np.array([[header.fx, 0, header.cx], [0, header.fy, header.cy], [0, 0, 1.0]])
    try:
        _, turns, shifts, _ = cv2.solvePnPGeneric(
            square, corners.reshape(4, 1, 2), intrinsics, np.zeros(4), flags=cv2.SOLVEPNP_IPPE_SQUARE
        )
    except cv2.error:
        return []
    poses = [
        (np.asarray(cv2.Rodrigues(r)[0], np.float64), np.asarray(t, np.float64).reshape(3))
        for r, t in zip(turns, shifts, strict=True)
    ]
    return [each for each in poses if np.all(np.isfinite(each[1])) and each[1][2] > 0.05]  # noqa: PLR2004


def _misses(problem: _Problem, rotation: Matrix, position: Matrix) -> Matrix:
    """Return (4, 2) pixels from the corners found to the corners of the pose."""
    seen = problem.square @ rotation.T + position
    head = problem.header
    shown = np.stack(
        (head.fx * seen[:, 0] / seen[:, 2] + head.cx, head.fy * seen[:, 1] / seen[:, 2] + head.cy), 1
    )
    return np.asarray(shown - problem.corners, np.float64)


def _refine(problem: _Problem, rotation: Matrix, position: Matrix) -> _Solution | None:
    """Gauss-Newton over turn (in the tag's frame), shift and the depth's offset: seven unknowns."""
    upright = problem.up is not None and _tilt(problem.up, rotation) < _UPRIGHT_LIMIT
    offset, normal = 0.0, np.eye(7)
    cost = math.inf
    for _ in range(_ROUNDS):
        residuals, slopes = _rows(problem, rotation, position, offset, upright=upright)
        normal = slopes.T @ slopes + 1e-9 * np.eye(7)
        cost = float(residuals @ residuals)
        step: Matrix = -np.asarray(np.linalg.solve(normal, slopes.T @ residuals), np.float64)
        rotation = rotation @ rotation_about(step[:3])
        position, offset = position + step[3:6], offset + float(step[6])
        if position[2] < 0.05 or not np.all(np.isfinite(position)):  # noqa: PLR2004
            return None
        if float(np.abs(step).max()) < 1e-7:  # noqa: PLR2004
            break
    if problem.up is not None and not upright:
        cost += _TILTED_COST
    return _Solution(rotation, position, np.asarray(np.linalg.inv(normal), np.float64), cost, upright)


def _rows(
    problem: _Problem, rotation: Matrix, position: Matrix, offset: float, *, upright: bool
) -> tuple[Matrix, Matrix]:
    """Return the residuals in sigmas, and their slopes by the seven unknowns."""
    residuals, slopes = _corner_rows(problem, rotation, position)
    all_residuals, all_slopes = [residuals, np.array([offset / _DEPTH_BIAS])], [slopes, np.zeros((1, 7))]
    all_slopes[1][0, 6] = 1.0 / _DEPTH_BIAS
    if upright and problem.up is not None:
        # The tag's x and z are level: their products with up are zero.
        local_up = rotation.T @ problem.up
        rows = np.zeros((2, 7))
        rows[:, :3] = skew(local_up)[[0, 2]] / _UPRIGHT_SIGMA
        all_residuals.append(local_up[[0, 2]] / _UPRIGHT_SIGMA)
        all_slopes.append(rows)
    if problem.depth is not None and len(problem.depth.points) > 0:
        residuals, slopes = _depth_rows(problem.depth, rotation, position, offset)
        all_residuals.append(residuals)
        all_slopes.append(slopes)
    return np.concatenate(all_residuals), np.concatenate(all_slopes)


def _corner_rows(problem: _Problem, rotation: Matrix, position: Matrix) -> tuple[Matrix, Matrix]:
    seen = problem.square @ rotation.T + position
    head = problem.header
    slopes = np.zeros((8, 7))
    for i, (x, y, z) in enumerate(seen):
        by_point = np.array(
            [[head.fx / z, 0.0, -head.fx * x / z**2], [0.0, head.fy / z, -head.fy * y / z**2]]
        )
        slopes[2 * i : 2 * i + 2, :3] = -by_point @ rotation @ skew(problem.square[i])
        slopes[2 * i : 2 * i + 2, 3:6] = by_point
    return _misses(problem, rotation, position).ravel() / _CORNER_SIGMA, slopes / _CORNER_SIGMA


def _depth_rows(
    depth: DepthPoints, rotation: Matrix, position: Matrix, offset: float
) -> tuple[Matrix, Matrix]:
    """Depth along the ray through each point: where the plane would be against what was measured."""
    points, normal = depth.points, rotation[:, 2]
    rays = points / points[:, 2:3]
    along = rays @ normal
    along = np.where(np.abs(along) < 0.05, np.copysign(0.05, along), along)  # noqa: PLR2004
    plane = (normal @ position) / along
    gaps = plane + offset - points[:, 2]
    kept = (
        np.abs(gaps - np.median(gaps)) < _OUTLIER * depth_image.sigma(float(np.median(points[:, 2]))) + 0.002
    )
    each = depth_image.sigma(float(np.median(points[:, 2])))
    # The points stand for all pixels, and neighbours are not independent.
    weight = 1.0 / (each * math.sqrt(max(len(points) * _NEIGHBOURS / max(depth.pixels, 1), 1.0)))
    slopes = np.zeros((len(points), 7))
    # d plane = (dn . (p - plane * ray) + n . dp) / (n . ray), with dn = R (w x e_z).
    lever = (position - plane[:, None] * rays) / along[:, None]
    slopes[:, :3] = np.stack(
        (-(lever @ rotation[:, 1]), lever @ rotation[:, 0], np.zeros(len(points))), axis=1
    )
    slopes[:, 3:6] = normal / along[:, None]
    slopes[:, 6] = 1.0
    return gaps[kept] * weight, slopes[kept] * weight


def _tilt(up: Matrix, rotation: Matrix) -> float:
    return math.acos(float(np.clip(up @ rotation[:, 1], -1.0, 1.0)))


def _gap(solution: _Solution, depth: DepthPoints | None) -> float | None:
    if depth is None or len(depth.points) == 0:
        return None
    rays = depth.points / depth.points[:, 2:3]
    plane = (solution.rotation[:, 2] @ solution.position) / (rays @ solution.rotation[:, 2])
    return float(np.median(plane - depth.points[:, 2]))
