"""The three clocks, handed in wherever time is needed."""

from __future__ import annotations

from typing import Protocol

from tandem.skills.ports.message import RobotTime


class Clocks(Protocol):
    """Robot time for motion, monotonic host time for links, UTC for what is stored."""

    def robot(self) -> RobotTime | None:
        """Return the hardware's last time, or None while no hardware has been heard."""
        ...

    def passed(self) -> float:
        """Return the robot seconds that have passed so far, counted on when the hardware starts anew.

        It never falls, and stands while no hardware is heard: timers read this.
        """
        ...

    def monotonic(self) -> float:
        """Return seconds of the host's monotonic clock (in lockstep: simulated seconds)."""
        ...

    def utc(self) -> float:
        """Return seconds since 1970 (in lockstep: simulated seconds)."""
        ...


def robot_seconds(clocks: Clocks) -> float:
    """Return a timer's reading (see ``Clocks.passed``); it can't be compared to a stamp."""
    return clocks.passed()
