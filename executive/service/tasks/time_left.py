"""How long a task takes yet: from past tasks of its kind that succeeded, by the phase it is in."""

from __future__ import annotations

from collections.abc import Mapping
from statistics import median


class Expectation:
    """One run's phases, and what past ones took from there.

    Args:
        past: robot seconds from the beginning of each phase to the end, by phase.
    """

    def __init__(self, past: Mapping[str, tuple[float, ...]]) -> None:
        self._usual = {phase: median(seconds) for phase, seconds in past.items() if seconds}
        self._began: dict[str, float] = {}
        self._phase = ""

    def enter(self, phase: str, now: float) -> None:
        """Note the phase that the task is in at ``now`` (robot seconds); its first beginning counts."""
        self._phase = phase
        self._began.setdefault(phase, now)

    def left(self, now: float) -> float | None:
        """Return the robot seconds that are left as a rule; None when nothing is known of the phase."""
        usual = self._usual.get(self._phase)
        return None if usual is None else round(max(0.0, usual - (now - self._began[self._phase])), 1)

    def lesson(self, now: float) -> Mapping[str, float]:
        """Return what this run took from the beginning of each phase to its end ``now``."""
        return {phase: round(now - began, 3) for phase, began in self._began.items() if phase}
