"""Where people will be: constant velocity, bent by social forces (Helbing & Molnar 1995).

A person keeps the velocity that they are seen to have, is drawn back to it, and is pushed away by walls and
by other people. The robot pushes nobody: half of the people would run into one that counts on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.people.person_track import STANDS, Track

HORIZON: Final = 4.0
"""Seconds: a base at 0.7 m/s stands after 1.7 s, and has stood for one after 2.7 s; the rest is room."""
STEP: Final = 0.1
"""Seconds: a person at 1.4 m/s goes 0.14 m in it, less than their radius."""
RELAXES: Final = 0.5
"""Seconds in which a velocity is drawn back to the wished one: their tau."""
REPULSION: Final = 2.1 / 0.3
"""m/s2 between two people who touch; it falls to a third each"""
REACH: Final = 0.3
"""metres: their V0 / sigma, and sigma."""
WALL: Final = 10.0 / 0.2
"""m/s2 at a wall; it falls to a third each"""
WALL_REACH: Final = 0.2
"""metres: their U0 / R, and R."""
MOST: Final = 1.5
"""m/s2 of all pushes together: people walk 0.3 m from furniture without swerving."""
BODY: Final = 0.2
"""Metres around an axis: gaps are between bodies."""


@dataclass(frozen=True)
class Forecast:
    """Of n people, m moments: ``places`` and ``velocities`` of shape (n, m, 2), in map (m, m/s)."""

    times: FloatArray
    """Seconds after the scan, shape (m,)."""
    places: FloatArray
    velocities: FloatArray
    sigmas: FloatArray
    """How well the places are known now (m), shape (n,)."""

    def at(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return places and velocities, shape (n, k, 2), at k moments (s after the scan), or the last one."""
        index = np.clip(np.rint(times / STEP).astype(np.int64), 0, len(self.times) - 1)
        return self.places[:, index], self.velocities[:, index]


def forecast(people: Sequence[Track], walls: DistanceField) -> Forecast:
    """Return where the people will be."""
    count, moments = len(people), round(HORIZON / STEP) + 1
    place = np.array([track.place for track in people]).reshape(count, 2)
    wished = np.array([track.velocity for track in people]).reshape(count, 2)
    stands = np.hypot(wished[:, 0], wished[:, 1]) < STANDS
    wished[stands] = 0.0
    velocity = wished.copy()
    places, velocities = np.empty((count, moments, 2)), np.empty((count, moments, 2))
    for moment in range(moments):
        places[:, moment], velocities[:, moment] = place, velocity
        push = _people(place) + _walls(place, walls)
        strength = np.hypot(push[:, 0], push[:, 1])[:, None]
        push *= np.minimum(1.0, MOST / np.maximum(strength, 1e-9))
        push[stands] = 0.0
        velocity = velocity + STEP * ((wished - velocity) / RELAXES + push)
        place = place + STEP * velocity
    sigmas = np.array([track.sigma for track in people])
    return Forecast(np.linspace(0.0, HORIZON, moments), places, velocities, sigmas)


def _people(place: FloatArray) -> FloatArray:
    apart = place[:, None, :] - place[None, :, :]
    distance = np.hypot(apart[..., 0], apart[..., 1])
    strength = REPULSION * np.exp(-np.maximum(distance - 2 * BODY, 0.0) / REACH)
    np.fill_diagonal(strength, 0.0)
    return np.asarray((apart / np.maximum(distance, 1e-6)[..., None] * strength[..., None]).sum(axis=1))


def _walls(place: FloatArray, walls: DistanceField) -> FloatArray:
    distance, away = walls.with_gradient(place)
    strength = WALL * np.exp(-np.maximum(distance - BODY, 0.0) / WALL_REACH)
    return np.asarray(away * strength[:, None])
