"""When a tree is ticked although nothing was heard: for its timers, on the robot's clock and the host's."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import RobotTime

TICK_PERIOD: Final = 0.05
"""Robot seconds after which the tree is ticked although nothing was heard: its timers."""
SILENT_PERIOD: Final = 0.25
"""Host seconds after which it is ticked although the robot's clock stands still."""


class TickTimer:
    """Counts from the last tick.

    Args:
        clocks: robot time, and host time for when the robot's stands still.
    """

    def __init__(self, clocks: Clocks) -> None:
        self._clocks = clocks
        self._at: RobotTime | None = None
        self._at_on_host = clocks.monotonic()

    @property
    def due(self) -> bool:
        """Whether it is time for another tick."""
        now = self._clocks.robot()
        if self._clocks.monotonic() - self._at_on_host >= SILENT_PERIOD:
            return True
        if now is None or self._at is None:
            return now is not None
        passed = now.since(self._at)
        return passed is None or passed >= TICK_PERIOD

    def begin(self) -> None:
        """Note that a tick begins now."""
        self._at, self._at_on_host = self._clocks.robot(), self._clocks.monotonic()

    @property
    def since_begun(self) -> float:
        """Host seconds since the last tick began."""
        return self._clocks.monotonic() - self._at_on_host

    def look_again(self) -> None:
        """Have another tick be due: something has changed."""
        self._at = None
