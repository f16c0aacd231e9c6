"""A free path by STOMP or CHOMP: optimised until the exact checker finds it free, and a little longer."""

from __future__ import annotations

from collections.abc import Generator
from typing import Final, Protocol

import numpy as np

from tandem.skills.arm.curve import through
from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.arm.optimising.settings import OptimiserSettings
from tandem.skills.arm.optimising.smoothness import Smoothness
from tandem.skills.arm.planning.motions import Motions, halving
from tandem.skills.kinematics.transforms import Array

OVERSHOT: Final = 0.005
"""Radians (or metres) by which a curve may swing beyond the limits of plans: half of their margin."""


class Optimiser(Protocol):
    """One path under way, in weighed joint positions (N + 2, n)."""

    @property
    def path(self) -> Array:
        """As it is now."""
        ...

    @property
    def form(self) -> Smoothness:
        """Its smoothness."""
        ...

    @property
    def cost(self) -> ObstacleCost:
        """Of its surroundings."""
        ...

    def settle(self) -> None:
        """Take note that a free path was found."""
        ...

    def advance(self) -> Generator[int, None, None]:
        """Make it better; yields units of work."""
        ...


def optimise(
    motions: Motions, optimiser: Optimiser, settings: OptimiserSettings
) -> Generator[int, None, Array | None]:
    """Return the cheapest free path (N + 2, n) that came up, in joint positions, or None.

    Args:
        motions: the exact checker.
        optimiser: where it begins, and how it goes on.
        settings: how long.

    Yields:
        Units of work.
    """
    best: Array | None = None
    least, found = np.inf, 0
    for number in range(settings.iterations + 1):
        if number % settings.check_every == 0 and (yield from _free(motions, optimiser.path)):
            total = total_cost(optimiser, settings)
            if best is None:
                found = number
                optimiser.settle()
            if total < least:
                best, least = optimiser.path.copy(), total
        if best is not None and number - found >= settings.polish:
            break
        yield from optimiser.advance()
    return None if best is None else best / motions.space.weights


def total_cost(optimiser: Optimiser, settings: OptimiserSettings) -> float:
    """Return what the optimiser makes smaller."""
    around = float(optimiser.cost.costs(optimiser.path[None]).sum())
    return float(optimiser.form.costs(optimiser.path).sum()) + settings.obstacle_weight * around


def _free(motions: Motions, path: Array) -> Generator[int, None, bool]:
    """Say whether the curve through the points keeps within the limits and is free, at the motions' step."""
    space, counter = motions.space, motions.checker
    curve = through(path / space.weights).points
    if np.any(curve[1:] < space.limits.lower - OVERSHOT) or np.any(curve[1:] > space.limits.upper + OVERSHOT):
        return False
    ways = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(curve * space.weights, axis=0), axis=1))))
    count = max(2, int(np.ceil(ways[-1] / motions.step)) + 1)
    marks = np.searchsorted(ways, np.linspace(0.0, ways[-1], count)[1:-1])
    states = curve[np.minimum(marks, len(curve) - 1)]
    for number in halving(len(states) + 1):
        free = counter.free(states[number - 1])
        yield 1
        if not free:
            return False
    return True
