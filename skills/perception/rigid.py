"""Poses as numpy arrays and back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose

Matrix = NDArray[np.float64]


def rotation_of(pose: Pose) -> Matrix:
    """Return the pose's 3x3 rotation matrix."""
    x, y, z, w = pose.orientation
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def pose_of(rotation: Matrix, position: Matrix) -> Pose:
    """Return a pose from a 3x3 rotation and a position."""
    axes = [triple(rotation[:, i]) for i in range(3)]
    return Pose(position=triple(position), orientation=from_axes(axes[0], axes[1], axes[2]))


def triple(vector: Matrix) -> Vector3:
    """Return an array of three as plain floats."""
    return (float(vector[0]), float(vector[1]), float(vector[2]))


def skew(vector: Matrix) -> Matrix:
    """Return the matrix whose product with v is the cross product of ``vector`` and v."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation_about(vector: Matrix) -> Matrix:
    """Return the rotation about ``vector`` by its length in radians (Rodrigues)."""
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:  # noqa: PLR2004
        return np.eye(3)
    k = skew(vector / angle)
    return np.asarray(np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k), np.float64)


def points_in(pose: Pose, points: Matrix) -> Matrix:
    """Return (n, 3) points of the pose's own frame in the frame that it is told in."""
    return np.asarray(points @ rotation_of(pose).T + np.array(pose.position), np.float64)


def points_from(pose: Pose, points: Matrix) -> Matrix:
    """Return (n, 3) points of the outer frame in the pose's own frame."""
    return np.asarray((points - np.array(pose.position)) @ rotation_of(pose), np.float64)
