"""Where a robot with a pose sensor is: odometry predicts, each reading corrects. Owner of ``world/robot``.

The drift of odometry, odom in map, is followed with a first-order filter: a reading is off by the sensor's
noise and odometry by next to nothing between two readings, so most of what is known is kept. The share that a
reading counts is that of a Kalman filter in its steady state, for the sensor's noise and the drift of wheels.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.base.floor import compose, invert
from tandem.skills.base.odometry import ahead
from tandem.skills.base.odometry_drift import OdometryDrift
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import ODOMETRY, POSE_READING, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import PoseReading
from tandem.skills.ports.world import ROBOT_POSE, RobotPose

PERIOD: Final = 0.05
"""Robot seconds between two messages."""
SILENCE: Final = 0.5
"""Robot seconds without a reading after which the base does not move."""
GAIN: Final = 0.18
"""Share of a reading: wheels that slip drift by some 2 mm in a period of 0.05 s, the sensor is off by 10 mm;
the steady-state gain of a Kalman filter for that ratio r = 0.2 is (sqrt(r^4 + 4 r^2) - r^2) / 2 = 0.18."""
LEAP: Final = 0.5
"""Metres by which a reading is beyond noise: the robot was carried, and is where the sensor says."""


class PoseTracker(OdometryDrift):
    """The monitor of the pose; a ``Node``.

    Args:
        bus: where odometry and readings come from and the pose goes to.
        clocks: robot time.
        description: the pose sensor; its first counts.
    """

    name: Final = "base/tracker"

    def __init__(self, bus: Bus, clocks: Clocks, description: RobotDescription) -> None:
        super().__init__()
        self._bus, self._clocks = bus, clocks
        self._sensor = description.pose_sensors[0]
        self._odometry_in, self._readings_in = Latest(bus, ODOMETRY), Latest(bus, POSE_READING, depth=8)
        self._heard: RobotTime | None = None
        self._published_at = -math.inf

    @property
    def localised(self) -> bool:
        """Whether a reading has come."""
        return self._heard is not None

    @property
    def reason(self) -> str:
        """Why not."""
        return "" if self.localised else f"pose sensor {self._sensor.name!r} has not been heard"

    def silence(self, now: RobotTime, where: str) -> Failure | None:
        """Return NOT_LOCALISED when the pose sensor has been silent for too long, or None."""
        silent = None if self._heard is None else now.since(self._heard)
        if silent is not None and silent <= SILENCE:
            return None
        said = self.reason or f"no reading of pose sensor {self._sensor.name!r} for {silent or 0.0:.1f} s"
        return Failure(kind=FailureKind.NOT_LOCALISED, message=said, where=where)

    def step(self) -> bool:
        """Take odometry and readings; publish when it is time."""
        for odometry in self._odometry_in.take():
            last = self._buffer.last
            if last is not None and odometry.stamp.since(last.stamp) is None:
                self._heard = None  # another boot
            self._buffer.add(odometry)
        for reading in self._readings_in.take():
            if reading.sensor == self._sensor.name:
                self._correct(reading)
        now = robot_seconds(self._clocks)
        if now - self._published_at >= PERIOD - 1e-6:
            self._publish(now)
        return False

    def close(self) -> None:
        """End the subscriptions."""
        self._odometry_in.close()
        self._readings_in.close()

    def _correct(self, reading: PoseReading) -> None:
        base_in_odom = self._at(reading.stamp)
        if base_in_odom is None:
            return
        believed = compose(self._odom_in_map, base_in_odom)
        read = reading.base_in_map
        first = self._heard is None or floor_distance(believed, read) > LEAP
        self._heard = reading.stamp
        if first:
            corrected = read
        else:
            corrected = FloorPose(
                x=believed.x + GAIN * (read.x - believed.x),
                y=believed.y + GAIN * (read.y - believed.y),
                yaw=wrap(believed.yaw + GAIN * wrap(read.yaw - believed.yaw)),
            )
        self._odom_in_map = compose(corrected, invert(base_in_odom))

    def _at(self, stamp: RobotTime) -> FloorPose | None:
        """Return base_in_odom at a moment, a little after the newest odometry too."""
        found, last = self._buffer.at(stamp), self._buffer.last
        if found is not None or last is None:
            return found
        onward = stamp.since(last.stamp)
        return ahead(last, onward) if onward is not None and 0.0 <= onward < PERIOD else None

    def _publish(self, now: float) -> None:
        last = self._buffer.last
        if last is None or self._clocks.robot() is None:
            return
        self._published_at = now
        ROBOT_POSE.publish(
            self._bus,
            RobotPose(
                stamp=last.stamp,
                localised=self.localised,
                base_in_map=compose(self._odom_in_map, last.base_in_odom),
                odom_in_map=self._odom_in_map,
                position_sigma=self._sensor.position_sigma,
                yaw_sigma=self._sensor.yaw_sigma,
                moving=self.moving,
                reason=self.reason,
            ),
        )
