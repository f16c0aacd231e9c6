"""Targets that may be turned about a vertical: what an arm needs that can't turn its hand freely.

The heading of such an arm's hand follows from where the hand is. A base that stands a centimetre aside puts a
given pose out of its reach, but not the same pose turned a little about what the hand is for.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.batch import stepped
from tandem.skills.kinematics.model import Chain, Limits
from tandem.skills.kinematics.transforms import Array

FAST = 1e3
"""Radians a second: a turn of the target costs no time when solutions are ordered by theirs."""


class Turned(Protocol):
    """A chain of which the twists from its tip to targets are known."""

    def root(self, chain: Chain) -> pin.SE3:
        """Return the first joint's frame in the base."""

    def error(self, q: Array, targets: Array) -> tuple[Array, Array]:
        """Return the twists (m, 6) from the tip to the targets (m, 4, 4), and their Jacobians (m, 6, n)."""


@dataclass(frozen=True)
class Vertical:
    """A line in the base's frame, upright through ``point`` (m), and the radians to turn about it at most."""

    point: tuple[float, float, float]
    most: float


class TurningChain:
    """A chain with one more column: the radians by which a row's target is turned about the vertical.

    Args:
        batch: the chain.
        chain: the joints, the others locked where they stand now.
        vertical: what is turned about.
    """

    def __init__(self, batch: Turned, chain: Chain, vertical: Vertical) -> None:
        self._batch = batch
        inverse = batch.root(chain).inverse()
        self._axis = np.asarray(inverse.rotation @ np.array((0.0, 0.0, 1.0)))
        self._point = np.asarray(inverse.act(np.array(vertical.point)))

    def root(self, chain: Chain) -> pin.SE3:
        """Return the first joint's frame in the base."""
        return self._batch.root(chain)

    def error(self, q: Array, targets: Array) -> tuple[Array, Array]:
        """Return the twists (m, 6) to the turned targets, and their Jacobians (m, 6, n + 1).

        A target at x that turns by da about the axis a through p moves by a x (x - p) da. The twist to it
        grows by that; the column has the other sign, because a column says how the tip comes nearer.
        """
        turned = self.turned(q[:, -1], targets)
        twist, jacobian = self._batch.error(q[:, :-1], turned)
        column = np.empty((len(q), 6, 1))
        column[:, :3, 0] = -np.cross(self._axis, turned[:, :3, 3] - self._point)
        column[:, 3:, 0] = -self._axis
        return twist, np.concatenate((jacobian, column), axis=2)

    def descend(
        self, q: Array, targets: Array, limits: Limits, *, damping: float, largest: float
    ) -> tuple[Array, Array]:
        """Return one step's q (m, n + 1), and the twists (m, 6) that were left before it."""
        twist, jacobian = self.error(q, targets)
        return stepped(q, twist, jacobian, limits, damping=damping, largest=largest), twist

    def turned(self, angles: Array, targets: Array) -> Array:
        """Return targets (m, 4, 4) turned by angles (m,)."""
        cross = np.asarray(pin.skew(self._axis))
        sine, rest = np.sin(angles)[:, None, None], (1.0 - np.cos(angles))[:, None, None]
        turns = np.eye(3) + sine * cross + rest * (cross @ cross)
        out = np.array(targets, dtype=float)
        out[:, :3, :3] = turns @ targets[:, :3, :3]
        out[:, :3, 3] = self._point + np.einsum("mij,mj->mi", turns, targets[:, :3, 3] - self._point)
        return out


def widened(limits: Limits, most: float) -> Limits:
    """Return the joints' limits (n,) with those of the turn behind them, (n + 1,)."""
    return Limits(
        np.append(limits.lower, -most), np.append(limits.upper, most), np.append(limits.velocity, FAST)
    )
