"""What a band is held to: how the base can move, what it keeps away from, and where it begins and ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.people.forecast import HORIZON, STEP, Forecast
from tandem.skills.base.planner import Clearances
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive

FRONT: Final = 1.3
"""Seconds of walking that nobody is to have before them: a base there could not have stood for a second."""
GROWS: Final = (0.10, 0.20)
"""Metres a second by which the room around somebody who walks grows with the forecast's age, and the most."""


FAR: Final = 9.0
"""Metres: out of everybody's way."""


@dataclass(frozen=True)
class Begin:
    """Where the base is, and how it moves."""

    pose: FloorPose
    linear: float
    """m/s."""
    angular: float
    """rad/s."""


@dataclass(frozen=True)
class Surroundings:
    """What a plan keeps away from."""

    clearances: Clearances
    """Of the map, and of what the laser has seen besides."""
    people: Forecast
    age: float
    """Seconds since the scan that the forecast is of."""
    apart: float
    """Metres between the axes of the base and of somebody who walks."""

    def gaps(self, points: FloatArray, moments: FloatArray, front: float = FRONT) -> Gaps:
        """Return how far the points, shape (k, m, 2), at their moments, shape (k, m), are from people.

        ``front`` is the walking (s) that nobody is to have before them; 0 for the gaps between bodies.
        """
        shape = moments.shape
        times = moments.reshape(-1) + self.age
        places, velocities = self.people.at(times)
        # Between two of the forecast's moments they walk on.
        late = np.clip(times - np.clip(np.rint(times / STEP) * STEP, 0.0, HORIZON), -STEP, STEP)
        places = (places + late[:, None] * velocities).reshape(-1, *shape, 2)
        velocities = velocities.reshape(-1, *shape, 2)
        off = points[None] - places
        square = np.maximum((velocities**2).sum(axis=-1), 1e-9)
        share = np.clip((off * velocities).sum(axis=-1) / square, 0.0, front)
        off = off - share[..., None] * velocities
        far = np.maximum(np.sqrt((off**2).sum(axis=-1)), 1e-6)
        away = off / far[..., None]
        walks = square > 1e-4  # noqa: PLR2004 - 1 cm/s
        room = self.apart + walks * np.minimum(GROWS[0] * moments, GROWS[1])
        # What is later than the forecast tells, nobody knows.
        known = (times <= HORIZON).reshape(shape)
        later = -(away * velocities).sum(axis=-1) - GROWS[0] * walks * (GROWS[0] * moments < GROWS[1])
        return Gaps(np.where(known, far - room, FAR), away, later * known)


@dataclass(frozen=True)
class Gaps:
    """Of p people and k bands with m poses each, shape (p, k, m)."""

    spare: FloatArray
    """Metres more than there have to be, to the person or to the floor just before them."""
    away: FloatArray
    """The direction in which it grows, shape (p, k, m, 2)."""
    later: FloatArray
    """Metres by which it grows a second that the base comes later."""


@dataclass(frozen=True)
class Task:
    """One plan: from here to a point, within limits, among things and people."""

    begin: Begin
    end: tuple[float, float, float]
    """x, y (m) and heading (rad) in map; the heading is a wish."""
    stops: bool
    """Whether the base is to stand at the end."""
    drive: Drive
    around: Surroundings
