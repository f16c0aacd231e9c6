"""Is the next set-point free, and can the arm still come to rest freely from there?

A set-point is sent only when the whole braking that could begin in it is free. So at each moment there is a
free way to rest, which is taken as soon as no other step is free (a "braking trajectory" as a safe state:
Fraichard and Asama, "Inevitable collision states", Advanced Robotics 18(10), 2004). The other arm is looked
at where it is, and where it would be in a moment at its present speed: it may go on, or be stopped.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.problem import LIMIT_MARGIN
from tandem.skills.kinematics.model import Limits
from tandem.skills.kinematics.proximity import Nearby, Proximity
from tandem.skills.kinematics.transforms import Array

NOISE: Final = 1e-5
"""Metres by which a distance that is too small already may shrink in a period (arithmetic, not motion)."""
WITHIN: Final = 0.8 * LIMIT_MARGIN
"""Radians beyond the arm's own limits, which lie inside the joints', that braking may take."""


@dataclass(frozen=True)
class Floors:
    """Metres kept from the world (with its padding), the robot's body, the arm's own links, the other arm."""

    world: float
    body: float
    own: float
    other: float


FIELD: Final = Floors(world=0.002, body=0.003, own=0.001, other=0.03)
"""What the guard keeps while the field leads. Things that stand get millimetres, so that a hand gets between
them; the other arm, which may move on, gets 3 cm. More closes ways; with less, noise and lag may let things
touch."""
DAMPED: Final = Floors(world=0.004, body=0.008, own=0.002, other=0.035)
"""The field's own: its dampers slow the arm down there already, so that the guard seldom has to stop it."""
PLANNED: Final = Floors(world=-0.002, body=-0.001, own=-0.001, other=0.02)
"""For motions that a planner has checked, or that have been made before: those come as near as they like."""
INFLUENCE: Final = Floors(world=0.10, body=0.06, own=0.02, other=0.15)
"""Distances at which pairs are told to the field."""


class Guard:
    """Watches over one group.

    Args:
        proximity: of the group.
        limits: of its joints, (n,).
        columns: of the group's joints in a full configuration.
        other: links of the other arms.
    """

    def __init__(self, proximity: Proximity, limits: Limits, columns: Array, other: Sequence[str]) -> None:
        self.proximity, self._limits, self._columns = proximity, limits, columns
        self._other = frozenset(other)
        self._built = 0
        self._floors: dict[Floors, Array] = {}

    def floors(self, kept: Floors) -> Array:
        """Return the floors of all pairs, (pairs,)."""
        near = self.proximity
        if self._built != near.built:
            self._built = near.built
            self._floors.clear()
        if kept not in self._floors:
            of_other = np.array([near.pair(k)[1] in self._other for k in range(near.pairs)], dtype=bool)
            robot = np.where(near.of_group, kept.own, np.where(of_other, kept.other, kept.body))
            self._floors[kept] = np.where(near.of_robot, robot, kept.world)
        return self._floors[kept]

    def look(self, full: Array) -> Nearby:
        """Return what is near the set-point; ``full`` are the positions of all joints."""
        return self.proximity.look(full, self.floors(INFLUENCE))

    def free(self, cases: Sequence[Array], ways: Sequence[Array], kept: Floors) -> bool:
        """Say whether the group can be at all of the positions (n,), wherever the others are then.

        What is nearer than its floor already may stay so, but not come nearer: a hand must be able to leave.

        Args:
            cases: positions of all joints, for each place of the others; the group's own are replaced.
            ways: positions of the group.
            kept: the floors.
        """
        floors = np.minimum(self.floors(kept), self.proximity.lower - NOISE)
        for q in ways:
            if bool(np.any(q < self._limits.lower - WITHIN) or np.any(q > self._limits.upper + WITHIN)):
                return False
            for full in cases:
                there = full.copy()
                there[self._columns] = q
                if self.proximity.hits(there, floors) is not None:
                    return False
        return True
