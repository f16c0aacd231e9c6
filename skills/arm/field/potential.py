"""The potentials of the two-arm thesis, 2.4, and the velocity that they ask of a hand.

Attraction to a pole g (the goal, or an escape point):   U_A(p) = k/2 |p - g|^2
Repulsion by what is rho away, nearer than rho_0:        U_R(p) = eta/2 (1/rho - 1/rho_0)^2

The hand is to go down the potential: v = -grad U. Two things of the plain formulas are not wanted; the
thesis names both as drawbacks (6, 2.4). Their pull has no bound, and fades near the goal: here the pull
keeps the direction of -grad U_A and has at most the cruising speed V, or the speed from which it can still
brake at the rate A, sqrt(2 A d). And their push can outweigh the pull at a goal that lies close to an
obstacle, so that it is never reached: here the push fades with the distance to the goal (Ge and Cui, "New
potential functions for mobile robot path planning", IEEE T-RA 16(5), 2000, their factor rho^n(q, q_goal)
with n = 2).

How the gains were found. k is large enough for the bounds to act and not k itself (k d > sqrt(2 A d) down
to 4 cm, where the jerk-limited landing takes over). eta is not a number that was tried out: it is chosen
such that the push equals the largest pull exactly where the hand is to stand off, at d_s
(``standoff_gain``). So no pull brings a hand nearer than d_s by the potential alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.kinematics.transforms import Array

CLOSEST: Final = 0.004
"""Metres: what is nearer pushes as if it were this far away, so that the push stays finite."""


@dataclass(frozen=True)
class Gains:
    """What a field is made with.

    ``goal``, ``escape``: k of the goal and of escape points, 1/s. ``cruise``: V, m/s. ``braking``: A, m/s2.
    ``standoff``: d_s, metres between the hand's bodies and an obstacle. ``influence``: rho_0, metres.
    """

    goal: float = 8.0
    escape: float = 8.0
    cruise: float = 0.6
    braking: float = 1.5
    standoff: float = 0.03
    influence: float = 0.10

    @property
    def push(self) -> float:
        """eta, m4/s."""
        return standoff_gain(self.cruise, self.standoff, self.influence)


def attraction(p: Array, pole: Array, k: float) -> tuple[float, Array]:
    """Return U_A(p) and its gradient (3,)."""
    away = p - pole
    return 0.5 * k * float(away @ away), k * away


def repulsion(rho: Array, influence: float, eta: float) -> tuple[Array, Array]:
    """Return U_R of distances rho (m,) and dU_R/drho (m,): zero beyond ``influence``, negative within."""
    near = np.maximum(rho, CLOSEST)
    inverse = np.maximum(1.0 / near - 1.0 / influence, 0.0)
    return 0.5 * eta * inverse**2, np.where(
        rho > CLOSEST, -eta * inverse / near**2, -eta * inverse / CLOSEST**2
    )


def standoff_gain(pull: float, standoff: float, influence: float) -> float:
    """Return the eta with which the push at ``standoff`` metres is as strong as ``pull`` (m/s)."""
    return pull * standoff**2 / (1.0 / standoff - 1.0 / influence)


def pull(p: Array, pole: Array, remaining: float, k: float, gains: Gains) -> Array:
    """Return the velocity (3,) towards a pole: along -grad U_A, bounded by cruising speed and braking.

    Args:
        p: the hand, (3,).
        pole: what draws it.
        remaining: metres of the way to the goal (through the pole), for braking.
        k: the pole's gain.
        gains: the bounds.
    """
    desired = -attraction(p, pole, k)[1]
    size = float(np.linalg.norm(desired))
    most = min(gains.cruise, float(np.sqrt(2.0 * gains.braking * max(remaining, 0.0))))
    return desired if size <= most else desired * (most / size)


def push(rho: Array, normals: Array, to_goal: float, gains: Gains) -> Array:
    """Return the velocity (3,) away from obstacles: -grad U_R, summed, faded near the goal, bounded.

    Args:
        rho: metres to each, (m,).
        normals: unit vectors from each obstacle to the hand, (m, 3): the gradients of rho.
        to_goal: metres from the hand to its goal.
        gains: d_s and rho_0.
    """
    if not len(rho):
        return np.zeros(3)
    slope = repulsion(rho, gains.influence, gains.push)[1]
    fading = min(1.0, to_goal / gains.influence) ** 2
    velocity = -fading * (slope @ normals)
    size = float(np.linalg.norm(velocity))
    return np.asarray(velocity if size <= gains.cruise else velocity * (gains.cruise / size))
