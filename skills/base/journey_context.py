"""What a journey knows of the floor and of the robot, and what it tells of its progress."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.cliffs import Cliffs
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.guard import Guard
from tandem.skills.base.localiser import Localiser
from tandem.skills.base.map import SiteMap
from tandem.skills.base.obstacles import Obstacles
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.people.tracker import STILL_RADIUS
from tandem.skills.base.way_watch import Watch
from tandem.skills.ports.robot_description import Drive

BERTH: Final = 0.75
"""Metres from the axis of somebody who stands at which a way passes, where there is room."""


@dataclass
class Progress:
    """What feedback tells of a run, in metres of way."""

    total: float = 0.0
    remaining: float = 0.0
    way: tuple[tuple[float, float], ...] = ()
    """Corners of the plan in the map (m)."""


@dataclass(frozen=True)
class JourneyContext:
    """What a journey knows of the floor and of the robot."""

    site_map: SiteMap
    obstacles: Obstacles
    localiser: Localiser
    drive: Drive
    radius: float
    """The footprint's (m)."""

    guard: Guard
    caution: Caution | None = None
    """What is heeded of people, by robots that track them."""
    bends: bool = False
    """Whether the base leaves its path for people: an elastic band (``skills/base/band``)."""

    cliffs: Cliffs | None = None
    """Where the floor ends, for robots that feel it."""

    def speed(self, wished: float) -> float:
        """Return how fast (m/s) the base may go ahead, as its cliff sensors are."""
        return wished if self.cliffs is None else self.cliffs.speed(wished)

    def radii(self) -> tuple[float, ...]:
        """Return the radii (m) to plan with, the wished one first."""
        reach = self.guard.reach
        return (reach, self.radius) if reach > self.radius else (self.radius,)

    def berths(self) -> tuple[float, ...]:
        """Return the berths (m) to give people who stand, the wished one first: they may set out any time."""
        stand = self.caution is not None and len(self.caution.tracker.rings()) > 0
        return (BERTH, STILL_RADIUS) if stand else (STILL_RADIUS,)

    def strange(self, berth: float = STILL_RADIUS) -> FloatArray:
        """Return points, shape (n, 2), of what stands and is on no map, people with their berth."""
        points = self.obstacles.points
        return points if self.caution is None else np.concatenate((points, self.caution.tracker.rings(berth)))

    def watch(self) -> Watch:
        """Return a watch for one run."""
        people = None if self.caution is None else self.caution.tracker
        return Watch(self.localiser, self.obstacles, self.radius, people)
