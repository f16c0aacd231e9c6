"""The base's 2D laser: rays through the physics, blind to the robot itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.sensors import LaserSensor


class Laser:
    """Casts one scan's rays at a time, into the physics as it was after its last step.

    Args:
        robot: whose frame the sensor's is, and whose parts are not seen.
        sensor: angles and ranges.
        sigma: standard deviation in metres of each range that is measured.
        rng: source of the noise; one draw a beam and scan, whatever is seen.
    """

    def __init__(
        self, robot: RobotBody, sensor: LaserSensor, *, sigma: float, rng: np.random.Generator
    ) -> None:
        self._robot = robot
        self._sensor = sensor
        self._sigma = sigma
        self._rng = rng
        angles = sensor.angle_min + sensor.angle_step * np.arange(sensor.beams)
        self._directions = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)

    def scan(self) -> tuple[float, ...]:
        """Return the ranges in metres, counter-clockwise; ``range_max`` where nothing was seen."""
        true = self._true_ranges()
        noisy = true + self._rng.normal(0.0, 1.0, len(true)) * self._sigma
        seen = true < self._sensor.range_max
        ranges = np.where(seen, np.clip(noisy, self._sensor.range_min, self._sensor.range_max), true)
        return tuple(round(float(value), 4) for value in ranges)

    def _true_ranges(self) -> NDArray[np.float64]:
        pose = self._robot.frame_matrix(self._sensor.frame)
        directions, origin = self._directions @ pose[:3, :3].T, pose[:3, 3]
        least, most = self._sensor.range_min, self._sensor.range_max
        free = np.array(
            self._robot.physics.cast(
                (origin + least * directions).tolist(),
                (origin + most * directions).tolist(),
                self._robot.seen,
            )
        )
        return np.where(free < 1.0, least + free * (most - least), most)
