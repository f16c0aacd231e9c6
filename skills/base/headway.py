"""Whether a base on a path gets on, is held by something, or has waited for people for too long."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.base.wheels_run import PATIENCE

NEARER: Final = 0.004
"""Metres that are getting on."""
STUCK_AFTER: Final = 4.0
"""Robot seconds of commanding without getting nearer after which something holds the base."""


class Headway:
    """Call ``look`` once a cycle.

    Args:
        now: robot seconds, pauses left out.
    """

    def __init__(self, now: float) -> None:
        self._nearest, self._at, self._waited = math.inf, now, 0.0

    @property
    def tired(self) -> bool:
        """Whether it has waited for people for too long."""
        return self._waited > PATIENCE

    def look(self, remaining: float, now: float, *, excused: bool, waits: bool) -> bool:
        """Say whether it can't go on like this.

        Args:
            remaining: metres of the path.
            now: robot seconds, pauses left out.
            excused: it turns, or something known stands in the way.
            waits: it waits for people.
        """
        if waits:
            self._waited, self._at = self._waited + now - self._at, now
            return self.tired
        if remaining < self._nearest - NEARER or excused:
            self._nearest, self._at, self._waited = min(self._nearest, remaining), now, 0.0
            return False
        return now - self._at > STUCK_AFTER
