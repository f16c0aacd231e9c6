"""Moves planned by STOMP and CHOMP: free as the exact checker sees it, within limits, repeatable."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.optimising.settings import ChompSettings, StompSettings
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Plan
from tandem.skills.kinematics.bodies import BoxShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.steps import run_through
from tests.fakes.arm_rig import PANDA_HOME, ArmRig, box, panda

JOINTS = panda().group("arm").joints
HOME = dict(zip(JOINTS, PANDA_HOME, strict=True))
START = np.array(PANDA_HOME) + np.array([-0.9, 0.6, 0, 0, 0, 0, 0])
END = np.array(PANDA_HOME) + np.array([0.9, 0.6, 0, 0, 0, 0, 0])
WALL = ("wall", (0.5, 0.05, 0.45), (0.6, 0.0, 0.225))
OPTIMISING = [each for each in PlannerName if each.optimises]
QUICK = {
    "stomp": StompSettings(points=20, rollouts=8, polish=3),
    "chomp": ChompSettings(points=20, polish=3),
}


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    return load_hulls(panda())


def plan(hulls: RobotHulls, settings: PlannerSettings, seed: int = 1, end: Array = END) -> Plan | Failure:
    rig = ArmRig(panda(), "arm", hulls=hulls)
    rig.hardware.positions |= dict(zip(JOINTS, map(float, START), strict=True))
    planner = MovePlanner(Arm(hulls, panda(), "arm"), settings, "arm/move")
    goal = MoveGoal(joints=tuple(map(float, end)))
    return run_through(planner.plan(goal, rig.moment(box(*WALL)), np.random.default_rng(seed)))


@pytest.mark.parametrize("name", OPTIMISING)
def test_a_way_around_the_wall_is_free_within_limits_and_smooth(hulls: RobotHulls, name: PlannerName) -> None:
    found = plan(hulls, PlannerSettings(planner=name, **QUICK))
    assert isinstance(found, Plan), found
    motion = found.trajectory
    dense = motion.sample(np.linspace(0.0, motion.duration, 1500))
    wall = Obstacle(WALL[0], BoxShape(WALL[1]), Pose(position=WALL[2]))
    assert CollisionChecker(hulls, JOINTS, HOME, [wall]).first_contact(dense) is None
    limits = hulls.robot.limits(JOINTS)
    assert np.all(dense >= limits.lower)
    assert np.all(dense <= limits.upper)
    assert np.allclose(dense[[0, -1]], [START, END])
    assert np.all(np.abs(motion.velocities) <= limits.velocity + 1e-9)
    stops = np.linalg.norm(motion.velocities[5:-5], axis=1) < 0.01
    assert not stops.any(), "one curve: it rests at its ends only"


@pytest.mark.parametrize("name", [PlannerName.STOMP, PlannerName.RRT_STAR_CHOMP])
def test_a_seed_gives_one_motion(hulls: RobotHulls, name: PlannerName) -> None:
    one, other = (plan(hulls, PlannerSettings(planner=name, **QUICK), seed=7) for _ in range(2))
    assert isinstance(one, Plan)
    assert isinstance(other, Plan)
    assert np.array_equal(one.trajectory.positions, other.trajectory.positions)


@pytest.mark.parametrize("name", [PlannerName.STOMP, PlannerName.CHOMP])
def test_a_goal_in_contact_is_refused(hulls: RobotHulls, name: PlannerName) -> None:
    found = plan(hulls, PlannerSettings(planner=name), end=0.5 * (START + END))
    assert isinstance(found, Failure)
    assert found.kind is FailureKind.NO_IK
    assert "wall" in found.message


@pytest.mark.parametrize(
    "settings",
    [
        PlannerSettings(planner=PlannerName.CHOMP, chomp=ChompSettings(iterations=1)),
        PlannerSettings(planner=PlannerName.STOMP, stomp=StompSettings(iterations=1)),
    ],
)
def test_what_is_not_free_in_time_is_no_plan(hulls: RobotHulls, settings: PlannerSettings) -> None:
    found = plan(hulls, settings)
    assert isinstance(found, Failure)
    assert found.kind is FailureKind.NO_PATH
    assert found.evidence["planner"] == settings.planner.value
