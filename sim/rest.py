"""When the hardware tells less often: nothing is told a hundred times a second of a robot that stands."""

from __future__ import annotations

from typing import Final

STANDS_AFTER: Final = 0.5
"""Seconds without any motion from which on a robot rests: skills watch it settle for 0.3."""


class Rest:
    """Says in which periods states and clock are told. Call ``tells`` once a period.

    Args:
        period: seconds between two messages of what moves.
        resting_period: seconds between two messages of what rests; None: no difference is made.
    """

    def __init__(self, period: float, resting_period: float | None) -> None:
        self._every = 1 if resting_period is None else max(1, round(resting_period / period))
        self._patience = round(STANDS_AFTER / period)
        self._stood = 0

    def tells(self, tick: int, *, moving: bool) -> bool:
        """Say whether states and clock are told after this tick; ``moving``: anything moves, or is to."""
        self._stood = 0 if moving else self._stood + 1
        return self._stood <= self._patience or tick % self._every == 0
