"""Clocks: of a process that hears the hardware's clock, and of lockstep."""

from __future__ import annotations

import time

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, Latest
from tandem.skills.ports.message import RobotTime, RobotTimer


class ProcessClocks:
    """Robot time as last heard from the hardware; host times from the host."""

    def __init__(self, bus: Bus) -> None:
        """Subscribe to the hardware's clock."""
        self._clock = Latest(bus, CLOCK, depth=1024)
        self._timer = RobotTimer(0.0)

    def refresh(self) -> Clock | None:
        """Take in what the hardware's clock said; return the newest tick if it is new. No other is read."""
        last, tick = self._clock.value, self._clock.refresh()
        if tick is None or tick is last:
            return None
        self._timer.read(tick.stamp)
        return tick

    def close(self) -> None:
        """Hear the hardware's clock no longer."""
        self._clock.close()

    def robot(self) -> RobotTime | None:
        """Return the hardware's last time, or None before it was heard."""
        return None if self._clock.value is None else self._clock.value.stamp

    def passed(self) -> float:
        """Return the robot seconds that have passed since the hardware was first heard."""
        return self._timer.reading

    def monotonic(self) -> float:
        """Return seconds of the host's monotonic clock."""
        return time.monotonic()

    def utc(self) -> float:
        """Return seconds since 1970."""
        return time.time()


class HostClocks:
    """The host's clocks, for who hears the robot's in another way; robot time is not known here."""

    def robot(self) -> RobotTime | None:
        """Return None."""
        return None

    def passed(self) -> float:
        """Return 0: no robot time passes here."""
        return 0.0

    def monotonic(self) -> float:
        """Return seconds of the host's monotonic clock."""
        return time.monotonic()

    def utc(self) -> float:
        """Return seconds since 1970."""
        return time.time()


class SteppedClocks:
    """All three clocks count the simulated time that ``advance`` adds: lockstep, and tests."""

    def __init__(self, boot: str = "lockstep") -> None:
        """Start at zero."""
        self.boot = boot
        self.seconds = 0.0
        self.wall = 0.0
        """Seconds by which the wall clock is wrong."""
        self._booted_at = 0.0
        self._unheard: float | None = None
        self._told: tuple[str, float] | None = None
        self._now: RobotTime | None = None

    def advance(self, seconds: float, *, heard: bool = True) -> None:
        """Let time pass; while the hardware is not ``heard``, its own clock seems to stand."""
        if heard:
            self._unheard = None
        elif self._unheard is None:
            self._unheard = self.seconds
        self.seconds = round(self.seconds + seconds, 9)

    def reboot(self, boot: str) -> None:
        """Count the robot's time from zero, under another boot: its hardware has started anew."""
        self.boot, self._booted_at, self._unheard = boot, self.seconds, None

    def robot(self) -> RobotTime | None:
        """Return the simulated time since the boot, or that at which the hardware was last heard."""
        told = self.boot, round(self.passed() - self._booted_at, 9)
        if told != self._told:  # all nodes of a step ask for the same one
            self._told, self._now = told, RobotTime(boot=told[0], seconds=told[1])
        return self._now

    def passed(self) -> float:
        """Return the simulated seconds during which the hardware was heard, or could have been."""
        return self.seconds if self._unheard is None else self._unheard

    def monotonic(self) -> float:
        """Return the simulated seconds."""
        return self.seconds

    def utc(self) -> float:
        """Return the simulated seconds, and what the wall clock is wrong by."""
        return self.seconds + self.wall
