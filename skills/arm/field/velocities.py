"""From the hand's desired twist to the joints' velocities: the whole arm keeps off everything and its limits.

A small quadratic program, solved by DAQP (a dual active-set method) at each step:

    minimise   |J_v dq - s v|^2 + TURN^2 |J_w dq - s w|^2 + DAMPING^2 |dq - s dq_0|^2 + HASTE^2 (1 - s)^2
    subject to  0 <= s <= 1
                the joints' speeds, and speeds from which they can still brake before their limits;
                grad d_k . dq >= -SLOPE (d_k - floor_k)   for each pair of bodies that is near

The first line is damped least squares; the damping pulls to dq_0, a velocity towards joint positions at
which the goal is known to be reached freely, so what the hand leaves open (the elbow) goes there too. With
s all of it may be slower, in the same direction, where a joint is at its limit. The last line is the
velocity damper of Faverjon and Tournassoud ("A local based approach for path planning of manipulators with
a high number of degrees of freedom", ICRA 1987): a distance may shrink the more slowly the smaller it is.
So the repulsion acts on the whole arm, at the two points where each pair of bodies is nearest, and the hand
slides along what it can't pass. Dampers are soft: where they contradict each other they are missed by as
little as can be, and the guard (``guard.py``) decides whether that is free.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import daqp
import numpy as np

from tandem.skills.arm.trajectory import MotionLimits
from tandem.skills.kinematics.model import Limits
from tandem.skills.kinematics.transforms import Array

TURN: Final = 0.25
"""Metres that a radian of the hand's attitude counts."""
DAMPING: Final = 0.3
"""Metres that a radian of the joints counts."""
HASTE: Final = 2.0
"""Metres a second that being twice as slow costs, about."""
SLOPE: Final = 4.0
"""1/s: twice as fast as the arm can answer at its jerk limit would make it swing."""
ANSWER: Final = 0.1
"""Seconds by which the arm's velocity is behind the desired one, at the jerk limit: bounds and dampers
look ahead by as much, with the present velocity."""
APART_AT_MOST: Final = 0.1
"""m/s at which bodies that are too near are pushed apart."""
BRAKE_SHARE: Final = 0.4
"""Of the joints' deceleration, with which they stop before their limits: jerk takes the rest."""
SOFT: Final = 8
"""DAQP's mark of a constraint that may be missed."""
SOLVED: Final = 0
"""DAQP's exit flags above it mean a solution; it and those below mean none."""


@dataclass(frozen=True)
class Dampers:
    """The pairs that are near: gradients (m, n), distances (m,) and floors (m,) in metres."""

    gradient: Array
    distance: Array
    floor: Array


class VelocitySolver:
    """Solves for one arm.

    Args:
        limits: positions (n,).
        motion: speeds and accelerations (n,).
    """

    def __init__(self, limits: Limits, motion: MotionLimits) -> None:
        self._limits, self._motion = limits, motion

    def solve(  # noqa: PLR0917 - the problem's parts
        self, q: Array, v: Array, jacobian: Array, twist: Array, posture: Array, dampers: Dampers
    ) -> Array:
        """Return joint velocities (n,).

        Args:
            q: joint positions (n,).
            v: joint velocities (n,) now.
            jacobian: of the hand (6, n), along and about the base's axes.
            twist: the desired one (6,), m/s and rad/s.
            posture: dq_0 (n,), rad/s, for what the twist leaves open.
            dampers: what is near.
        """
        count, near = len(q), len(dampers.distance)
        rows = np.zeros((6 + count, count + 1))
        rows[:6, :count], rows[:6, count] = jacobian, -twist
        rows[3:6] *= TURN
        rows[range(6, 6 + count), range(count)] = DAMPING
        rows[6:, count] = -DAMPING * posture
        hessian = rows.T @ rows
        hessian[count, count] += HASTE**2
        linear = np.zeros(count + 1)
        linear[count] = -(HASTE**2)
        lower, upper = self.bounds(q + ANSWER * v)
        distance = dampers.distance + ANSWER * (dampers.gradient @ v)
        needed = np.minimum(-SLOPE * (distance - dampers.floor), APART_AT_MOST)
        gradient = np.zeros((near, count + 1))
        gradient[:, :count] = dampers.gradient
        above = np.concatenate((upper, [1.0], np.full(near, 1e30)))
        below = np.concatenate((lower, [0.0], needed))
        sense = np.zeros(count + 1 + near, dtype=np.int32)
        sense[count + 1 :] = SOFT
        found, _, flag, _ = daqp.solve(hessian, linear, gradient, above, below, sense)
        if flag <= SOLVED:
            return np.zeros(count)
        return np.clip(np.asarray(found[:count], dtype=np.float64), lower, upper)

    def bounds(self, q: Array) -> tuple[Array, Array]:
        """Return the slowest and fastest velocities (n,) with which the joints stay inside their limits."""
        braking = 2.0 * BRAKE_SHARE * self._motion.acceleration
        up = np.sqrt(braking * np.maximum(self._limits.upper - q, 0.0))
        down = np.sqrt(braking * np.maximum(q - self._limits.lower, 0.0))
        return -np.minimum(down, self._motion.velocity), np.minimum(up, self._motion.velocity)
