"""Paths by STOMP and CHOMP as the arm's planner takes them: alone, or seeded by RRT*."""

from __future__ import annotations

from collections.abc import Generator, Sequence

import numpy as np

from tandem.skills.arm.optimising.chomp import Chomp
from tandem.skills.arm.optimising.first_guess import near
from tandem.skills.arm.optimising.limits import Bounds
from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.arm.optimising.optimised import optimise
from tandem.skills.arm.optimising.settings import OptimiserSettings
from tandem.skills.arm.optimising.smoothness import Smoothness, smoothness
from tandem.skills.arm.optimising.stomp import Stomp
from tandem.skills.arm.optimising.surroundings_cost import around
from tandem.skills.arm.planning.motions import Motions
from tandem.skills.arm.planning.ompl_planner import search
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.planning.shortcut import shorten
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.planners import PlannerName


def optimised_path(
    motions: Motions,
    start: Array,
    goals: Sequence[Array],
    rng: np.random.Generator,
    settings: PlannerSettings,
) -> Generator[int, None, Array | None]:
    """Return points (N + 2, n) of a smooth free path to one of the goals, or None.

    Arguments and what it yields are those of ``planning.path.find_path``.
    """
    if settings.planner.seeded:
        seeding = settings.model_copy(update={"planner": PlannerName.RRT_STAR})
        found = yield from search(motions, start, goals, rng, seeding)
        if found is None:
            return None
        seeds = [(yield from shorten(motions, found, rng, settings))]
    else:
        seeds = [np.array([start, goal]) for goal in goals]
    for seed in seeds:
        path = yield from _optimised(motions, seed, rng, settings)
        if path is not None:
            return path
    return None


def _optimised(
    motions: Motions, seed: Array, rng: np.random.Generator, settings: PlannerSettings
) -> Generator[int, None, Array | None]:
    """Return a path that began near the seed (m, n)."""
    own: OptimiserSettings = settings.stomp if settings.planner.is_stomp else settings.chomp
    space, form = motions.space, smoothness(own.points)
    cost = yield from around(motions.checker, space.weights, seed[[0, -1]], own.margin)
    bounds = Bounds(space.limits.lower * space.weights, space.limits.upper * space.weights)
    begun = _begin(seed * space.weights, form, own.follow)
    optimiser = _optimiser(begun, form, cost, bounds, rng, settings)
    return (yield from optimise(motions, optimiser, own))


def _begin(waypoints: Array, form: Smoothness, follow: float) -> Array:
    if len(waypoints) == 2:  # noqa: PLR2004 - a straight line
        return form.smoothest(waypoints[0], waypoints[1])
    return near(waypoints, form, follow)


def _optimiser(  # noqa: PLR0917 - what both take
    path: Array,
    form: Smoothness,
    cost: ObstacleCost,
    bounds: Bounds,
    rng: np.random.Generator,
    settings: PlannerSettings,
) -> Stomp | Chomp:
    if settings.planner.is_stomp:
        return Stomp(path, form, cost, bounds, settings.stomp, rng)
    return Chomp(path, form, cost, bounds, settings.chomp)
