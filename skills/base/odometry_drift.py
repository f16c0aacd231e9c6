"""The drift of odometry, which each monitor of the robot's pose follows with the sensor that it has."""

from __future__ import annotations

from tandem.skills.base.floor import ORIGIN
from tandem.skills.base.odometry import OdometryBuffer
from tandem.skills.base.whereabouts import wheels_turn
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose


class OdometryDrift:
    """Holds the last odometry, and odom in map as its monitor corrects it. See ``Whereabouts``."""

    def __init__(self) -> None:
        """Without odometry, and without drift."""
        self._buffer = OdometryBuffer()
        self._odom_in_map = ORIGIN
        self.taken_in: RobotTime | None = None
        """When the newest scan was taken by which ``odom_in_map`` was judged; None if one says little."""

    @property
    def odometry(self) -> Odometry | None:
        """The newest odometry."""
        return self._buffer.last

    @property
    def odom_in_map(self) -> FloorPose:
        """The drift of odometry, as believed now."""
        return self._odom_in_map

    @property
    def moving(self) -> bool:
        """Whether the wheels turn."""
        return wheels_turn(self._buffer.last)
