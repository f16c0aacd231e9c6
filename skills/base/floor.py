"""Poses on the floor: composing, inverting, interpolating them; numpy for many points at once."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

ORIGIN = FloorPose(x=0.0, y=0.0, yaw=0.0)
"""Where odometry begins."""


def compose(a_in_b: FloorPose, point_in_a: FloorPose) -> FloorPose:
    """Return the pose in b of what is known in a."""
    c, s = math.cos(a_in_b.yaw), math.sin(a_in_b.yaw)
    return FloorPose(
        x=a_in_b.x + c * point_in_a.x - s * point_in_a.y,
        y=a_in_b.y + s * point_in_a.x + c * point_in_a.y,
        yaw=wrap(a_in_b.yaw + point_in_a.yaw),
    )


def invert(a_in_b: FloorPose) -> FloorPose:
    """Return b in a."""
    c, s = math.cos(a_in_b.yaw), math.sin(a_in_b.yaw)
    return FloorPose(x=-c * a_in_b.x - s * a_in_b.y, y=s * a_in_b.x - c * a_in_b.y, yaw=wrap(-a_in_b.yaw))


def between(a: FloorPose, b: FloorPose, share: float) -> FloorPose:
    """Return the pose at ``share`` of the way from a to b, turning the short way round."""
    return FloorPose(
        x=a.x + share * (b.x - a.x),
        y=a.y + share * (b.y - a.y),
        yaw=wrap(a.yaw + share * wrap(b.yaw - a.yaw)),
    )


def points_in(a_in_b: FloorPose, points_in_a: FloatArray) -> FloatArray:
    """Return the points, shape (n, 2), in b."""
    c, s = math.cos(a_in_b.yaw), math.sin(a_in_b.yaw)
    x, y = points_in_a[:, 0], points_in_a[:, 1]
    return np.stack((a_in_b.x + c * x - s * y, a_in_b.y + s * x + c * y), axis=1)
