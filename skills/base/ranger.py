"""What one sensor of distances said last, and whether it can be trusted: it may be silent, or stuck."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import CliffSensor, RangeSensor

SILENT: Final = 3.5
"""Periods of a sensor without a reading after which it is said to be silent."""
STUCK_AFTER: Final = 30
"""Readings in a row, while the base moves, that are the same to the last digit."""
SLOWLY: Final = 0.15
"""m/s at the most while a sensor that looks ahead is deaf: what comes into its gap is met slowly."""


@dataclass
class Ranger:
    """A sensor, where it is in the base, and what it said."""

    sensor: RangeSensor | CliffSensor
    in_base: FloorPose
    said: float | None = None
    at: RobotTime | None = None
    same: int = 0
    """Readings in a row, on the way, that are the same."""

    def hear(self, said: float | None, at: RobotTime, *, moving: bool) -> None:
        """Take a reading; None: it was missing."""
        if said is not None:
            repeats = moving and said == self.said and said < self.sensor.range_max
            self.same = self.same + 1 if repeats else 0 if moving else self.same
            self.said, self.at = said, at

    def is_deaf(self, now: RobotTime | None, resting: float = 0.0) -> bool:
        """Say whether it is silent, or stuck at one distance.

        ``resting``: seconds between two readings while the robot rests; 0 while it moves, or where there is
        no difference.
        """
        age = None if now is None or self.at is None else now.since(self.at)
        period = max(self.sensor.period, resting)
        return age is None or age > SILENT * period or self.same >= STUCK_AFTER
