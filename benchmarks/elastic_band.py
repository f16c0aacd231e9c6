"""Processor time of an elastic band's plan, beside casadi with ipopt: ``python -m benchmarks.elastic_band``.

Tasks are drawn: two metres of way, one or two people, a post. ``--casadi`` also solves the same tasks, one
route and without the post, as a nonlinear programme; it needs ``pip install casadi``. What was made of it:
docs/decisions/013-elastic-band.md.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Iterator
from typing import Any, Final

import numpy as np

from benchmarks.rows import quantile
from tandem.sim.robots.locobot import DRIVE, FOOTPRINT_RADIUS
from tandem.skills.base.band.elastic import Elastic
from tandem.skills.base.band.limits import Begin, Surroundings, Task
from tandem.skills.base.field import DistanceField
from tandem.skills.base.people.forecast import forecast
from tandem.skills.base.people.person_track import Track
from tandem.skills.base.people.segments import Candidate
from tandem.skills.base.planner import Clearances
from tandem.skills.ports.pose import FloorPose

WAY: Final = np.linspace([0.0, 0.0], [2.0, 0.0], 21)
APART: Final = FOOTPRINT_RADIUS + 0.30
PIECES: Final = 14
REPLANS: Final = 4


def main() -> None:
    """Draw, plan, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--count", type=int, default=50, help="tasks")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--casadi", action="store_true", help="solve with casadi and ipopt, too")
    given = parser.parse_args()
    first: list[float] = []
    later: list[float] = []
    solved = 0
    for task in _tasks(given.count, given.seed):
        elastic = Elastic()
        first.append(_timed(elastic, task))
        solved += bool(elastic.routes)
        later += [_timed(elastic, task) for _ in range(REPLANS)]
    print(
        f"{given.count} tasks, seed {given.seed}; processor ms of a plan of up to four routes, median / p95"
    )
    print(f"  first plan     {_spread(first)}   with a route that may be driven: {solved}")
    print(f"  plan at 5 Hz   {_spread(later)}")
    if given.casadi:
        solve = _casadi()
        times, good = [], 0
        for task in _tasks(given.count, given.seed):
            begun = time.process_time()
            good += solve(task)
            times.append(time.process_time() - begun)
        print(f"  casadi, ipopt  {_spread(times)}   one route, solved: {good}")


def _tasks(count: int, seed: int) -> Iterator[Task]:
    rng = np.random.default_rng(seed)
    at = np.linspace(-3.0, 3.0, 121)
    nothing = DistanceField(-10.0, -10.0, 20.0, np.full((2, 2), 9.0))
    for _ in range(count):
        people = [_somebody(rng) for _ in range(int(rng.integers(1, 3)))]
        post = rng.uniform((0.6, -0.5), (1.6, 0.5))
        field = DistanceField(-3.0, -3.0, 0.05, np.hypot(at[None, :] - post[0], at[:, None] - post[1]))
        begin = Begin(FloorPose(x=0.0, y=0.0, yaw=0.0), float(rng.uniform(0.0, 0.6)), 0.0)
        clearances = Clearances(field, FOOTPRINT_RADIUS + 0.03, begin.pose)
        around = Surroundings(clearances, forecast(people, nothing), 0.0, APART)
        yield Task(begin, (2.0, 0.0, 0.0), False, DRIVE, around)


def _somebody(rng: np.random.Generator) -> Track:
    at = rng.uniform((0.8, -1.2), (2.2, 1.2))
    made = Track.of(1, Candidate(float(at[0]), float(at[1]), 0.05, paired=True, parts=()))
    made.state[2:] = rng.uniform((-0.5, -1.0), (0.5, 1.0))
    made.walked = True
    return made


def _timed(elastic: Elastic, task: Task) -> float:
    begun = time.process_time()
    for _ in elastic.plan(task, WAY, 0.0):
        pass
    return time.process_time() - begun


def _spread(seconds: list[float]) -> str:
    return f"{1e3 * quantile(seconds, 0.5):6.1f} / {1e3 * quantile(seconds, 0.95):6.1f}"


def _casadi() -> Callable[[Task], bool]:
    """Return what solves a task as a nonlinear programme, compiled once: limits are constraints."""
    import casadi  # type: ignore[import-not-found,unused-ignore]  # noqa: PLC0415 - not a dependency

    pose, times = casadi.SX.sym("pose", 3, PIECES + 1), casadi.SX.sym("times", PIECES)
    given = casadi.SX.sym("given", 9)  # speed; x, y, vx, vy of two people
    bounds: list[tuple[Any, float, float]] = []
    moment, before = 0.0, given[0]
    for piece in range(PIECES):
        step, mean = pose[:, piece + 1] - pose[:, piece], (pose[2, piece + 1] + pose[2, piece]) / 2
        c, s = casadi.cos(mean), casadi.sin(mean)
        linear, moment = (step[0] * c + step[1] * s) / times[piece], moment + times[piece]
        bounds += [
            (step[1] * c - step[0] * s, 0.0, 0.0),
            (linear, 0.0, DRIVE.forward),
            (step[2] / times[piece], -DRIVE.turn, DRIVE.turn),
            ((linear - before) / times[piece], -DRIVE.acceleration, DRIVE.acceleration),
        ]
        before = linear
        for who in (1, 5):
            off = pose[:2, piece + 1] - given[who : who + 2] - moment * given[who + 2 : who + 4]
            bounds.append((casadi.sumsqr(off), APART**2, casadi.inf))
    fixed = casadi.vertcat(pose[:, 0], pose[:2, PIECES])
    bounds += [(fixed[row], value, value) for row, value in enumerate((0.0, 0.0, 0.0, 2.0, 0.0))]
    programme = {
        "x": casadi.vertcat(casadi.vec(pose), times),
        "p": given,
        "f": casadi.sumsqr(times),
        "g": casadi.vertcat(*[each[0] for each in bounds]),
    }
    options = {"ipopt.print_level": 0, "print_time": 0, "ipopt.sb": "yes", "ipopt.max_iter": 100}
    solver = casadi.nlpsol("band", "ipopt", programme, options)
    straight = np.stack(
        (np.linspace(0.0, 2.0, PIECES + 1), np.zeros(PIECES + 1), np.zeros(PIECES + 1)), axis=1
    )
    start = np.concatenate((straight.reshape(-1), np.full(PIECES, 0.25)))
    least = np.concatenate((np.full(3 * (PIECES + 1), -np.inf), np.full(PIECES, 0.03)))

    def solve(task: Task) -> bool:
        people = task.around.people
        told = [9.0, 9.0, 0.0, 0.0] * 2
        for number, (place, velocity) in enumerate(zip(people.places, people.velocities, strict=True)):
            told[4 * number : 4 * number + 4] = [*place[0], *velocity[0]]
        solver(
            x0=start,
            p=[task.begin.linear, *told],
            lbx=least,
            lbg=[each[1] for each in bounds],
            ubg=[each[2] for each in bounds],
        )
        return bool(solver.stats()["success"])

    return solve


if __name__ == "__main__":
    main()
