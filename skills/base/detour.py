"""Around other robots on the way to one that is followed: along the tangent to a circle about each.

The sensor of a follower looks ahead, so what it has seen of late counts. Without a detour a robot that stands
between the two is met head on, and the reflex turns the base to and fro before it while the other goes on.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.poses import wrap

ROOM: Final = 0.30
"""Metres between the two bodies when the base passes: what the reflex against collisions keeps, and as much
again, since the other one moves."""
NEAR: Final = 1.8
"""Metres from which on another robot is passed: farther off it will be elsewhere."""
COUNTS_FOR: Final = 3.0
"""Robot seconds for which a robot that is out of sight is where it was: at 0.3 m/s it comes 0.9 m far."""
KEPT_FOR: Final = 4.0
"""Robot seconds for which the side of a detour is kept: else the base would swing before one that moves."""


@dataclass(frozen=True)
class Other:
    """Another robot: radians left of the base's heading, metres between the centres."""

    bearing: float
    distance: float


class Detour:
    """Keeps the side on which the base goes round.

    Args:
        radius: of the base and another robot together (m).
    """

    def __init__(self, radius: float) -> None:
        self._clear = radius + ROOM
        self._side, self._chosen_at = 0.0, -math.inf

    def active(self, now: float) -> bool:
        """Say whether the base goes round somebody, or did a moment ago."""
        return now - self._chosen_at < KEPT_FOR / 2.0

    def around(self, bearing: float, distance: float, others: Iterable[Other], now: float) -> float:
        """Return the bearing (rad) to take to a place, past whoever is in the way.

        Args:
            bearing: to the place, radians left of the heading.
            distance: to the place (m).
            others: robots that count.
            now: robot seconds.
        """
        for each in sorted(others, key=lambda other: other.distance):
            if each.distance > min(NEAR, distance):
                break
            half = math.asin(min(1.0, self._clear / max(each.distance, 1e-6)))
            off = wrap(bearing - each.bearing)
            if abs(off) >= half:
                continue
            if now - self._chosen_at > KEPT_FOR or not self._side:
                self._side = 1.0 if off >= 0.0 else -1.0
            self._chosen_at = now
            return wrap(each.bearing + self._side * half)
        return bearing
