"""CHOMP: a path goes down the gradient of its cost, and the whole of it bends along.

Ratliff, Zucker, Bagnell and Srinivasa, "CHOMP: Gradient Optimization Techniques for Efficient Motion
Planning", ICRA 2009; Zucker et al., "CHOMP: Covariant Hamiltonian Optimization for Motion Planning", IJRR
32(9), 2013. Of the latter, not the Hamiltonian Monte Carlo: it draws nothing, and ends in the local minimum
next to where it began.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass

import numpy as np

from tandem.skills.arm.optimising.limits import Bounds
from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.arm.optimising.settings import ChompSettings
from tandem.skills.arm.optimising.smoothness import Smoothness
from tandem.skills.arm.optimising.work import units
from tandem.skills.kinematics.transforms import Array


@dataclass
class Chomp:
    """One path under way.

    Attributes:
        path: weighed joint positions (N + 2, n).
        form: its smoothness.
        cost: of its surroundings.
        bounds: limits.
        settings: rate and weights.
    """

    path: Array
    form: Smoothness
    cost: ObstacleCost
    bounds: Bounds
    settings: ChompSettings

    def settle(self) -> None:
        """Go on as before."""

    def advance(self) -> Generator[int, None, None]:
        """Go one step: x - A^-1 (grad smoothness + weight * grad obstacles) / eta (2013, eq. 11)."""
        weighed = self.settings.obstacle_weight * self.cost.gradient(self.path)
        step = self.form.inverse @ (self.form.gradient(self.path) + weighed) * self.settings.rate
        longest = float(np.max(np.linalg.norm(step, axis=1)))
        step *= min(1.0, self.settings.stride / max(longest, 1e-12))
        moved = self.path.copy()
        moved[1:-1] -= step
        self.path = self.bounds.bring_back(moved, self.form)
        yield units(len(self.path), gradients=True)
