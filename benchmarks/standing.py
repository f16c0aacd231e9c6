"""How a robot comes to rest: read off its joints, its odometry, and what its base is told."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import BaseVelocity, JointStates, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, JOINT_STATES, ODOMETRY, Latest
from tandem.skills.ports.robot_description import RobotDescription

MOVING: Final = 0.2
"""rad/s from which a joint is followed to see it slow down."""
LONG: Final = 0.05
"""Seconds to standstill, as stated, from which coming to rest is timed."""
STILL: Final = 0.02
"""rad/s or m/s of a joint, m/s or rad/s of the base: slower is standing."""
BRAKED: Final = 0.98
"""Share of its speed at which something has become slower."""


class Motion:
    """What moves, and since when it brakes; ``mark`` says from when on that counts.

    Args:
        bus: where the robot is.
        description: its limits.
    """

    def __init__(self, bus: Bus, description: RobotDescription) -> None:
        self._drive = description.driven
        self._limits = {
            each.joint: each.acceleration for group in description.groups for each in group.limits
        }
        self._joints = Latest(bus, JOINT_STATES, depth=1024)
        self._odometry = Latest(bus, ODOMETRY, depth=1024)
        self._commands = Latest(bus, BASE_VELOCITY, depth=1024)
        self._speeds: dict[str, float] = {}
        self._base = (0.0, 0.0)
        self._told, self._slowing = 0.0, False
        self._now = self._marked_at = 0.0
        self._stated = self._fastest = 0.0
        self._stands_at: float | None = None
        self._followed = False
        self.braked_at: float | None = None
        """Host seconds when the base, not slowing down before, was first told to since the mark."""
        self.slower_at: float | None = None
        """Host seconds when the fastest joint was first slower since the mark; None if none was fast."""

    @property
    def fast(self) -> bool:
        """Whether coming to rest takes long enough to be timed."""
        return self._time_to_rest() >= LONG

    @property
    def stands(self) -> bool:
        """Whether the robot has stood still since the mark."""
        return self._stands_at is not None

    @property
    def longer(self) -> float | None:
        """Robot seconds from the mark to standing beyond the stated; None for a robot that hardly moved."""
        if self._stands_at is None or self._stated < LONG:
            return None
        return self._stands_at - self._marked_at - self._stated

    def mark(self) -> None:
        """Begin to watch how it comes to rest."""
        self._stated = self._time_to_rest()
        self._marked_at, self._fastest = self._now, max(self._speeds.values(), default=0.0)
        self._followed = self._told > 0.0 and not self._slowing
        self._stands_at = self.braked_at = self.slower_at = None

    def look(self, now: float) -> None:
        """Take in what has come until ``now`` (host seconds)."""
        for command in self._commands.take():
            self._hear(command, now)
        for odometry in self._odometry.take():
            self._base = _speeds(odometry)
        for states in self._joints.take():
            self._see(states, now)

    def _time_to_rest(self) -> float:
        """Return the seconds that the last one to stand takes at its stated deceleration."""
        drive = self._drive
        base = zip(self._base, (drive.acceleration, drive.turn_acceleration), strict=True)
        joints = ((speed, self._limits[joint]) for joint, speed in self._speeds.items())
        return max((abs(speed) - STILL) / limit for speed, limit in (*base, *joints))

    def _hear(self, command: BaseVelocity, now: float) -> None:
        before, self._told = self._told, abs(command.linear) + abs(command.angular)
        slowing = self._told < before
        if self._followed and self.braked_at is None and slowing:
            self.braked_at = now
        self._slowing = slowing

    def _see(self, states: JointStates, now: float) -> None:
        self._now = states.stamp.seconds
        named = zip(states.names, states.velocities, strict=True)
        self._speeds = {joint: abs(speed) for joint, speed in named if joint in self._limits}
        fastest = max(self._speeds.values(), default=0.0)
        self._fastest = max(self._fastest, fastest)
        if self.slower_at is None and self._fastest > MOVING and fastest < BRAKED * self._fastest:
            self.slower_at = now
        if self._stands_at is None and fastest < STILL and max(map(abs, self._base)) < STILL:
            self._stands_at = self._now


def _speeds(odometry: Odometry) -> tuple[float, float]:
    return odometry.linear, odometry.angular
