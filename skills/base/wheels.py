"""Speeds for a differential drive: within its limits, and so that it stops where it should."""

from __future__ import annotations

import math
from collections.abc import Callable

from tandem.skills.pipeline import MayCommand
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.hardware import BaseVelocity, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY
from tandem.skills.ports.robot_description import Drive

CYCLE = 0.02
"""Robot seconds between two commands to the wheels: as often as odometry comes."""
LONGEST_STEP = 0.1
"""Seconds: after a longer pause the speeds change as if it had been this long."""


def stopping_speed(remaining: float, deceleration: float, latency: float) -> float:
    """Return the speed from which the base stops within ``remaining``: v latency + v2 / (2 a) = remaining.

    In metres or radians; 0 for nothing remaining. ``latency`` (s) is what passes before braking begins.
    """
    if remaining <= 0.0:
        return 0.0
    return deceleration * (math.sqrt(latency * latency + 2.0 * remaining / deceleration) - latency)


class Wheels:
    """Sends velocity commands that change no faster than the drive can.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        drive: limits.
        may: asked when a motion begins: returns what says whether it has the wheels still. Once it has not,
            nothing is sent any more.
    """

    def __init__(self, bus: Bus, clocks: Clocks, drive: Drive, may: Callable[[], MayCommand]) -> None:
        self._bus, self._clocks, self.drive, self._asked = bus, clocks, drive, may
        self._may = may()
        self._at = -math.inf
        self.linear = 0.0
        self.angular = 0.0

    @property
    def resting(self) -> bool:
        """Whether the last command was to stand still."""
        return self.linear == 0.0 and self.angular == 0.0

    def begin(self, odometry: Odometry | None) -> None:
        """Start a motion from the speeds that odometry tells; from standstill before it has told any."""
        self._may = self._asked()
        self.linear, self.angular = (0.0, 0.0) if odometry is None else (odometry.linear, odometry.angular)
        self._at = robot_seconds(self._clocks)

    def send(self, linear: float, angular: float) -> None:
        """Go on towards these speeds (m/s, rad/s) and send what is reached."""
        self.linear, self.angular = self.next_speeds(linear, angular)
        self._send()

    def brake(self) -> None:
        """Go on towards standstill, as hard as the drive may, and send what is reached."""
        span, drive = self._span(), self.drive
        self.linear = _towards(self.linear, 0.0, drive.hardest * span)
        self.angular = _towards(self.angular, 0.0, drive.turn_acceleration * span)
        self._send()

    def _send(self) -> None:
        self._at = robot_seconds(self._clocks)
        self._publish()

    def next_speeds(self, linear: float, angular: float) -> tuple[float, float]:
        """Return what would be sent now on the way to these speeds."""
        span, drive = self._span(), self.drive
        linear = min(max(linear, -drive.backward), drive.forward)
        angular = min(max(angular, -drive.turn), drive.turn)
        return (
            _towards(self.linear, linear, drive.acceleration * span),
            _towards(self.angular, angular, drive.turn_acceleration * span),
        )

    def _span(self) -> float:
        return min(max(robot_seconds(self._clocks) - self._at, 0.0), LONGEST_STEP)

    def halt(self) -> None:
        """Send standstill at once: the last resort."""
        self.linear = self.angular = 0.0
        self._publish()

    def _publish(self) -> None:
        if self._may():
            BASE_VELOCITY.publish(self._bus, BaseVelocity(linear=self.linear, angular=self.angular))


def _towards(value: float, target: float, step: float) -> float:
    return value + min(max(target - value, -step), step)
