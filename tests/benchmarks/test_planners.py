"""The comparison of planners: what it measures, and that its problems are problems."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.planner_problems import passages, picks, room
from benchmarks.planners import Outcome, line, roughness, solve
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.motions import Motions, Space
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.ports.planners import PlannerName


def test_a_straight_motion_of_least_acceleration_has_a_roughness_of_one() -> None:
    times = np.linspace(0.0, 3.0, 400)
    share = times / 3.0
    speed = 6.0 * share * (1.0 - share) / 3.0
    assert roughness(times, speed[:, None] * np.array([0.3, -0.4])) == pytest.approx(1.0, rel=0.01)


def test_a_motion_that_stops_between_is_rougher() -> None:
    times = np.linspace(0.0, 3.0, 400)
    speed = np.sin(2.0 * np.pi * times / 3.0)[:, None] ** 2
    assert roughness(times, speed) > 2.0


@pytest.mark.parametrize("draw", [picks, passages])
def test_no_problem_is_solved_by_the_straight_motion_and_one_is_measured(draw: type) -> None:
    world = room()
    (problem,), _ = draw(world, 1, 1)
    checker = world.arm.checker(problem.moment, problem.goal)
    start, end = world.arm.start(problem.moment), np.array(problem.goal.joints)
    assert checker.free(end)
    assert not Motions(checker, Space(world.arm.limits, world.arm.weights)).free(start, end)
    settings = PlannerSettings(planner=PlannerName.RRT_CONNECT)
    outcome = solve(world.arm, MovePlanner(world.arm, settings, "test"), problem, 1)
    assert outcome.solved
    assert outcome.length >= 1.0
    assert outcome.roughness >= 0.95
    assert outcome.clearance > 0.0


def test_failures_count_for_time_only() -> None:
    good = Outcome(solved=True, cpu=0.1, length=1.0, roughness=1.0, clearance=0.02, duration=2.0)
    told = line(PlannerName.CHOMP, [good, Outcome(solved=False, cpu=0.3), good])
    assert told == ("CHOMP", "2 of 3", "100", "300", "1.00", "1.00", "20.0", "2.00")
