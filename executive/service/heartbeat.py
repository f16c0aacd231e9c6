"""The executive's pulse: once a second, how long ticks took and how many tasks wait.

The executive counts, and nothing more: who makes metrics of it is another process (``executive.telemetry``),
which may die without harm.
"""

from __future__ import annotations

from bisect import bisect_left
from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.tasks import TASK_PULSE, ExecutivePulse, Times

EVERY: Final = 1.0
"""Seconds of the host between two pulses."""
BOUNDS: Final = (0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)
"""Seconds. A tick of the fetch's tree takes tenths of a millisecond; 5 ms is what no step may take."""


class Heartbeat:
    """Counts ticks, and tells.

    Args:
        bus: where it is told.
        clocks: the host's clock says when.
    """

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        self._bus, self._clocks = bus, clocks
        self._counts, self._total = [0] * (len(BOUNDS) + 1), 0.0
        self._told_at = float("-inf")

    def ticked(self, seconds: float) -> None:
        """Count a tick that took so many seconds of the host."""
        self._counts[bisect_left(BOUNDS, seconds)] += 1
        self._total += seconds

    def step(self, running: str, queued: int) -> None:
        """Tell, if it is time to.

        Args:
            running: the task that runs, or nothing.
            queued: how many wait.
        """
        now = self._clocks.monotonic()
        if now - self._told_at < EVERY:
            return
        self._told_at = now
        ticks = Times(bounds=BOUNDS, counts=tuple(self._counts), total=self._total)
        TASK_PULSE.publish(self._bus, ExecutivePulse(queued=queued, running=running, ticks=ticks))
