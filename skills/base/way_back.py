"""How far a base may back up that has no sensor behind it: by the site's map, and by the robots seen of late.

The map holds walls and furniture. What else stands behind the base, nobody knows: a bumper, or the hand that
the base pushes against, ends it. So such a base backs up only to keep its distance.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.sights import Sight
from tandem.skills.base.surround import OTHER_RADIUS
from tandem.skills.ports.pose import FloorPose

STEP: Final = 0.05
"""Metres between two places that are asked about."""
FARTHEST: Final = 1.0
"""Metres of the way back that are looked at."""
SPARE: Final = 0.20
"""Metres left to what the map has: a base that turns away there and goes 0.8 m along a wall, 15 degrees off
its direction, comes 0.2 m nearer to it, and may not see what is beside it."""
OTHERS_SPEED: Final = 0.3
"""m/s at which a robot may have come nearer since it was seen."""
REMEMBERED: Final = 10.0
"""Robot seconds for which a robot that is not seen counts: after 3 m on its way it may be anywhere."""


class WayBack:
    """Says how far is free behind a base.

    Args:
        floor: distance to what the site's map has (m).
        radius: of the base's footprint (m).
    """

    def __init__(self, floor: DistanceField, radius: float) -> None:
        self._clear, self._radius = floor, radius

    def free(self, pose: FloorPose, robots: Mapping[str, Sight], now: float) -> float:
        """Return how many metres straight back are free.

        Args:
            pose: of the base in the map.
            robots: where others were seen last, by name.
            now: robot seconds.
        """
        backs = np.arange(1, round(FARTHEST / STEP) + 1) * STEP
        places = np.stack((pose.x - backs * math.cos(pose.yaw), pose.y - backs * math.sin(pose.yaw)), axis=-1)
        clear = self._clear.at(places) - SPARE
        for sight in robots.values():
            age = now - sight.at
            # One that stands beside the base does not keep it from going away from there.
            ahead = math.cos(pose.yaw) * (sight.x - pose.x) + math.sin(pose.yaw) * (sight.y - pose.y) > 0.0
            if age > REMEMBERED or (ahead and age < 1.0):
                continue
            away = np.hypot(places[:, 0] - sight.x, places[:, 1] - sight.y)
            clear = np.minimum(clear, away - OTHER_RADIUS - OTHERS_SPEED * age)
        blocked = np.flatnonzero(clear < self._radius)
        return float(backs[blocked[0]] - STEP if len(blocked) else backs[-1])
