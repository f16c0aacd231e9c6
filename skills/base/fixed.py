"""Tells where a robot is whose base is fixed: where its site says that it is at home."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.world import ROBOT_POSE, RobotPose

PERIOD: Final = 0.05
"""Robot seconds between two messages: as often as a base that drives tells it."""


class FixedBase:
    """Publishes ``world/robot``; a ``Node``.

    Args:
        bus: where skills and trees are.
        clocks: robot time.
        home: where the base stands in the map.
    """

    name: Final = "base/fixed"

    def __init__(self, bus: Bus, clocks: Clocks, home: FloorPose) -> None:
        self._bus, self._clocks, self._home = bus, clocks, home
        self._told_at = float("-inf")

    def step(self) -> bool:
        """Tell, if it is time."""
        stamp, now = self._clocks.robot(), robot_seconds(self._clocks)
        if stamp is None or now - self._told_at < PERIOD - 1e-6:
            return False
        self._told_at = now
        pose = RobotPose(
            stamp=stamp,
            localised=True,
            base_in_map=self._home,
            odom_in_map=self._home,
            position_sigma=0.0,
            yaw_sigma=0.0,
            moving=False,
        )
        ROBOT_POSE.publish(self._bus, pose)
        return False

    def close(self) -> None:
        """Close nothing: it hears nobody."""
