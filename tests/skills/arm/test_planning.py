"""Planning: free at a finer step than it was planned at, in slices, and the same for the same seed."""

from __future__ import annotations

import itertools
from collections.abc import Generator, Sequence

import numpy as np
import pinocchio as pin
import pytest

from tandem.skills.arm.plan_move import LOOKS, MovePlanner
from tandem.skills.arm.planning.motions import Motions, Space, halving, weigh
from tandem.skills.arm.planning.ompl_planner import search
from tandem.skills.arm.planning.path import find_path
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.planning.straight import Broken, Hand, follow
from tandem.skills.arm.problem import Arm, Plan
from tandem.skills.kinematics.bodies import BoxShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.ik import IkAnswer, Solver
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.steps import run_through
from tests.fakes.arm_rig import PANDA_HOME, ArmRig, box, panda

JOINTS = panda().group("arm").joints
HOME = dict(zip(JOINTS, PANDA_HOME, strict=True))
START = np.array(PANDA_HOME) + np.array([-0.9, 0.6, 0, 0, 0, 0, 0])
END = np.array(PANDA_HOME) + np.array([0.9, 0.6, 0, 0, 0, 0, 0])
WALL = Obstacle("wall", BoxShape((0.5, 0.05, 0.6)), Pose(position=(0.6, 0.0, 0.3)))


def motions(hulls: RobotHulls, step: float = 0.025) -> Motions:
    checker = CollisionChecker(hulls, JOINTS, HOME, [WALL])
    limits = hulls.robot.limits(JOINTS)
    return Motions(checker, Space(limits, weigh(checker.chain, limits, "panda_hand_tcp")), step)


def test_a_motion_is_checked_middle_first_and_wholly() -> None:
    assert halving(8)[0] == 4
    assert sorted(halving(8)) == list(range(1, 8))
    assert halving(1) == []


def test_the_path_leads_around_the_wall_and_is_free_where_it_was_checked(hulls: RobotHulls) -> None:
    assert not motions(hulls, 0.01).free(START, END)
    path = run_through(find_path(motions(hulls), START, [END], np.random.default_rng(1), PlannerSettings()))
    assert path is not None
    assert np.allclose(path[0], START)
    assert np.allclose(path[-1], END)
    same = motions(hulls)
    assert all(same.free(a, b) for a, b in itertools.pairwise(path))


def test_what_is_planned_is_free_between_the_checked_states_too(hulls: RobotHulls) -> None:
    rig = ArmRig(panda(), "arm", hulls=hulls)
    rig.hardware.positions |= dict(zip(JOINTS, map(float, START), strict=True))
    wall = box("wall", (0.5, 0.05, 0.6), (0.6, 0.0, 0.3))
    planner = MovePlanner(Arm(hulls, panda(), "arm"), PlannerSettings(), "arm/move")
    goal, checker = MoveGoal(joints=tuple(map(float, END))), motions(hulls).checker
    for seed in range(4):
        plan = run_through(planner.plan(goal, rig.moment(wall), np.random.default_rng(seed)))
        assert isinstance(plan, Plan)
        dense = plan.trajectory.sample(np.linspace(0.0, plan.trajectory.duration, 1500))
        assert checker.first_contact(dense) is None


def test_a_seed_gives_one_path_whatever_was_planned_between(hulls: RobotHulls) -> None:
    paths: list[Array] = []
    for _ in range(2):
        one = search(motions(hulls), START, [END], np.random.default_rng(4), PlannerSettings())
        other = search(motions(hulls), END, [START], np.random.default_rng(len(paths)), PlannerSettings())
        next(other)
        path = run_through(one)
        assert path is not None
        paths.append(path)
    assert np.array_equal(paths[0], paths[1])


def test_slices_are_bounded_by_checks(hulls: RobotHulls) -> None:
    settings = PlannerSettings(slice_checks=40)
    plan = search(motions(hulls), START, [END], np.random.default_rng(2), settings)
    spent = []
    while True:
        try:
            spent.append(next(plan))
        except StopIteration:
            break
    assert len(spent) > 2
    assert max(spent) < 250


@pytest.mark.parametrize("name", [PlannerName.RRT_STAR, PlannerName.BIT_STAR, PlannerName.AORRTC])
def test_the_other_planners_find_a_path_too(hulls: RobotHulls, name: PlannerName) -> None:
    settings = PlannerSettings(planner=name, improving_checks=4000)
    path = run_through(find_path(motions(hulls), START, [END], np.random.default_rng(3), settings))
    assert path is not None
    same = motions(hulls)
    assert all(same.free(a, b) for a, b in itertools.pairwise(path))


def hand(hulls: RobotHulls) -> Hand:
    arm = Arm(hulls, panda(), "arm")
    assert arm.solver is not None
    return Hand(arm.solver, "panda_hand_tcp", hulls.robot.chain(JOINTS, HOME))


def test_a_straight_line_is_straight(hulls: RobotHulls) -> None:
    checker, q = CollisionChecker(hulls, JOINTS, HOME), np.array(PANDA_HOME)
    here = checker.chain.pose(q, "panda_hand_tcp")
    x, y, z = here.position
    there = here.model_copy(update={"position": (x, y + 0.1, z - 0.05)})
    line = run_through(follow(hand(hulls), checker, q, there))
    assert line.broken is None
    points = np.array([checker.chain.pose(each, "panda_hand_tcp").position for each in line.path])
    along = np.array([0.0, 0.1, -0.05])
    off = np.cross(points - points[0], along) / np.linalg.norm(along)
    assert np.max(np.linalg.norm(off, axis=1)) < 5e-4


def test_a_straight_line_into_the_wall_ends_there(hulls: RobotHulls) -> None:
    checker = CollisionChecker(hulls, JOINTS, HOME, [WALL])
    here = checker.chain.pose(START, "panda_hand_tcp")
    there = here.model_copy(update={"position": (0.6, 0.0, 0.35)})
    line = run_through(follow(hand(hulls), checker, START, there))
    assert line.broken is Broken.IN_COLLISION
    assert 0.0 < line.travelled < 1.0


def test_a_pose_that_few_starts_do_not_lead_to_is_looked_for_from_many(
    hulls: RobotHulls, monkeypatch: pytest.MonkeyPatch
) -> None:
    solve = Solver.solve

    def few_lead_nowhere(
        self: Solver, chain: Chain, targets: Sequence[pin.SE3], reference: Array, starts: int
    ) -> Generator[int, None, tuple[IkAnswer, ...]]:
        answers = yield from solve(self, chain, targets, reference, starts)
        return answers if starts > LOOKS[0] else tuple(IkAnswer((), 0.01) for _ in answers)

    monkeypatch.setattr(Solver, "solve", few_lead_nowhere)
    rig = ArmRig(panda(), "arm", hulls=hulls)
    planner = MovePlanner(Arm(hulls, panda(), "arm"), PlannerSettings(), "arm/move")
    there = Candidate(pose=hulls.robot.pose("panda_hand_tcp", HOME))
    reached = run_through(planner.reach(MoveGoal(candidates=(there,), frame="base"), rig.moment()))
    assert not isinstance(reached, Failure)
    assert reached.candidate == 0
