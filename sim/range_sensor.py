"""A sonar, or another sensor that tells the distance to the nearest thing in a cone: a bundle of rays."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.sensors import RangeSensor

STEP: Final = math.radians(2.5)
"""Between two rays of a row: 9 cm at 2 m, the thickness of a thin post. Finer costs time: sixteen sonars
cast about 500 rays as it is."""
ROWS: Final = (-0.5, 0.0, 0.5)
"""Where the rows of rays are, as shares of the half opening above the axis."""
FLOOR: Final = 0.005
"""Metres above the floor at which rays end: what grazes it gives no echo."""


class RangeFinder:
    """Measures with one sensor, in the physics as it was after its last step.

    Args:
        robot: whose frame the sensor's is, and whose parts are not seen.
        sensor: its cone and ranges.
        sigma: standard deviation in metres of a range that is measured.
        rng: source of the noise; one draw a measurement, whatever is seen.
    """

    def __init__(
        self, robot: RobotBody, sensor: RangeSensor, *, sigma: float, rng: np.random.Generator
    ) -> None:
        self._robot = robot
        self.sensor = sensor
        self._sigma = sigma
        self._rng = rng
        self._directions = _cone(sensor.cone / 2.0)

    def measure(self) -> float:
        """Return the distance in metres to the nearest thing in the cone; ``range_max`` when there is none.

        What is nearer than ``range_min`` reads as ``range_min``.
        """
        true, least, most = self._nearest(), self.sensor.range_min, self.sensor.range_max
        noisy = true + float(self._rng.normal(0.0, 1.0)) * self._sigma
        return most if true >= most else round(min(max(noisy, least), most), 4)

    def _nearest(self) -> float:
        pose = self._robot.frame_matrix(self.sensor.frame)
        directions, origin = self._directions @ pose[:3, :3].T, pose[:3, 3]
        lengths = np.full(len(directions), self.sensor.range_max)
        down = directions[:, 2] < -1e-9
        lengths[down] = np.minimum(lengths[down], (FLOOR - origin[2]) / directions[down, 2])
        ends = origin + lengths[:, None] * directions
        free = np.array(
            self._robot.physics.cast([origin.tolist()] * len(ends), ends.tolist(), self._robot.seen)
        )
        return float(np.min(np.where(free < 1.0, free * lengths, self.sensor.range_max)))


def _cone(half: float) -> NDArray[np.float64]:
    """Return directions that fill a cone about x, from its axis to its rim, a unit vector a row."""
    rays: list[tuple[float, float, float]] = []
    for row in ROWS:
        up = row * half
        out = half * math.sqrt(1.0 - row * row)
        count = 2 * math.ceil(out / STEP) + 1
        rays += [
            (math.cos(up) * math.cos(turn), math.cos(up) * math.sin(turn), math.sin(up))
            for turn in np.linspace(-out, out, count)
        ]
    return np.array(rays)
