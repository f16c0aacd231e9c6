"""What whoever drives needs of a monitor of the robot's pose, whatever sensor that has."""

from __future__ import annotations

from typing import Final, Protocol

from tandem.skills.base.floor import compose
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose

AT_REST: Final = (0.005, 0.01)
"""m/s and rad/s below which the base counts as at rest."""


class Whereabouts(Protocol):
    """A monitor of the robot's pose: by laser and map, or by a pose sensor."""

    @property
    def odometry(self) -> Odometry | None:
        """The newest odometry."""
        ...

    @property
    def odom_in_map(self) -> FloorPose:
        """The drift of odometry, as believed now."""
        ...

    @property
    def moving(self) -> bool:
        """Whether the wheels turn."""
        ...

    @property
    def taken_in(self) -> RobotTime | None:
        """When the newest scan was taken by which ``odom_in_map`` was judged; None if one says little."""
        ...

    @property
    def localised(self) -> bool:
        """Whether the robot knows where it is."""
        ...

    @property
    def reason(self) -> str:
        """Why not, in words."""
        ...

    def silence(self, now: RobotTime, where: str) -> Failure | None:
        """Return the failure of a sensor of the pose that is silent, or None."""
        ...


def base_in_map(monitor: Whereabouts) -> FloorPose:
    """Return where the base is, as of the newest odometry; the map's origin before any."""
    odometry = monitor.odometry
    return monitor.odom_in_map if odometry is None else compose(monitor.odom_in_map, odometry.base_in_odom)


def wheels_turn(odometry: Odometry | None) -> bool:
    """Say whether the base moves, as its wheels tell."""
    return odometry is not None and (abs(odometry.linear) > AT_REST[0] or abs(odometry.angular) > AT_REST[1])
