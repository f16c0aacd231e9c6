"""A round robot of radius ``RADIUS`` in the plane, and discs around it: all is known in closed form."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tandem.skills.arm.optimising.limits import Bounds
from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.kinematics.transforms import Array

RADIUS = 0.05
BOUNDS = Bounds(np.array([-2.0, -2.0]), np.array([2.0, 2.0]))
Disc = tuple[float, float, float]
"""x, y and radius, metres."""


@dataclass(frozen=True)
class Discs:
    """Upright cylinders without end."""

    discs: Sequence[Disc]

    def distances(self, points: Array) -> Array:
        return np.asarray(self._gaps(points).min(axis=0, initial=np.inf))

    def gradients(self, points: Array) -> Array:
        centres = np.array([(x, y) for x, y, _ in self.discs])
        away = points[:, :2] - centres[np.argmin(self._gaps(points), axis=0)]
        away /= np.linalg.norm(away, axis=1, keepdims=True)
        return np.concatenate((away, np.zeros((len(points), 1))), axis=1)

    def _gaps(self, points: Array) -> Array:
        gaps = [np.hypot(points[:, 0] - x, points[:, 1] - y) - r for x, y, r in self.discs]
        return np.array(gaps).reshape(-1, len(points))


@dataclass(frozen=True)
class RoundRobot:
    """One sphere whose joints are its x and y."""

    radii: Array

    def centres(self, q: Array) -> Array:
        return np.concatenate((q, np.zeros((len(q), 1))), axis=1)[:, None, :]

    def pull(self, q: Array, forces: Array) -> Array:  # noqa: ARG002 - its Jacobian is the identity
        return np.asarray(forces[:, 0, :2])


def cost(*discs: Disc, margin: float = 0.1) -> ObstacleCost:
    """What the round robot's paths among discs cost."""
    none = np.zeros(0, dtype=np.int_)
    return ObstacleCost(
        field=Discs(discs),
        robot=Discs(()),
        spheres=RoundRobot(np.array([RADIUS])),
        weights=np.ones(2),
        margin=margin,
        watched=np.zeros(1, dtype=bool),
        pairs=(none, none),
    )


def clearance(path: Array, *discs: Disc) -> float:
    """The least metres between the round robot and a disc, densely along the path."""
    between = [np.linspace(a, b, 20, endpoint=False) for a, b in itertools.pairwise(path)]
    return float(Discs(discs).distances(np.concatenate(between)).min()) - RADIUS
