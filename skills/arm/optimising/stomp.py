"""STOMP: noisy paths about one, of which the cheap ones pull it to them; no gradient is asked for.

Kalakrishnan, Chitta, Theodorou, Pastor and Schaal, "STOMP: Stochastic Trajectory Optimization for Motion
Planning", ICRA 2011.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field

import numpy as np

from tandem.skills.arm.optimising.limits import Bounds
from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.arm.optimising.settings import StompSettings
from tandem.skills.arm.optimising.smoothness import Smoothness
from tandem.skills.arm.optimising.work import units
from tandem.skills.kinematics.transforms import Array


@dataclass(frozen=True)
class _Rollouts:
    """Noisy paths (k, N + 2, n), and the costs of their points (k, N)."""

    paths: Array
    costs: Array

    def joined(self, others: _Rollouts | None) -> _Rollouts:
        """Return these and others."""
        if others is None:
            return self
        return _Rollouts(
            np.concatenate((self.paths, others.paths)), np.concatenate((self.costs, others.costs))
        )

    def cheapest(self, count: int) -> _Rollouts:
        """Return so many of them."""
        best = np.argsort(self.costs.sum(axis=1), kind="stable")[:count]
        return _Rollouts(self.paths[best], self.costs[best])


@dataclass
class Stomp:
    """One path under way.

    Attributes:
        path: weighed joint positions (N + 2, n).
        form: its smoothness.
        cost: of its surroundings.
        bounds: limits.
        settings: noise and weights.
        rng: draws the noise.
    """

    path: Array
    form: Smoothness
    cost: ObstacleCost
    bounds: Bounds
    settings: StompSettings
    rng: np.random.Generator
    _sigma: float = field(default=0.0, init=False)
    _kept: _Rollouts | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        self._sigma = self.settings.noise

    def settle(self) -> None:
        """Draw less noise from now on: a way has been found, and is only to become better."""
        self._sigma *= self.settings.settled
        self._kept = None

    def advance(self) -> Generator[int, None, None]:
        """Draw rollouts, cost each of their points, and go where the cheap ones are (2011, Table I).

        The cheapest of earlier iterations count as well: their costs are known.
        """
        rollouts = self._draw(self._sigma)
        self._sigma *= self.settings.decay
        costs = np.empty((len(rollouts), self.form.count))
        for first in range(0, len(rollouts), self.settings.at_once):
            some = rollouts[first : first + self.settings.at_once]
            costs[first : first + len(some)] = self._costs(some)
            yield units(some.shape[0] * some.shape[1])
        known = _Rollouts(rollouts, costs).joined(self._kept)
        self._kept = known.cheapest(self.settings.kept)
        share = probabilities(known.costs, self.settings.sensitivity)
        away = known.paths[:, 1:-1] - self.path[1:-1]
        moved = self.path.copy()
        moved[1:-1] += self.form.smoothing @ np.einsum("kt,ktn->tn", share, away)
        self.path = self.bounds.bring_back(moved, self.form)

    def _draw(self, sigma: float) -> Array:
        """Return rollouts (k, N + 2, n): the path with noise of covariance A^-1, within the limits."""
        inner = self.path[1:-1]
        drawn = self.rng.standard_normal((self.settings.rollouts, *inner.shape))
        rollouts = np.repeat(self.path[None], self.settings.rollouts, axis=0)
        rollouts[:, 1:-1] += sigma * (self.form.noise @ drawn)
        rollouts[:, 1:-1] = np.clip(rollouts[:, 1:-1], self.bounds.lower, self.bounds.upper)
        return rollouts

    def _costs(self, paths: Array) -> Array:
        around = self.settings.obstacle_weight * self.cost.costs(paths)
        return np.asarray(around + self.form.costs(paths)[:, 1:-1])


def probabilities(costs: Array, sensitivity: float) -> Array:
    """Return the share (k, N) of each rollout at each point; they add up to one (2011, eq. 11)."""
    low, high = costs.min(axis=0), costs.max(axis=0)
    weights = np.exp(-sensitivity * (costs - low) / np.maximum(high - low, 1e-12))
    return np.asarray(weights / weights.sum(axis=0))
