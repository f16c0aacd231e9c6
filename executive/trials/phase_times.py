"""How long each phase of the tasks took, on the robot's clock."""

from __future__ import annotations

from tandem.executive.system.systems import System
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import TASK_STATUS


class Phases:
    """A node that listens to the tasks' progress."""

    name = "phases"

    def __init__(self, system: System) -> None:
        """Listen from now on."""
        self._clocks = system.clocks
        self._statuses = Latest(system.bus, TASK_STATUS, depth=1024)
        self._seconds: dict[str, float] = {}
        self._phase, self._since = "", 0.0

    def step(self) -> bool:
        """Take in what was told."""
        now = robot_seconds(self._clocks)
        for status in self._statuses.take():
            phase = "" if status.state.terminal else status.progress.phase
            if phase != self._phase:
                self._leave(now)
                self._phase, self._since = phase, now
        return False

    def seconds(self) -> dict[str, float]:
        """Return the robot seconds of each phase until now."""
        return {name: round(value, 2) for name, value in self._seconds.items()}

    def close(self) -> None:
        """Stop listening."""
        self._statuses.close()

    def _leave(self, now: float) -> None:
        if self._phase:
            self._seconds[self._phase] = self._seconds.get(self._phase, 0.0) + now - self._since
