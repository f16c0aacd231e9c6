"""One free path from where a group stands to any of several places."""

from __future__ import annotations

from collections.abc import Generator, Sequence

import numpy as np

from tandem.skills.arm.optimising.plan import optimised_path
from tandem.skills.arm.planning.motions import Motions
from tandem.skills.arm.planning.ompl_planner import search
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.planning.shortcut import shorten
from tandem.skills.kinematics.transforms import Array


def find_path(
    motions: Motions,
    start: Array,
    goals: Sequence[Array],
    rng: np.random.Generator,
    settings: PlannerSettings,
) -> Generator[int, None, Array | None]:
    """Return waypoints (m, n) of a short free path to one of the goals, or None.

    OMPL finds it, and shortcuts make it shorter; or it is optimised, and then the caller drives it as a
    curve.

    It is free at the motions' step; the caller checks the timed motion in finer ones.

    Args:
        motions: what is free.
        start: joint positions (n,), free.
        goals: joint positions, free, each (n,), the preferred first.
        rng: all that is drawn.
        settings: the planner and its bounds.

    Yields:
        The checks just done, a few milliseconds' worth at the most.
    """
    limits = motions.space.limits
    within = np.clip(start, limits.lower, limits.upper)  # it may stand a hair beyond one
    if settings.planner.optimises:
        return (yield from optimised_path(motions, start, goals, rng, settings))
    path = yield from search(motions, within, goals, rng, settings)
    if path is None:
        return None
    path[0] = start
    return (yield from shorten(motions, path, rng, settings))
