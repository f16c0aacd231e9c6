"""How long planning an arm's motions takes in the Demo's world: ``python -m benchmarks.arm_planning``.

Each problem is a pick, as the fetch does it: from home to the pre-grasp (five pitches of the hand are
offered, the grasp and the retraction must follow in straight lines), then straight to the item, straight
away and up with it, and home with it. Everything from the goal to the checked trajectory counts: making the
collision checker, inverse kinematics, straight lines, path, shortcuts, timing and the last check.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from benchmarks.arm_problems import Drawing, Problem, held, states
from benchmarks.rows import Row, quantile
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import load_scenario
from tandem.skills.arm.plan_move import MovePlanner, Steps
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment, Plan
from tandem.skills.arm.timing import bang_bang
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import Failure
from tandem.skills.site import load

PROBLEMS = 100
Step = Literal["pre-grasp", "reach", "retract", "home"]


@dataclass(frozen=True)
class Trial:
    """One motion that was planned, or not; times in seconds."""

    step: Step
    surface: str
    cpu: float
    wall: float
    slices: tuple[float, ...]
    """CPU of each."""
    duration: float
    bound: float
    failure: Failure | None
    plan: Plan | None


def picks(
    drawing: Drawing,
    *,
    problems: int = PROBLEMS,
    seed: int = 1,
    settings: PlannerSettings | None = None,
    only_pre_grasp: bool = False,
) -> list[Trial]:
    """Return the trials of so many picks."""
    hulls = load_hulls(drawing.description)
    planners = {}
    for hand in drawing.description.end_effectors:
        arm = Arm(hulls, drawing.description, hand.group)
        planners[hand.side] = (arm, MovePlanner(arm, settings or PlannerSettings(), "benchmark"))
    rng = np.random.default_rng(seed)
    trials: list[Trial] = []
    drawn = 0
    while drawn < problems:
        problem = drawing.problem(rng)
        if problem is not None:
            arm, planner = planners[problem.side]
            trials += _pick(arm, planner, problem, drawn, only_pre_grasp=only_pre_grasp)
            drawn += 1
    return trials


def _pick(
    arm: Arm, planner: MovePlanner, problem: Problem, number: int, *, only_pre_grasp: bool
) -> list[Trial]:
    moment = problem.moment
    trials = [_solve("pre-grasp", arm, planner, problem, problem.pre_grasp, moment, number)]
    first = trials[-1].plan
    if first is None or only_pre_grasp:
        return trials
    taken = problem.grasps[first.candidate]
    opened = {hand.side: hand for hand in arm.description.end_effectors}[problem.side].gripper
    wide = dict.fromkeys(opened.joints, problem.width / 2.0)
    moment = _at(moment, arm, first, wide)
    trials.append(_solve("reach", arm, planner, problem, problem.straight(taken.grasp), moment, number))
    reached = trials[-1].plan
    if reached is None:
        return trials
    size = next(each.box.size for each in moment.scene.objects if each.item == problem.item)
    closed = dict.fromkeys(opened.joints, size[1] / 2.0)
    moment = held(_at(moment, arm, reached, closed), problem, first.candidate)
    lift = problem.straight(taken.retraction, lift=True)
    trials.append(_solve("retract", arm, planner, problem, lift, moment, number))
    lifted = trials[-1].plan
    if lifted is None:
        return trials
    moment = _at(moment, arm, lifted, {})
    trials.append(_solve("home", arm, planner, problem, MoveGoal(posture="home"), moment, number))
    return trials


def _at(moment: Moment, arm: Arm, plan: Plan, fingers: dict[str, float]) -> Moment:
    end = dict(zip(arm.group.joints, map(float, plan.trajectory.positions[-1]), strict=True))
    return replace(moment, joints=states({**moment.positions, **end, **fingers}))


def _solve(  # noqa: PLR0917 - the parts of a trial
    step: Step,
    arm: Arm,
    planner: MovePlanner,
    problem: Problem,
    goal: MoveGoal,
    moment: Moment,
    number: int,
) -> Trial:
    slices: list[float] = []
    wall, began = time.perf_counter(), time.process_time()
    plan = _timed(planner.plan(goal, moment, np.random.default_rng(number)), slices)
    cpu, wall = time.process_time() - began, time.perf_counter() - wall
    if isinstance(plan, Failure):
        return Trial(step, problem.surface, cpu, wall, tuple(slices), 0.0, 1.0, plan, None)
    ends = plan.trajectory.positions
    bound = bang_bang(ends[0], ends[-1], arm.motion_limits)
    return Trial(step, problem.surface, cpu, wall, tuple(slices), plan.trajectory.duration, bound, None, plan)


def _timed(steps: Steps, slices: list[float]) -> Plan | Failure:
    """Run a plan, noting the CPU of each slice."""
    while True:
        before = time.process_time()
        try:
            next(steps)
        except StopIteration as stop:
            ended: Plan | Failure = stop.value
            return ended
        finally:
            slices.append(time.process_time() - before)


def demo() -> Drawing:
    """Return the drawing of problems in the Demo's world."""
    scenario = load_scenario("Demo")
    return Drawing(robot_model("tiago_dual").description, load(scenario.site), scenario)


def rows(*, quick: bool = False) -> list[Row]:
    """Return the figures of the Demo's world."""
    return summary(picks(demo(), problems=3 if quick else PROBLEMS))


def summary(trials: Sequence[Trial]) -> list[Row]:
    """Return the table's lines."""
    found: list[Row] = []
    for step in ("pre-grasp", "reach", "retract", "home"):
        of_step = [trial for trial in trials if trial.step == step]
        solved = [trial for trial in of_step if trial.failure is None]
        what = f"planning {step}"
        found += [
            Row(
                f"{what}, solved", 100.0 * len(solved) / max(1, len(of_step)), "%", note=f"of {len(of_step)}"
            ),
            Row(f"{what}, CPU median", 1e3 * quantile((t.cpu for t in solved), 0.5), "ms", 10.0),
            Row(f"{what}, CPU p95", 1e3 * quantile((t.cpu for t in solved), 0.95), "ms", 50.0),
            Row(f"{what}, wall median", 1e3 * quantile((t.wall for t in solved), 0.5), "ms"),
            Row(f"{what}, wall p95", 1e3 * quantile((t.wall for t in solved), 0.95), "ms"),
            Row(f"{what}, motion over bang-bang, median", quantile(_ratios(solved), 0.5), "", 1.5),
            Row(f"{what}, motion over bang-bang, p95", quantile(_ratios(solved), 0.95), ""),
        ]
    slices = [1e3 * each for trial in trials for each in trial.slices]
    longest = [1e3 * max(trial.slices) for trial in trials]
    found += [
        Row("planning, slices' CPU, p99", quantile(slices, 0.99), "ms", 5.0),
        Row("planning, longest slice of a plan, median", quantile(longest, 0.5), "ms", 5.0),
        Row("planning, longest slice of a plan, p99", quantile(longest, 0.99), "ms", 5.0),
        Row("planning, longest slice of all", max(longest), "ms"),
    ]
    return found


def _ratios(trials: Sequence[Trial]) -> list[float]:
    return [trial.duration / trial.bound for trial in trials if trial.bound > 0.0]


def main(argv: list[str] | None = None) -> None:
    """Print the figures, and why problems were not solved."""
    parser = argparse.ArgumentParser(prog="arm_planning", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--problems", type=int, default=PROBLEMS)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args(argv)
    trials = picks(demo(), problems=given.problems, seed=given.seed)
    for row in summary(trials):
        print(f"{row.what:50} {row.value:8.2f} {row.unit} {row.note}")
    failed = [(t.step, t.surface, t.failure) for t in trials if t.failure is not None]
    counts = Counter(f"{step}, {surface}: {f.kind} {f.message}" for step, surface, f in failed)
    for reason, count in counts.most_common():
        print(f"{count:4}  {reason}")


if __name__ == "__main__":
    main()
