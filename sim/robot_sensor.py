"""A sensor for other robots: those in its field and range that nothing hides."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.sim.physics import Group
from tandem.sim.pose_sensor import floor_pose
from tandem.skills.ports.sensors import SeenRobot

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.pose import FloorPose
    from tandem.skills.ports.sensors import RobotSensor

HALF_WIDTH: Final = 0.2
"""Metres: half of what a robot hides of who is behind it; between that of a P3-DX and of a SUMMIT-XL."""


class RobotFinder:
    """Tells which robots the sensor sees now, and where.

    Args:
        robot: whose frame the sensor's is.
        sensor: its field and range.
        others: returns the other robots' bases in map, by name.
    """

    def __init__(
        self, robot: RobotBody, sensor: RobotSensor, *, others: Callable[[], Mapping[str, FloorPose]]
    ) -> None:
        self._robot = robot
        self.sensor = sensor
        self._others = others

    def measure(self) -> tuple[SeenRobot, ...]:
        """Return the robots seen, by name, in the base's frame (m).

        A robot counts by its base's axis: it is seen when that is in the field and in range, and no
        furniture, thing or robot is in the way to it at the sensor's height.
        """
        others, base = self._others(), floor_pose(self._robot)
        c, s = math.cos(base.yaw), math.sin(base.yaw)
        seen = []
        for name, at in sorted(others.items()):
            if self._sees(at, [other for each, other in others.items() if each != name]):
                dx, dy = at.x - base.x, at.y - base.y
                seen.append(SeenRobot(name=name, x=round(c * dx + s * dy, 4), y=round(c * dy - s * dx, 4)))
        return tuple(seen)

    def _sees(self, at: FloorPose, others: Sequence[FloorPose]) -> bool:
        pose = self._robot.frame_matrix(self.sensor.frame)
        origin = pose[:3, 3]
        towards = np.array([at.x - origin[0], at.y - origin[1], 0.0])
        distance = float(np.hypot(towards[0], towards[1]))
        if distance > self.sensor.range_max:
            return False
        ahead, left, _ = pose[:3, :3].T @ towards
        if abs(math.atan2(left, ahead)) > self.sensor.field / 2.0:
            return False
        eye = (float(origin[0]), float(origin[1]))
        if any(_hides(other, eye, at) for other in others):
            return False
        hides = Group.THING | Group.FIXED
        (free,) = self._robot.physics.cast([origin.tolist()], [(origin + towards).tolist()], hides)
        return free >= 1.0


def _hides(other: FloorPose, eye: tuple[float, float], at: FloorPose) -> bool:
    """Say whether a robot stands between an eye and a place: nearer, and across the line between them."""
    x, y, distance = at.x - eye[0], at.y - eye[1], math.hypot(at.x - eye[0], at.y - eye[1])
    along = ((other.x - eye[0]) * x + (other.y - eye[1]) * y) / max(distance, 1e-9)
    aside = ((other.y - eye[1]) * x - (other.x - eye[0]) * y) / max(distance, 1e-9)
    return 0.0 < along < distance and abs(aside) < HALF_WIDTH
