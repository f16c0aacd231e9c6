"""The three clocks, handed in wherever time is needed."""

from __future__ import annotations

from typing import Protocol

from skills.ports.message import RobotTime


class Clocks(Protocol):
    """Robot time for motion, monotonic host time for links, UTC for what is stored."""

    def robot(self) -> RobotTime | None:
        """Return the hardware's last time, or None while no hardware has been heard."""
        ...

    def monotonic(self) -> float:
        """Return seconds of the host's monotonic clock (in lockstep: simulated seconds)."""
        ...

    def utc(self) -> float:
        """Return seconds since 1970 (in lockstep: simulated seconds)."""
        ...


def robot_seconds(clocks: Clocks) -> float:
    """Return the seconds of the robot's clock, 0.0 before the hardware was heard."""
    now = clocks.robot()
    return 0.0 if now is None else now.seconds
