"""Between the ports' poses and pinocchio's SE3, 4x4 matrices and numpy."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.ports.pose import Pose

Array = npt.NDArray[np.float64]
"""Floats of any shape; a function says which."""


def to_se3(pose: Pose) -> pin.SE3:
    """Return the pose as pinocchio's SE3."""
    x, y, z, w = pose.orientation
    return pin.SE3(pin.Quaternion(w, x, y, z).toRotationMatrix(), np.asarray(pose.position))


def to_pose(placement: pin.SE3) -> Pose:
    """Return pinocchio's SE3 as a pose."""
    quaternion = pin.Quaternion(placement.rotation).normalized()
    x, y, z = (float(part) for part in placement.translation)
    return Pose(
        position=(x, y, z),
        orientation=(float(quaternion.x), float(quaternion.y), float(quaternion.z), float(quaternion.w)),
    )


def interpolate(a: Pose, b: Pose, fraction: float) -> Pose:
    """Return the pose on the straight line from a to b, turning at a constant rate (slerp)."""
    start, end = to_se3(a), to_se3(b)
    turn = pin.log3(start.rotation.T @ end.rotation)
    rotation = start.rotation @ pin.exp3(turn * fraction)
    return to_pose(pin.SE3(rotation, (1.0 - fraction) * start.translation + fraction * end.translation))


def rotation_vector(from_turn: Array, to_turn: Array) -> Array:
    """Return the rotation vector (3,), in the base's axes, from one rotation matrix (3, 3) to another."""
    return np.asarray(pin.log3(to_turn @ from_turn.T))
