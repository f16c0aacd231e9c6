"""Looks at the simulation itself during a drive: how near people come, and how well the tracker sees them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tandem.executive.trials.crossings.settings import Seen
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.world import PEOPLE, People

if TYPE_CHECKING:
    from tandem.sim.station import Station
    from tandem.skills.ports.bus import Bus

NEAR: Final = 1.0
"""Metres between the axes from which on somebody is near."""
SAME: Final = 0.5
"""Metres between a track and the person that it is of, at the most."""
NOBODY: Final = 0.6
"""Metres from everybody from which on a track is of nobody."""
FARTHEST: Final = 5.0
"""Metres to which people count as in view."""
SHOWN: Final = 0.35
"""Metres before a person's axis where the beam to it may end: on a leg of theirs."""
WALKED: Final = 0.6
"""Metres that a person has walked in view before a tracker can know."""
HIDDEN: Final = 1.0
"""Seconds out of view after which that begins anew."""


@dataclass
class _Sight:
    """What the laser has had of one person."""

    walked: float = 0.0
    hidden: float = 0.0
    last: tuple[float, float] | None = None


@dataclass(eq=False)
class Witness:
    """Call ``step`` after each period.

    Args:
        station: the simulation.
        bus: where the tracker tells.
    """

    station: Station
    bus: Bus
    near: float = 0.0
    nearest: float = math.inf
    lasted: float = 0.0
    in_view: float = 0.0
    missed: float = 0.0
    _sights: dict[str, _Sight] = field(default_factory=dict)
    _tracks: dict[int, list[bool]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Listen."""
        self._heard: Latest[People] = Latest(self.bus, PEOPLE, depth=16)

    def step(self) -> None:
        """Look."""
        period = self.station.model.description.period
        self.lasted += period
        (x, y, _), _ = self.station.body.base_pose()
        people = {name: each.place for name, each in self.station.world.people.items()}
        distance = min((math.dist((x, y), at) for at in people.values()), default=math.inf)
        self.nearest = min(self.nearest, distance)
        self.near += period * (distance < NEAR)
        for message in self._heard.take():
            self._compare(message, people)

    def seen(self) -> Seen:
        """Return how well the tracker saw."""
        false = sum(sum(there) < len(there) / 2 for there in self._tracks.values())
        return Seen(
            lasted=round(self.lasted, 2),
            false_people=false,
            in_view=round(self.in_view, 2),
            missed=round(self.missed, 2),
        )

    def close(self) -> None:
        """Stop listening."""
        self._heard.close()

    def _compare(self, message: People, people: dict[str, tuple[float, float]]) -> None:
        period = self.station.model.description.laser.period
        tracks = {each.id: (each.x, each.y) for each in message.people}
        for number, at in tracks.items():
            there = any(math.dist(at, place) < NOBODY for place in people.values())
            self._tracks.setdefault(number, []).append(there)
        for name, place in people.items():
            if not self._can_be_known(name, place, period):
                continue
            self.in_view += period
            if all(math.dist(at, place) > SAME for at in tracks.values()):
                self.missed += period

    def _can_be_known(self, name: str, place: tuple[float, float], period: float) -> bool:
        sight = self._sights.setdefault(name, _Sight())
        if not self._shows(place):
            sight.hidden += period
            if sight.hidden > HIDDEN:
                sight.walked, sight.last = 0.0, None
            return False
        sight.hidden = 0.0
        sight.walked += 0.0 if sight.last is None else math.dist(place, sight.last)
        sight.last = place
        return sight.walked > WALKED

    def _shows(self, place: tuple[float, float]) -> bool:
        """Say whether the laser looks at somebody, and nothing is before them."""
        body = self.station.body
        x, y, z = body.frame_matrix(self.station.model.description.laser.frame)[:3, 3]
        distance = math.dist((x, y), place)
        if distance > FARTHEST:
            return False
        (free,) = self.station.physics.cast([(x, y, z)], [(*place, z)], body.seen)
        return free * distance > distance - SHOWN
