"""Print how Algorithm 2's k, gamma and mu are found for the robot: ``python -m benchmarks.crossing_tuning``.

It tunes with one draw of pairs of configurations and judges with another one. What was seen, and what was
taken: docs/decisions/005-arms-crossing.md.
"""

from __future__ import annotations

import argparse

import numpy as np

from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.reflex.tuning import Tuned, judge, judge_described, sample, tune


def main() -> None:
    """Sample, tune, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--count", type=int, default=300, help="configurations of each arm")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    description = robot_model("tiago_dual").description
    hulls, how = load_hulls(description), description.arms_crossing
    first, second = (
        sample(hulls, description, np.random.default_rng([given.seed, which]), given.count)
        for which in (0, 1)
    )
    print(f"{given.count} configurations of each arm, each paired with each; another draw to judge with")
    print("clearance (m)  k (m)  gamma  mu    missed   false alarms   (on the other draw)")
    for bound in (0.0, 0.02, 0.03, 0.05):
        found = tune(first, bound)
        print(f"{bound:13.2f}  {_row(judge(second, bound, found.k, found.gamma, found.mu))}")
    if how is not None:
        print(f"as described: clearance {how.clearance}")
        for name, pairs in (("first", first), ("other", second)):
            print(f"  {name} draw   {_row(judge_described(pairs, how))}")


def _row(found: Tuned) -> str:
    return (
        f"{found.k:5.3f}  {found.gamma:5.2f}  {found.mu:4.2f}"
        f"{100.0 * found.missed:8.3f} %  {100.0 * found.false_alarms:10.1f} %"
    )


if __name__ == "__main__":
    main()
