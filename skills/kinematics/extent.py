"""How far a group reaches out over the floor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import coal
import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.bodies import BoxShape, Carried, CellsShape
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array, to_se3


class Extent:
    """The farthest point, in plan, of the links that move with some joints.

    Args:
        hulls: the robot's bodies.
        joints: those of the group.
    """

    def __init__(self, hulls: RobotHulls, joints: Sequence[str]) -> None:
        self._robot = hulls.robot
        model = hulls.robot.model
        first = {hulls.robot.joint_index(joint) + 1 for joint in joints}
        moving = [i for i in range(model.njoints) if first & set(model.supports[i])]
        self._data = model.createData()
        self._bodies = [
            (int(body.parentJoint), _homogeneous(body.placement, _corners(body.geometry)))
            for body in hulls.geometry.geometryObjects
            if body.parentJoint in moving
        ]

    def metres(self, positions: Mapping[str, float], carried: Sequence[Carried] = ()) -> float:
        """Return the distance in plan from the base's axis, with what is carried."""
        model, data = self._robot.model, self._data
        pin.forwardKinematics(model, data, self._robot.configuration(positions))
        farthest = 0.0
        for joint, points in self._bodies:
            farthest = max(farthest, _reach(data.oMi[joint].homogeneous @ points))
        for each in carried:
            frame = model.frames[self._robot.frame_index(each.link)]
            size = each.shape.size if isinstance(each.shape, BoxShape | CellsShape) else (
                2 * each.shape.radius, 2 * each.shape.radius, each.shape.length
            )  # fmt: skip
            points = _homogeneous(frame.placement * to_se3(each.pose_in_link), _box(np.array(size) / 2.0))
            farthest = max(farthest, _reach(data.oMi[frame.parentJoint].homogeneous @ points))
        return farthest


def _reach(points: Array) -> float:
    return float(np.sqrt(np.max(points[0] ** 2 + points[1] ** 2)))


def _homogeneous(placement: pin.SE3, points: Array) -> Array:
    return np.asarray(placement.homogeneous @ np.vstack((points.T, np.ones(len(points)))))


def _corners(geometry: coal.CollisionGeometry) -> Array:
    if isinstance(geometry, coal.ConvexBase):
        return np.array(geometry.points()).copy()
    geometry.computeLocalAABB()
    box = geometry.aabb_local
    low, high = np.array(box.min_), np.array(box.max_)
    return np.asarray(_box((high - low) / 2.0) + (high + low) / 2.0)


def _box(half: Array) -> Array:
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    return np.asarray(signs * half)
