"""What the surroundings cost a path: how near its spheres come, times how fast they go there.

The cost of a sphere is Zucker et al. 2013, eq. 21: it grows linearly with depth, and from the surface to
``margin`` metres away it fades as a parabola. Multiplied by the sphere's speed and summed over the path it
does not depend on how fast the path goes (eq. 16), so that nothing is gained by hurrying past.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from tandem.skills.arm.optimising.spaces import DistanceField, Spheres
from tandem.skills.kinematics.transforms import Array

Mask = npt.NDArray[np.bool_]
Numbers = npt.NDArray[np.int_]

SLOW = 1e-9
"""Metres a unit of time below which a sphere stands still."""


@dataclass(frozen=True)
class ObstacleCost:
    """The cost of paths in weighed joint positions.

    Attributes:
        field: distances to what stands around.
        robot: distances to what of the robot stands still, for the spheres that are ``watched``.
        spheres: what moves.
        weights: of the joints (n,).
        margin: metres from which on nearness costs something.
        watched: which spheres keep clear of the robot, (s,).
        pairs: numbers of the spheres (k,) and (k,) that keep clear of each other.
    """

    field: DistanceField
    robot: DistanceField
    spheres: Spheres
    weights: Array
    margin: float
    watched: Mask
    pairs: tuple[Numbers, Numbers]

    def costs(self, paths: Array) -> Array:
        """Return the cost of each point between the ends, (k, N), of paths (k, N + 2, n)."""
        k, count, n = paths.shape
        places = self.spheres.centres(paths.reshape(-1, n) / self.weights)
        at = places.reshape(k, count, -1, 3)
        speeds = _lengths(at[:, 2:] - at[:, :-2]) * (0.5 * (count - 1))
        inner = at[:, 1:-1].reshape(-1, at.shape[2], 3)
        near, _ = hinge(self._gaps(inner)[0], self.margin)
        total = (near.reshape(speeds.shape) * speeds).sum(axis=-1)
        near_pairs = self._meeting(inner)
        if len(near_pairs.rows):
            fast = speeds.reshape(-1, at.shape[2])
            both = fast[near_pairs.rows, near_pairs.one] + fast[near_pairs.rows, near_pairs.other]
            meeting = hinge(near_pairs.gaps, self.margin)[0] * both
            total += np.bincount(near_pairs.rows, meeting, total.size).reshape(total.shape)
        return np.asarray(total / (count - 1))

    def gradient(self, path: Array) -> Array:
        """Return the functional gradient (N, n) of one path (N + 2, n) at the points between its ends.

        Zucker et al. 2013, eq. 18: for each sphere J^T |x'| ((I - t t^T) grad c - c k), with t along its
        way and k its curvature.
        """
        count = len(path)
        at = self.spheres.centres(path / self.weights)
        velocity = (at[2:] - at[:-2]) * (0.5 * (count - 1))
        acceleration = (at[2:] - 2.0 * at[1:-1] + at[:-2]) * float(count - 1) ** 2
        inner = at[1:-1]
        forces = np.zeros_like(inner)
        gaps, own = self._gaps(inner)
        cost, slope = hinge(gaps, self.margin)
        for field, near in ((self.field, (cost > 0.0) & ~own), (self.robot, (cost > 0.0) & own)):
            if near.any():
                rising = field.gradients(inner[near]) * slope[near][:, None]
                forces[near] = _functional(cost[near], rising, velocity[near], acceleration[near])
        self._add_pair_forces(forces, inner, velocity, acceleration)
        joints = self.spheres.pull(path[1:-1] / self.weights, forces)
        return np.asarray(joints / self.weights / (count - 1))

    def _add_pair_forces(self, forces: Array, inner: Array, velocity: Array, acceleration: Array) -> None:
        near = self._meeting(inner)
        if not len(near.rows):
            return
        cost, slope = hinge(near.gaps, self.margin)
        away = inner[near.rows, near.one] - inner[near.rows, near.other]
        push = away * (slope / np.maximum(_lengths(away), SLOW))[:, None]
        # Each sphere is an obstacle of the other one.
        for which, rising in ((near.one, push), (near.other, -push)):
            at = (near.rows, which)
            np.add.at(forces, at, _functional(cost, rising, velocity[at], acceleration[at]))

    def _gaps(self, places: Array) -> tuple[Array, Mask]:
        """Return the metres (m, s) between the spheres and what is nearest, and where that is the robot."""
        gaps = self.field.distances(places.reshape(-1, 3)).reshape(places.shape[:-1])
        own = np.zeros(gaps.shape, dtype=bool)
        if self.watched.any():
            itself = self.robot.distances(places[:, self.watched].reshape(-1, 3)).reshape(len(places), -1)
            own[:, self.watched] = itself < gaps[:, self.watched]
            gaps[:, self.watched] = np.minimum(gaps[:, self.watched], itself)
        return gaps - self.spheres.radii, own

    def _meeting(self, places: Array) -> _Meeting:
        """Return which of the pairs are nearer than the margin, out of the centres (m, s, 3)."""
        one, other = self.pairs
        wide = self.spheres.radii[one] + self.spheres.radii[other]
        squares = np.einsum("msi,msi->ms", places, places)
        products = np.matmul(places, places.transpose(0, 2, 1)).reshape(len(places), -1)
        apart = squares[:, one] + squares[:, other] - 2.0 * products[:, one * places.shape[1] + other]
        rows, which = np.nonzero(apart < (wide + self.margin) ** 2)
        gaps = np.sqrt(np.maximum(apart[rows, which], 0.0)) - wide[which]
        return _Meeting(rows, one[which], other[which], gaps)


@dataclass(frozen=True)
class _Meeting:
    """Pairs of spheres that are near: the state's number, the spheres' numbers, the metres between them."""

    rows: Numbers
    one: Numbers
    other: Numbers
    gaps: Array


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))


def hinge(gaps: Array, margin: float) -> tuple[Array, Array]:
    """Return the costs of gaps (metres) and their slopes, each of the gaps' shape."""
    inside = gaps < 0.0
    lack = np.maximum(margin - gaps, 0.0)
    cost = np.where(inside, 0.5 * margin - gaps, 0.5 * lack**2 / margin)
    return cost, np.where(inside, -1.0, -lack / margin)


def _functional(cost: Array, rising: Array, velocity: Array, acceleration: Array) -> Array:
    """Return |v| ((I - t t^T) grad c - c k) over the last axis."""
    speed = np.linalg.norm(velocity, axis=-1, keepdims=True)
    along = velocity / np.maximum(speed, SLOW)

    def across(vectors: Array) -> Array:
        return np.asarray(vectors - along * np.sum(along * vectors, axis=-1, keepdims=True))

    curvature = across(acceleration) / np.maximum(speed, SLOW) ** 2
    moving = speed > SLOW
    return np.asarray(np.where(moving, speed * (across(rising) - cost[..., None] * curvature), 0.0))
