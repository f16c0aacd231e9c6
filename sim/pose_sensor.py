"""Motion capture: where the base truly is, with the errors that the sensor's maker states."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

if TYPE_CHECKING:
    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.sensors import PoseSensor


class PoseFinder:
    """Tells the base's place in map.

    Args:
        robot: whose base it is.
        sensor: its errors, of x, of y and of the heading.
        rng: source of the errors; three draws a reading.
    """

    def __init__(self, robot: RobotBody, sensor: PoseSensor, *, rng: np.random.Generator) -> None:
        self._robot = robot
        self.sensor = sensor
        self._rng = rng

    def measure(self) -> FloorPose:
        """Return the base in map: metres and rad."""
        true = floor_pose(self._robot)
        dx, dy, dyaw = (float(each) for each in self._rng.normal(0.0, 1.0, 3))
        return FloorPose(
            x=true.x + dx * self.sensor.position_sigma,
            y=true.y + dy * self.sensor.position_sigma,
            yaw=wrap(true.yaw + dyaw * self.sensor.yaw_sigma),
        )


def floor_pose(robot: RobotBody) -> FloorPose:
    """Return where a robot's base truly is in map."""
    (x, y, _), orientation = robot.base_pose()
    return FloorPose(x=x, y=y, yaw=wrap(2.0 * math.atan2(orientation[2], orientation[3])))
