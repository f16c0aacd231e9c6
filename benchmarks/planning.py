"""Planning with coal alone and with the field: ``python -m benchmarks.planning --robot panda --set cage``.

Each problem is planned twice in a row from the same seed, once with either check, and everything counts from
the goal to the checked trajectory, the field included, which is made anew as each problem has a scene of its
own. Times are of the processor. Then so many random states of some problems are asked of both checks.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.planning_sets import ROBOTS, SETS, Planned, Stand, problem, stand
from benchmarks.rows import Row, quantile
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Plan
from tandem.skills.kinematics.pair_tables import CONTACT, DOUBT, FREE
from tandem.skills.kinematics.world_field import installed
from tandem.skills.ports.failure import Failure

PROBLEMS = 100
CHECKS = 400_000
"""The planner's bound here: high enough that a problem that has a solution is solved."""
SCENES = 10
"""Problems over which the random states are spread."""


@dataclass(frozen=True)
class Once:
    """One plan: processor time in seconds, the planner's checks, and, if it is one, its weighed metres."""

    cpu: float
    units: int
    length: float | None


@dataclass(frozen=True)
class Agreement:
    """Of random states: how many, how many the field decided alone, and how many both checks say alike."""

    states: int
    decided: int
    alike: int


def plan(of: Stand, of_problem: Planned, *, seed: int) -> Once:
    """Plan a problem with the check that the arm has now."""
    planner = MovePlanner(of.arm, PlannerSettings(checks=CHECKS), "benchmark")
    began, units = time.process_time(), 0
    steps = planner.plan(of_problem.goal, of_problem.moment, np.random.default_rng(seed))
    ended: Plan | Failure
    while True:
        try:
            units += next(steps)
        except StopIteration as stop:
            ended = stop.value
            break
    cpu = time.process_time() - began
    if isinstance(ended, Failure):
        return Once(cpu, units, None)
    ways = np.diff(ended.trajectory.positions, axis=0) * of.arm.weights
    return Once(cpu, units, float(np.linalg.norm(ways, axis=1).sum()))


def both(of: Stand, of_problem: Planned, *, seed: int) -> tuple[Once, Once]:
    """Plan a problem with coal alone, then with the field."""
    world = of.arm.world
    of.arm.world = None
    try:
        before = plan(of, of_problem, seed=seed)
    finally:
        of.arm.world = world
    return before, plan(of, of_problem, seed=seed)


def agreement(of: Stand, of_problem: Planned, states: int, rng: np.random.Generator) -> Agreement:
    """Ask both checks about random states; half of them are near the problem's ends, where things are."""
    checker = of.arm.checker(of_problem.moment, of_problem.goal)
    limits = of.arm.limits
    drawn = rng.uniform(limits.lower, limits.upper, size=(states, len(limits.lower)))
    near = np.array([of.arm.start(of_problem.moment), of_problem.goal.joints])
    half = states // 2
    drawn[:half] = np.clip(
        near[rng.integers(2, size=half)] + rng.normal(0.0, 0.2, size=(half, len(limits.lower))),
        limits.lower,
        limits.upper,
    )
    world = of.arm.world
    of.arm.world = None
    alone = of.arm.checker(of_problem.moment, of_problem.goal)
    of.arm.world = world
    true = np.array([alone.free(q) for q in drawn])
    found = checker.look(drawn)
    alike = (found == DOUBT) | ((found == FREE) & true) | ((found == CONTACT) & ~true)
    return Agreement(states, int((found != DOUBT).sum()), int(alike.sum()))


def measure(of: Stand, name: str, *, problems: int, states: int, seed: int = 1) -> list[Row]:
    """Return the figures of one set."""
    drawn: list[Planned] = []
    number = none = 0
    while len(drawn) < problems:
        try:
            drawn.append(problem(name, of, number, seed))
        except LookupError:
            none += 1
        number += 1
    pairs = [both(of, each, seed=k) for k, each in enumerate(drawn)]
    some = drawn[:SCENES]
    rng = np.random.default_rng(seed)
    asked = [agreement(of, each, states // len(some), rng) for each in some]
    return rows(name, pairs, asked)


def rows(name: str, pairs: Sequence[tuple[Once, Once]], asked: Sequence[Agreement]) -> list[Row]:
    """Return the lines of the table."""
    found = []
    middles, tails = [], []
    for which, what in enumerate(("coal alone", "the field")):
        plans = [pair[which] for pair in pairs]
        cpu = [each.cpu for each in plans]
        solved = sum(each.length is not None for each in plans)
        middles.append(quantile(cpu, 0.5))
        tails.append(quantile(cpu, 0.95))
        note = f"of {len(plans)}"
        found += [
            Row(f"{name}, {what}, solved", 100.0 * solved / len(plans), "%", 100.0, more=True, note=note),
            Row(f"{name}, {what}, CPU median", 1e3 * middles[-1], "ms"),
            Row(f"{name}, {what}, CPU p95", 1e3 * tails[-1], "ms"),
        ]
    ratios = [
        after.length / before.length
        for before, after in pairs
        if before.length is not None and after.length is not None
    ]
    states = sum(each.states for each in asked)
    decided = sum(each.decided for each in asked)
    found += [
        Row(f"{name}, field to coal, median", middles[1] / middles[0], "", 0.4),
        Row(f"{name}, field to coal, p95", tails[1] / tails[0], "", 0.25),
        Row(f"{name}, field to coal, path length, mean", float(np.mean(ratios)), "", 1.05),
        Row(f"{name}, states on which both agree", sum(each.alike for each in asked), "", states, more=True),
        Row(f"{name}, states that the field decides", 100.0 * decided / max(1, states), "%"),
    ]
    return found


def main(argv: list[str] | None = None) -> int:
    """Print the figures; exit 1 if the checks disagree about a state."""
    parser = argparse.ArgumentParser(prog="planning", description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("--robot", choices=ROBOTS, action="append", help="may be repeated; all unless given")
    parser.add_argument(
        "--set", choices=sorted(SETS), action="append", help="may be repeated; all unless given"
    )
    parser.add_argument("--problems", type=int, default=PROBLEMS)
    parser.add_argument("--states", type=int, default=2_000, help="random states of each set")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args(argv)
    if not installed():
        print(
            "planning: the distance field needs numba: pip install 'tandem-executive[fast]'", file=sys.stderr
        )
        return 2
    agree = True
    for robot in given.robot or ROBOTS:
        of = stand(robot)
        for name in given.set or sorted(SETS):
            for row in measure(of, name, problems=given.problems, states=given.states, seed=given.seed):
                aim = "" if row.aim is None else f"(aim {row.aim:g}) "
                print(f"{robot:12}{row.what:50} {row.value:10.2f} {row.unit} {aim}{row.note}", flush=True)
                agree &= "agree" not in row.what or row.value == row.aim
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
