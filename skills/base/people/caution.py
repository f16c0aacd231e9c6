"""How fast the base may go among people.

Two rules. ``safe``: a base that brakes now has stood for a second before anybody could run into it (passive
safety: Macek et al. 2009). It holds for all motions. ``pace``: along a path, the speed that gets farthest for
what it costs to be near where people will be; so the base slows down, passes behind them, or waits.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.path import Path
from tandem.skills.base.people.cost import costs
from tandem.skills.base.people.forecast import STEP, Forecast, forecast
from tandem.skills.base.people.person_track import Track
from tandem.skills.base.people.tracker import RADIUS, STILL_RADIUS, Tracker
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive

STANDS_FOR: Final = 1.4
"""Seconds for which the base is to have stood: one, and what people who speed up or turn take off it."""
LATENCY: Final = 0.25
"""Seconds before braking begins: a scan's period, and until the wheels answer."""
SWERVES: Final = (0.12, 0.25)
"""m/s by which the place of somebody who walks may be farther off its forecast, up to so many metres."""
EQUAL: Final = 1e-6
"""Metres: as good as no difference."""
ROOM: Final = 0.05
"""Metres between the two bodies that are too near."""
SHARES: Final = (1.0, 0.75, 0.5, 0.25)
"""Shares of the speed that are tried; if none is worth its costs, the base waits."""
DEAR: Final = 1.3
"""What being where somebody will be costs, in shares of the speed."""
SOON: Final = 0.5
"""Seconds before which costs don't count, so that a base can leave from beside somebody."""
LOOKS: Final = 2.5
"""Seconds of way that are looked at."""


@dataclass
class _Known:
    number: int
    ahead: Forecast


class Caution:
    """What the base heeds of people.

    Args:
        tracker: who is there.
        walls: clearance to what is mapped.
        drive: how the base brakes.
        radius: the footprint's (m).
        clocks: robot time.
    """

    def __init__(
        self, tracker: Tracker, walls: DistanceField, drive: Drive, radius: float, clocks: Clocks
    ) -> None:
        self.tracker, self._walls, self._drive, self._clocks = tracker, walls, drive, clocks
        self._apart = radius + RADIUS + ROOM
        self._known: _Known | None = None

    def ahead(self) -> Forecast:
        """Return where people will be, as of the newest scan."""
        if self._known is None or self._known.number != self.tracker.number:
            self._known = _Known(self.tracker.number, forecast(self.tracker.moving, self._walls))
        return self._known.ahead

    def safe(self, pose: FloorPose, linear: float, angular: float) -> bool:
        """Say whether a base at these speeds (m/s, rad/s) can still stand in time before anybody is there."""
        if not self.tracker.moving:
            return True
        seen = self.ahead()
        stops = max(abs(linear) / self._drive.acceleration, abs(angular) / self._drive.turn_acceleration)
        times = np.arange(0.0, LATENCY + stops + STANDS_FOR + STEP, STEP)
        base = self._braking(pose, linear, angular, times)
        places, velocities = seen.at(times + self.age())
        gaps = np.hypot(*np.moveaxis(base[None] - places, -1, 0))
        walks = np.hypot(velocities[:, 0, 0], velocities[:, 0, 1]) > 0.0
        swerve = np.minimum(SWERVES[0] * times, SWERVES[1])
        apart = self._apart + np.where(walks[:, None], swerve, -ROOM - RADIUS + STILL_RADIUS)
        near = (gaps < apart).any(axis=1)
        # From somebody who stands beside it the base may go away, and it may turn there.
        leaves = np.all(np.diff(gaps, axis=1) > -EQUAL, axis=1) & ~walks
        return not bool(np.any(near & ~leaves))

    def pace(self, path: Path, way: float, wanted: float) -> float:
        """Return the speed (m/s), ``wanted`` at the most, at which to go on along a path."""
        if not self.tracker.moving or wanted <= 0.0:
            return wanted
        seen, times = self.ahead(), np.arange(SOON, LOOKS + STEP, STEP)
        best, most = 0.0, 0.0  # who stands pays nothing: it is for people to come near
        for share in SHARES:
            ways = np.minimum(way + share * wanted * times, path.length)
            x = np.interp(ways, path.ways, path.points[:, 0])
            y = np.interp(ways, path.ways, path.points[:, 1])
            worst = float(costs(np.stack((x, y), axis=1), times + self.age(), seen).max())
            worth = share - DEAR * worst
            if worth > most + 1e-9:
                best, most = share * wanted, worth
        return best

    def nearest(self, x: float, y: float) -> Track | None:
        """Return the person nearest to a place in map."""
        return self.tracker.near(x, y, math.inf)

    def age(self) -> float:
        """Return the seconds since the scan that the forecast is of."""
        now, stamp = self._clocks.robot(), self.tracker.stamp
        late = None if now is None or stamp is None else now.since(stamp)
        return min(max(late or 0.0, 0.0), 0.5)

    def _braking(self, pose: FloorPose, linear: float, angular: float, times: FloatArray) -> FloatArray:
        """Return where the base is at the times, shape (k, 2), when it brakes along the arc that it is on."""
        brake = self._drive.acceleration
        rolls = np.clip(times - LATENCY, 0.0, abs(linear) / brake)
        way = math.copysign(1.0, linear) * (
            abs(linear) * np.minimum(times, LATENCY) + abs(linear) * rolls - brake * rolls**2 / 2
        )
        bend = angular / linear if abs(linear) > 0.05 else 0.0  # noqa: PLR2004 - turning on the spot
        yaw = wrap(pose.yaw) + bend * way / 2
        return np.stack((pose.x + way * np.cos(yaw), pose.y + way * np.sin(yaw)), axis=1)
