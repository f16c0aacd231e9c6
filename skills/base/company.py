"""Heeds the robots of the site on the way to a place: goes round them, and cares for one that follows.

Robots tell each other where they are and what they do (RoCS paper, 4.2: shared knowledge). A robot that goes
straight at its follower drives it backwards into a corner, and one that goes on while its follower is held
up loses it. So the base

- takes the tangent to a circle about a robot that is in its way, where the map leaves room to pass it, and
  else slows down before it (``GoRound``, ``WaitForRoom``);
- stands while its follower is far behind, and goes back for it when it is farther (``WaitForFollower``,
  ``MeetFollower``);
- leads its follower away first when it stands where the base is to go (``LeadAway``).

All this has an end: for one place it may cost ``PATIENCE``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.sights import TOLD_WITHIN
from tandem.skills.base.surround import OTHER_RADIUS
from tandem.skills.base.way_back import SPARE
from tandem.skills.base.whereabouts import Whereabouts, base_in_map
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Neighbours

BETWEEN: Final = 0.40
"""Metres between two bodies that pass: beyond what the reflexes of both need to stay quiet."""
NEARER: Final = 0.20
"""Metres within its distance at which a follower is passed: it backs up a little, and keeps its place."""
LOOKED_AT: Final = 2.5
"""Metres from which on a robot is gone round: farther off it will be elsewhere."""
STEP: Final = 0.1
"""Metres between two places on a way round that are asked about."""
WAY_ROUND: Final = 0.8
"""Metres that must be free along a way to be taken instead of the straight one: twice what a turn in front of
a wall takes."""
DEEPER: Final = 0.5
"""Radians at the most that a base which is too near already turns beyond a right angle, to get away."""
SAME_SIDE: Final = 0.6
"""Radians of detour that another side must save: else the base would swing before a robot that moves."""
KEPT_FOR: Final = 4.0
"""Robot seconds for which that counts."""
BEHIND: Final = (0.30, 0.40)
"""Metres beyond its distance at which a follower is waited for: slower from the first on, standing at the
second. One that keeps up with 0.4 m/s is 0.33 m too far behind."""
MET: Final = (0.20, 0.45)
"""Metres beyond its distance up to which, and from which on, a follower is met: it is held up, or has lost
sight of the base."""
ROOM_AT_PLACE: Final = 0.15
"""Metres nearer than its berth to the place at which a follower is led away from it."""
TURN: Final = math.radians(15.0)
"""Between two directions that are tried."""
BEFORE: Final = 0.20
"""Metres within a berth over which the base slows down to a stand before a robot that it can't go round."""
PATIENCE: Final = 30.0
"""Robot seconds on the way to one place that others may cost without the base getting nearer."""


Way = tuple[float, float]
"""A direction in the map (rad) to take for now, and a share of the speed."""


@dataclass(frozen=True)
class Other:
    """A robot, as the base has it now."""

    x: float
    y: float
    """Metres in the map."""
    away: float
    """Metres between the centres."""
    bearing: float
    """Radians in the map."""
    berth: float
    """Metres that the base keeps from its centre."""
    keeps: float | None = None
    """Metres at which it follows the base; None: it does not."""

    @property
    def behind(self) -> float:
        """By how many metres a follower is farther away than it should be."""
        return 0.0 if self.keeps is None else self.away - self.keeps


class Company:
    """The robots of the site, as the base heeds them. ``begin`` a way, and ask for ``advice`` once a cycle.

    Args:
        clocks: robot time.
        monitor: where the base is.
        neighbours: what the other robots tell.
        floor: distance to what the site's map has (m).
        radius: of the base's footprint (m).
    """

    def __init__(
        self,
        clocks: Clocks,
        monitor: Whereabouts,
        neighbours: Neighbours,
        floor: DistanceField,
        radius: float,
    ) -> None:
        self._clocks, self._monitor, self._neighbours = clocks, monitor, neighbours
        self._floor, self._radius = floor, radius
        self._side, self._chosen_at = 0.0, -math.inf
        self.begin()

    def begin(self) -> None:
        """Begin a way to a place."""
        self._spent, self._nearest, self._asked_at = 0.0, math.inf, robot_seconds(self._clocks)
        self._meets = self._leads = False
        self.why = ""
        """What the base does for another robot now, by name; empty: nothing."""

    def advice(self, x: float, y: float) -> Way:
        """Return how to go on to a place (m in the map)."""
        now, here = robot_seconds(self._clocks), base_in_map(self._monitor)
        left, bearing = math.hypot(x - here.x, y - here.y), math.atan2(y - here.y, x - here.x)
        if self.why and left >= self._nearest:
            self._spent += now - self._asked_at
        self._asked_at, self._nearest = now, min(left, self._nearest)
        self.why = ""
        if self._spent > PATIENCE:
            return bearing, 1.0
        others = tuple(self._others(here))
        follower = min((each for each in others if each.keeps), key=lambda each: each.away, default=None)
        if follower is None:
            return self._past(others, here, left, bearing)
        if self._goes_to_meet(follower):
            self.why = "MeetFollower"
            return follower.bearing, 1.0 if self._free(here, follower.bearing) else 0.0
        away = None
        if self._leads_away(follower, math.hypot(x - follower.x, y - follower.y)):
            away = self._away_from(follower, here)
        if away is None:
            way, pace = self._past(others, here, left, bearing)
        else:
            way, pace, self.why = away, 1.0, "LeadAway"
        slower = waits(follower, way)
        if slower < pace:
            self.why = "WaitForFollower"
        return way, min(pace, slower)

    def _goes_to_meet(self, follower: Other) -> bool:
        """Say whether it is so far behind that it is met, until it is near again."""
        self._meets = follower.behind > (MET[0] if self._meets else MET[1])
        return self._meets

    def _leads_away(self, follower: Other, off_place: float) -> bool:
        """Say whether it stands so near the place (m) that it must leave before the base can be there."""
        self._leads = off_place < follower.berth - (0.0 if self._leads else ROOM_AT_PLACE)
        return self._leads

    def _away_from(self, follower: Other, here: FloorPose) -> float | None:
        """Return the free direction that leads away from it best, None: there is none."""
        turns = np.arange(round(math.pi / 2.0 / TURN) + 1) * TURN
        tried = [wrap(follower.bearing + math.pi + side * turn) for turn in turns for side in (1.0, -1.0)]
        return next((way for way in tried if self._free(here, way)), None)

    def _past(self, others: tuple[Other, ...], here: FloorPose, left: float, bearing: float) -> Way:
        in_way = [each for each in others if stands_in_way(each, left, bearing)]
        if not in_way:
            return bearing, 1.0
        nearest = min(in_way, key=lambda each: each.away)
        around = self._around(nearest, here, bearing)
        if around is not None:
            self.why = "GoRound"
            return around, 1.0
        self.why = "WaitForRoom"
        return bearing, _ramp(nearest.away, nearest.berth - BEFORE, nearest.berth)

    def _around(self, other: Other, here: FloorPose, bearing: float) -> float | None:
        """Return the direction of a free tangent to the circle about a robot, of the smaller detour."""
        if other.away > other.berth:
            half = math.asin(other.berth / other.away)
        else:
            half = math.pi / 2.0 + min(DEEPER, 2.0 * (other.berth - other.away))
        now = robot_seconds(self._clocks)
        kept = self._side if now - self._chosen_at < KEPT_FOR else 0.0
        tangents = [(side, wrap(other.bearing + side * half)) for side in (1.0, -1.0)]
        free = [
            (side, way)
            for side, way in tangents
            if self._free(here, way) and self._room_beside(other, bearing + side * math.pi / 2.0)
        ]
        if not free:
            return None
        self._side, way = min(
            free, key=lambda each: abs(wrap(each[1] - bearing)) - (SAME_SIDE if each[0] == kept else 0.0)
        )
        self._chosen_at = now
        return way

    def _free(self, here: FloorPose, way: float) -> bool:
        along = np.arange(1, round(WAY_ROUND / STEP) + 1) * STEP
        places = np.stack((here.x + along * math.cos(way), here.y + along * math.sin(way)), axis=-1)
        return bool(self._floor.at(places).min() > self._radius + SPARE)

    def _room_beside(self, other: Other, across: float) -> bool:
        """Say whether the base has room where it passes a robot, in a direction (rad) across its way."""
        x, y = other.x + other.berth * math.cos(across), other.y + other.berth * math.sin(across)
        return self._floor.at_point(x, y) > self._radius + SPARE

    def _others(self, here: FloorPose) -> Iterable[Other]:
        self._neighbours.refresh()
        for each in self._neighbours.all().values():
            there, follows = each.told.base_in_map, each.told.follows
            if there is None or each.age > TOLD_WITHIN:
                continue
            keeps = None
            if follows is not None and follows.robot == self._neighbours.own:
                keeps = follows.distance
            bodies = self._radius + OTHER_RADIUS
            yield Other(
                x=there.x,
                y=there.y,
                away=math.hypot(there.x - here.x, there.y - here.y),
                bearing=math.atan2(there.y - here.y, there.x - here.x),
                berth=bodies + BETWEEN if keeps is None else max(keeps - NEARER, bodies),
                keeps=keeps,
            )


def waits(follower: Other, way: float) -> float:
    """Return which share of its speed a base has on a way (rad) that leads it from its follower."""
    return 1.0 if math.cos(follower.bearing - way) > 0.0 else 1.0 - _ramp(follower.behind, *BEHIND)


def stands_in_way(other: Other, left: float, bearing: float) -> bool:
    """Say whether a straight way of ``left`` metres passes a robot within its berth."""
    off = wrap(other.bearing - bearing)
    ahead, beside = other.away * math.cos(off), other.away * math.sin(off)
    return other.away < LOOKED_AT and 0.0 < ahead < left and abs(beside) < other.berth


def _ramp(value: float, low: float, high: float) -> float:
    """Return 0 below ``low``, 1 above ``high``, and what lies between."""
    return min(max((value - low) / (high - low), 0.0), 1.0)
