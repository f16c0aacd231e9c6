"""A laser scan as points in the base's frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.base.floor import FloatArray, points_in
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import LaserScan, LaserSensor


@dataclass(frozen=True)
class ScanPoints:
    """What the beams hit: ``in_base`` of shape (n, 2) and ``ranges`` of shape (n,), in metres.

    ``all_ranges`` has one entry a beam, NaN for those without a valid echo.
    """

    stamp: RobotTime
    in_base: FloatArray
    ranges: FloatArray
    all_ranges: FloatArray


@dataclass(frozen=True)
class ScanGeometry:
    """The beams' directions in the laser's frame, and where the laser is."""

    sensor: LaserSensor
    laser_in_base: FloorPose

    def points(self, scan: LaserScan) -> ScanPoints | None:
        """Return the scan's points, or None when it has not as many beams as the sensor."""
        if len(scan.ranges) != self.sensor.beams:
            return None
        ranges = np.array(scan.ranges)
        seen = (ranges > self.sensor.range_min) & (ranges < self.sensor.range_max)
        angles = self.sensor.angle_min + self.sensor.angle_step * np.arange(self.sensor.beams)
        kept, at = ranges[seen], angles[seen]
        in_laser = np.stack((kept * np.cos(at), kept * np.sin(at)), axis=1)
        return ScanPoints(
            stamp=scan.stamp,
            in_base=points_in(self.laser_in_base, in_laser),
            ranges=kept,
            all_ranges=np.where(seen, ranges, np.nan),
        )

    def beam_of(self, points_in_laser: FloatArray) -> FloatArray:
        """Return the (fractional) index of the beam that looks at each point, shape (n,)."""
        bearing = np.arctan2(points_in_laser[:, 1], points_in_laser[:, 0])
        return np.asarray((bearing - self.sensor.angle_min) / self.sensor.angle_step)
