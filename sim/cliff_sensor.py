"""A cliff sensor: one short ray straight down, to the floor or to where it should be."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.sensors import CliffSensor

FLICKER: Final = 0.0005
"""Standard deviation in metres, in every scenario: what an infrared sensor reads is never twice the same. One
that repeats itself is taken to be stuck (``skills/base/ranger.py``)."""


class CliffFinder:
    """Measures with one sensor, in the physics as it was after its last step.

    Args:
        robot: whose frame the sensor's is, and whose parts are not seen.
        sensor: its frame and its range.
        rng: source of the flicker; one draw a measurement.
    """

    def __init__(self, robot: RobotBody, sensor: CliffSensor, *, rng: np.random.Generator) -> None:
        self._robot, self.sensor, self._rng = robot, sensor, rng

    def measure(self) -> float:
        """Return the distance in metres to what is below; ``range_max`` when nothing is within reach."""
        pose, most = self._robot.frame_matrix(self.sensor.frame), self.sensor.range_max
        origin, end = pose[:3, 3], pose[:3, 3] + most * pose[:3, 0]
        (free,) = self._robot.physics.cast([origin.tolist()], [end.tolist()], self._robot.seen)
        noisy = free * most + float(self._rng.normal(0.0, 1.0)) * FLICKER
        return most if free >= 1.0 else round(min(max(noisy, 0.0), most), 5)
