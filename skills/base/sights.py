"""Where other robots are, in the map: as a sensor sees them, or as they tell each other (RoCS paper, 4.2)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from tandem.skills.base.floor import compose
from tandem.skills.base.surround import Surround
from tandem.skills.base.whereabouts import Whereabouts, base_in_map
from tandem.skills.ports.actions.base import FollowSource
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Neighbours

TOLD_WITHIN: Final = 1.0
"""Robot seconds for which what a robot told of itself counts: it tells ten times a second."""


@dataclass(frozen=True)
class Sight:
    """Where another robot was last, in the map, and when that was (robot seconds)."""

    x: float
    y: float
    at: float


class Sights:
    """Remembers where each other robot was last.

    Args:
        clocks: robot time.
        monitor: where the base is.
        surround: sees other robots.
        neighbours: what other robots tell of themselves; whoever makes it steps it.
    """

    def __init__(
        self, clocks: Clocks, monitor: Whereabouts, surround: Surround, neighbours: Neighbours
    ) -> None:
        self._clocks, self._monitor, self._surround = clocks, monitor, surround
        self._neighbours = neighbours
        self._last: dict[str, Sight] = {}

    @property
    def last(self) -> Mapping[str, Sight]:
        """Where each robot was last, by its name."""
        return self._last

    def refresh(self, source: FollowSource) -> None:
        """Take in where the robots are now."""
        now, here = robot_seconds(self._clocks), base_in_map(self._monitor)
        for each in self._surround.robots:
            there = compose(here, FloorPose(x=each.x, y=each.y, yaw=0.0))
            self._last[each.name] = Sight(there.x, there.y, now)
        if source is FollowSource.SENSOR:
            return
        self._neighbours.refresh()
        for name, neighbour in self._neighbours.all().items():
            told = neighbour.told.base_in_map
            if told is not None and neighbour.age <= TOLD_WITHIN:
                self._last[name] = Sight(told.x, told.y, now - neighbour.age)
