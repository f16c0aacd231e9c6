"""Is the field stuck? Told by counts of periods, never by a clock."""

from __future__ import annotations

from typing import Final

WINDOW: Final = 70
"""Periods in which the hand must come nearer."""
NEARER: Final = 0.01
"""Metres by which it must."""
TURN: Final = 0.1
"""Metres that a radian left to turn counts."""
SWITCHES: Final = 4
"""Changes of the pole that begin the window anew; a hand that goes on wavering is stuck as well."""


class Progress:
    """Watches what is left of a way."""

    def __init__(self) -> None:
        self._best = float("inf")
        self._since = 0
        self._label = ""
        self._switches = 0

    def reset(self) -> None:
        """Begin anew: the goal has moved, or the arm has been elsewhere."""
        self._best, self._since, self._switches = float("inf"), 0, 0

    def stuck(self, remaining: float, angle: float, label: str) -> bool:
        """Note a period; say whether nothing has been gained for a window.

        Args:
            remaining: metres of the way, through the pole.
            angle: radians left to turn.
            label: of the pole.
        """
        left = remaining + TURN * angle
        if label != self._label:
            self._label, self._switches = label, self._switches + 1
            if self._switches <= SWITCHES:
                self._best, self._since = left, 0
        if left < self._best - NEARER:
            self._best, self._since = left, 0
            return False
        self._since += 1
        return self._since >= WINDOW
