"""OMPL's planners over a group's motions, in slices.

OMPL draws its seeds from one process-wide generator when a sampler is made. It is seeded anew before each
slice, from the plan's own generator, so that a plan is the same whatever was planned before or between.
A planner that does not ask often whether to stop is brought to it: beyond its checks every motion counts
as blocked, which is safe, and it comes back at once. AORRTC can't be taken up again: all its checks are one
slice. RRT* grows one tree; two of them race, one from either end.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence

import numpy as np
from ompl import base as ob
from ompl import geometric as og
from ompl import util as ou

from tandem.skills.arm.planning.motions import Motions
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.planners import PlannerName

_MAKERS = {
    PlannerName.RRT_CONNECT: og.RRTConnect,
    PlannerName.RRT_STAR: og.RRTstar,
    PlannerName.BIT_STAR: og.BITstar,
    PlannerName.AORRTC: og.AORRTC,
}
OVERDRAFT = 2
"""Slices' worth of checks after which motions are called blocked until the slice ends."""


class _Validator(ob.MotionValidator):  # type: ignore[misc]
    """Checks motions in the weighed space; counts, and refuses once the account is empty."""

    def __init__(self, information: ob.SpaceInformation, motions: Motions, account: _Account) -> None:
        super().__init__(information)
        self._motions, self._account = motions, account
        self._n, self._weights = len(motions.space.weights), motions.space.weights

    def checkMotion(self, a: ob.State, b: ob.State) -> bool:  # noqa: N802
        if self._account.overdrawn():
            return False
        n = self._n
        start, end = np.array(a[0:n]) / self._weights, np.array(b[0:n]) / self._weights
        return self._motions.free(start, end)


class _Account:
    """The checks of one slice."""

    def __init__(self, motions: Motions, each: int) -> None:
        self._checker, self._each = motions.checker, each
        self._start = 0

    def open(self) -> None:
        self._start = self._checker.checks

    def spent(self) -> bool:
        return self._checker.checks - self._start >= self._each

    def overdrawn(self) -> bool:
        return self._checker.checks - self._start >= OVERDRAFT * self._each


def search(
    motions: Motions,
    start: Array,
    goals: Sequence[Array],
    rng: np.random.Generator,
    settings: PlannerSettings,
) -> Generator[int, None, Array | None]:
    """Look for a free path from the start to any of the goals.

    Args:
        motions: what is free; also the space.
        start: free joint positions (n,).
        goals: free joint positions, each (n,).
        rng: its draws seed OMPL.
        settings: which planner, and its bounds.

    Yields:
        The checks of each slice.

    Returns:
        Waypoints (m, n) from the start to a goal, or None.
    """
    ou.setLogLevel(ou.LOG_NONE)
    star = settings.planner is PlannerName.RRT_STAR
    budget = settings.improving_checks if settings.planner.improves else settings.checks
    budget = settings.star_checks if star else budget
    trees = [_Search(motions, [start], goals, rng, settings, budget)]
    if (
        star
    ):  # one tree gets out of a narrow place, but hardly into it: where there is more room, nobody knows
        trees.append(_Search(motions, goals, [start], rng, settings, budget))
    spent = idle = 0
    improving = False
    while spent < budget and idle < settings.slice_checks:
        for each in trees:
            checks = each.go_on(rng)
            yield checks
            spent += checks
            idle = 0 if checks else idle + 1
        solved = [each for each in trees if each.solved]
        if trees[0].whole or (solved and not settings.planner.improves):
            break
        if star and solved and not improving:
            trees, improving = solved[:1], True
            budget = min(budget, spent + settings.star_after)
    found = next((each.path() for each in trees if each.solved), None)
    if found is None:
        return None
    return found if np.allclose(found[0], start) else found[::-1]


class _Search:
    """One of OMPL's planners at work.

    Args:
        motions: what is free.
        starts: where its tree begins, each (n,).
        goals: where it may end, each (n,).
        rng: its draws seed OMPL.
        settings: which planner, and its bounds.
        budget: checks that one that can't be taken up again may use.
    """

    def __init__(  # noqa: PLR0917 - the problem's parts, in one order everywhere
        self,
        motions: Motions,
        starts: Sequence[Array],
        goals: Sequence[Array],
        rng: np.random.Generator,
        settings: PlannerSettings,
        budget: int,
    ) -> None:
        self.whole = settings.planner is PlannerName.AORRTC
        """Whether all of it is one slice: solving a second time crashes OMPL 2.0.1."""
        self._motions = motions
        self._account = _Account(motions, budget if self.whole else settings.slice_checks)
        information = _information(motions, self._account)
        self._problem = _problem(information, motions.space.weights, starts, goals)
        ou.RNG.setSeed(_seed(rng))
        self._planner = _MAKERS[settings.planner](information)
        if settings.planner is PlannerName.RRT_STAR:
            self._planner.setRange(settings.star_edge)
        elif settings.planner is not PlannerName.BIT_STAR:
            self._planner.setRange(settings.longest_edge)
        self._planner.setProblemDefinition(self._problem)
        self._planner.setup()

    def go_on(self, rng: np.random.Generator) -> int:
        """Do a slice; return its checks."""
        ou.RNG.setSeed(_seed(rng))
        self._account.open()
        before = self._motions.checker.checks
        self._planner.solve(ob.PlannerTerminationCondition(self._account.spent))
        return self._motions.checker.checks - before

    @property
    def solved(self) -> bool:
        """Whether it has a path."""
        return bool(self._problem.hasExactSolution())

    def path(self) -> Array:
        """Return its path as waypoints (m, n), from a start to a goal."""
        weights = self._motions.space.weights
        states = self._problem.getSolutionPath().getStates()
        return np.array([state[0 : len(weights)] for state in states]) / weights


def _seed(rng: np.random.Generator) -> int:
    return int(rng.integers(1, 2**31))


def _information(motions: Motions, account: _Account) -> ob.SpaceInformation:
    limits, weights = motions.space.limits, motions.space.weights
    n = len(weights)
    space = ob.RealVectorStateSpace(n)
    bounds = ob.RealVectorBounds(n)
    for i in range(n):
        bounds.setLow(i, float(limits.lower[i] * weights[i]))
        bounds.setHigh(i, float(limits.upper[i] * weights[i]))
    space.setBounds(bounds)
    information = ob.SpaceInformation(space)
    free = motions.checker.free
    information.setStateValidityChecker(lambda state: free(np.array(state[0:n]) / weights))
    information.setMotionValidator(_Validator(information, motions, account))
    information.setup()
    return information


def _problem(
    information: ob.SpaceInformation, weights: Array, starts: Sequence[Array], goals: Sequence[Array]
) -> ob.ProblemDefinition:
    problem = ob.ProblemDefinition(information)
    for start in starts:
        problem.addStartState(_state(information, start * weights))
    targets = ob.GoalStates(information)
    for goal in goals:
        targets.addState(_state(information, goal * weights))
    problem.setGoal(targets)
    return problem


def _state(information: ob.SpaceInformation, x: Array) -> ob.State:
    state = information.allocState()
    for i, value in enumerate(x):
        state[i] = float(value)
    return state
