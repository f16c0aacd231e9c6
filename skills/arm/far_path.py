"""Paths of planners that can't be sliced: the same problem, made again in a worker."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np

from tandem.skills.arm.planning.motions import Motions, Space
from tandem.skills.arm.planning.path import find_path
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.robot_description import RobotDescription

CHECK_COST: Final = 25e-6
"""Robot seconds that lockstep charges for a collision check."""


@dataclass(frozen=True)
class FarProblem:
    """What is free: the robot, its group, what was believed, what the goal permits, the share of the step."""

    description: RobotDescription
    group: str
    moment: Moment
    goal: MoveGoal
    share: float


@dataclass(frozen=True)
class FarJob:
    """From where (n,) to any of which joint positions, how, and the seed of all that is drawn."""

    problem: FarProblem
    start: Array
    ends: tuple[Array, ...]
    settings: PlannerSettings
    seed: int


@dataclass(frozen=True)
class FarPath:
    """Waypoints (m, n), or None if no way was found."""

    points: Array | None


def elsewhere(compute: Compute, job: FarJob) -> Generator[int, None, Array | None]:
    """Have the path planned by a worker; yields 0 while it is waited for."""
    cost = job.settings.improving_checks * CHECK_COST
    work = compute.submit(far_path, job, cost=cost)
    while not work.done():
        yield 0
    return work.result().points


def far_path(job: FarJob) -> FarPath:
    """Plan in one go."""
    problem = job.problem
    arm = _arm(problem.description.model_dump_json(), problem.group)
    checker = arm.checker(problem.moment, problem.goal)
    checker.let_rest(job.start)
    motions = Motions(checker, Space(arm.limits, arm.weights))
    motions.step *= problem.share
    planning = find_path(motions, job.start, job.ends, np.random.default_rng(job.seed), job.settings)
    while True:
        try:
            next(planning)
        except StopIteration as stop:
            return FarPath(stop.value)


@lru_cache(maxsize=2)
def _arm(description: str, group: str) -> Arm:
    """Return the arm; kept by the worker, which plans for the same one again."""
    robot = RobotDescription.model_validate_json(description)
    return Arm(load_hulls(robot), robot, group)
