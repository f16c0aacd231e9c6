"""Which planner for an arm among shelves: ``python -m benchmarks.planners --problems 200 --seed 1``.

A problem is the first motion of a pick by the LoCoBot in the room of shelves: from home to joint positions
in front of an item, from which the straight lines that follow can be gone. Drawn are only picks whose
straight motion (in joint space) is blocked, as it needs no planner. Each planner gets the same start, end
and scene through the arm's own ``MovePlanner``, so what is counted is a motion that the exact checker has
found free.

``--passages`` draws another set: the arm goes through a slot between two plates across its way.

CPU: processor time of the whole plan, or of the failure. Length: of the motion over that of the straight
one, weighed joint positions. Roughness: the integral of the squared accelerations of the joints, over its
least for the same way in the same time (12 L^2 / T^3): 1 is a straight line, slow at both ends. Clearance:
the least metres between the arm and the scene on the motion, padding included.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from benchmarks.planner_problems import PlannerProblem, passages, picks, room
from benchmarks.rows import quantile
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.steps import run_through

COMPARED: Final = (
    PlannerName.RRT_CONNECT,
    PlannerName.RRT_STAR,
    PlannerName.STOMP,
    PlannerName.CHOMP,
    PlannerName.RRT_STAR_STOMP,
    PlannerName.RRT_STAR_CHOMP,
)
LOOKS: Final = 40
"""States of a motion at which its clearance is measured."""
HEAD: Final = (
    "planner",
    "solved",
    "CPU ms, median",
    "CPU ms, p95",
    "length",
    "roughness",
    "clearance mm",
    "seconds",
)


@dataclass(frozen=True)
class Outcome:
    """How one planner did with one problem; NaN for what is not known of a failure."""

    solved: bool
    cpu: float
    length: float = float("nan")
    roughness: float = float("nan")
    clearance: float = float("nan")
    duration: float = float("nan")
    why: str = ""


def solve(arm: Arm, planner: MovePlanner, problem: PlannerProblem, seed: int) -> Outcome:
    """Plan one problem, and measure the motion."""
    began = time.process_time()
    plan = run_through(planner.plan(problem.goal, problem.moment, np.random.default_rng(seed)))
    cpu = time.process_time() - began
    if isinstance(plan, Failure):
        return Outcome(solved=False, cpu=cpu, why=f"{plan.kind}: {plan.message}")
    checker = arm.checker(problem.moment, problem.goal)
    checker.touch(allowed=False)
    motion = plan.trajectory
    states = motion.sample(np.linspace(0.0, motion.duration, LOOKS))
    nearest = [checker.clearance(q, to_world=True) for q in states]
    way = np.linalg.norm(np.diff(motion.positions, axis=0) * arm.weights, axis=1).sum()
    straight = np.linalg.norm((motion.positions[-1] - motion.positions[0]) * arm.weights)
    return Outcome(
        solved=True,
        cpu=cpu,
        length=float(way / straight),
        roughness=roughness(motion.times, motion.velocities * arm.weights),
        clearance=min((each.distance for each in nearest if each is not None), default=float("nan")),
        duration=motion.duration,
    )


def roughness(times: Array, velocities: Array) -> float:
    """Return the integral of squared accelerations times T^3 / (12 L^2), from velocities (k, n)."""
    steps = np.diff(times)
    accelerations = np.diff(velocities, axis=0) / steps[:, None]
    speeds = np.linalg.norm(velocities, axis=1)
    length = float(np.sum(0.5 * (speeds[1:] + speeds[:-1]) * steps))
    squared = float(np.sum(np.sum(accelerations**2, axis=1) * steps))
    return squared * float(times[-1] - times[0]) ** 3 / (12.0 * length**2)


def compare(
    arm: Arm, problems: Sequence[PlannerProblem], names: Sequence[PlannerName]
) -> Iterator[tuple[PlannerName, list[Outcome]]]:
    """Return each planner's outcomes, one planner after the other."""
    for name in names:
        planner = MovePlanner(arm, PlannerSettings(planner=name), "benchmark")
        yield name, [solve(arm, planner, each, number) for number, each in enumerate(problems)]


def line(name: PlannerName, outcomes: Sequence[Outcome]) -> tuple[str, ...]:
    """Return a line of the table: medians over what was solved, CPU over everything."""
    good = [each for each in outcomes if each.solved]

    def median(values: Iterator[float], form: str, scale: float = 1.0) -> str:
        return format(scale * quantile(values, 0.5), form)

    return (
        name.value,
        f"{len(good)} of {len(outcomes)}",
        median((each.cpu for each in outcomes), ".0f", 1e3),
        f"{1e3 * quantile((each.cpu for each in outcomes), 0.95):.0f}",
        median((each.length for each in good), ".2f"),
        median((each.roughness for each in good), ".2f"),
        median((each.clearance for each in good), ".1f", 1e3),
        median((each.duration for each in good), ".2f"),
    )


def main(argv: list[str] | None = None) -> None:
    """Print the table, a line as soon as it is known, and why planners failed."""
    parser = argparse.ArgumentParser(prog="planners", description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("--problems", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--passages", action="store_true", help="slots between plates instead of shelf picks")
    parser.add_argument("--planner", action="append", type=PlannerName, help="only this one; may be repeated")
    given = parser.parse_args(argv)
    world = room()
    draw = passages if given.passages else picks
    problems, left_out = draw(world, given.problems, given.seed)
    print(f"{len(problems)} problems, seed {given.seed}; drawn and left out: {left_out}", flush=True)
    for row in (HEAD, ("---",) * len(HEAD)):
        print(f"| {' | '.join(row)} |", flush=True)
    reasons: Counter[str] = Counter()
    for name, outcomes in compare(world.arm, problems, given.planner or COMPARED):
        print(f"| {' | '.join(line(name, outcomes))} |", flush=True)
        reasons.update(f"{name.value}: {each.why}" for each in outcomes if not each.solved)
    for reason, count in reasons.most_common():
        print(f"{count:4}  {reason}")
    print(f"{time.process_time():.0f} s of CPU in all", file=sys.stderr)


if __name__ == "__main__":
    main()
