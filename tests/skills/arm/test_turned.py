"""An arm of five joints takes poses turned about what they are for; one of seven takes them as they are."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment, Plan
from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.geometry.poses import distance, from_rpy, turned
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.grasping.tag_grasps import grasp
from tandem.skills.grasping.turns import to_go_on, to_grasp
from tandem.skills.kinematics.described import by_name, home_positions, load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.actions.arm import Candidate, MoveGoal, TurnAbout
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.shapes import BoxShape
from tandem.skills.ports.steps import run_through
from tandem.skills.ports.world import PlanningScene
from tests.fakes.arm_rig import panda
from tests.fakes.examples import example_cart

BOX = BoxShape((0.06, 0.06, 0.06))
ITEM = Pose(position=(0.75, 0.0, 0.74), orientation=from_rpy(0.0, 0.0, math.pi))
WAY = grasp(tag_of_item(ITEM, 0.06), 0.06, math.radians(45.0))
ASIDE = FloorPose(x=0.0, y=0.04, yaw=0.02)
"""Of where the arm points straight at the item: what a base may be off after driving."""
TURN = to_grasp(ITEM.position, BOX, 0.085)
STAMP = RobotTime(seconds=1.0, boot="b")


@pytest.fixture(scope="module")
def cart() -> Arm:
    description: RobotDescription = example_cart().ROBOT.compose().description
    return Arm(load_hulls(description), description, "arm_single")


def moment(arm: Arm, q: np.ndarray | None = None) -> Moment:
    positions = dict(home_positions(arm.description))
    if q is not None:
        positions |= dict(zip(arm.group.joints, map(float, q), strict=True))
    names, values = tuple(positions), tuple(positions.values())
    rest = (0.0,) * len(names)
    joints = JointStates(stamp=STAMP, names=names, positions=values, velocities=rest, efforts=rest)
    return Moment(joints, PlanningScene(stamp=STAMP, version=1, objects=()), ASIDE)


def plan(arm: Arm, goal: MoveGoal, q: np.ndarray | None = None) -> Plan | Failure:
    planner = MovePlanner(arm, PlannerSettings(), "move")
    return run_through(planner.plan(goal, moment(arm, q), np.random.default_rng(1)))


def pre_grasp(turn: TurnAbout | None) -> MoveGoal:
    candidate = Candidate(pose=WAY.pre_grasp, followed_by=(WAY.grasp, WAY.retraction))
    return MoveGoal(candidates=(candidate,), turn=turn)


def test_a_base_a_little_aside_puts_no_grasp_out_of_reach(cart: Arm) -> None:
    planner, rng = MovePlanner(cart, PlannerSettings(), "survey"), np.random.default_rng(1)
    assert run_through(planner.reaches(pre_grasp(TURN), moment(cart), rng))
    assert not run_through(planner.reaches(pre_grasp(None), moment(cart), rng))


def test_a_field_has_an_end_to_go_for_and_knows_its_turn(cart: Arm) -> None:
    planner = MovePlanner(cart, PlannerSettings(), "approach")
    reached = run_through(planner.reach(pre_grasp(TURN), moment(cart)))
    assert not isinstance(reached, Failure)
    assert 0.01 < abs(reached.turned) <= TURN.most
    assert isinstance(run_through(planner.reach(pre_grasp(None), moment(cart))), Failure)


def test_the_plan_tells_the_turn_and_leads_to_the_turned_pose(cart: Arm) -> None:
    made = plan(cart, pre_grasp(TURN))
    assert isinstance(made, Plan)
    assert 0.01 < abs(made.turned) <= TURN.most
    end = by_name(cart.group.joints, made.trajectory.positions[-1])
    hand = cart.description.end_effector("single")
    there = cart.hulls.robot.pose(hand.frame, {**home_positions(cart.description), **end})
    assert made.target_in_base is not None
    assert distance(there, made.target_in_base) < 1e-3


def test_no_turn_is_taken_beyond_the_most(cart: Arm) -> None:
    little = TURN.model_copy(update={"most": 0.005})
    assert isinstance(plan(cart, pre_grasp(little)), Failure)


def test_what_follows_is_reached_straight_although_the_base_believes_to_have_shifted(cart: Arm) -> None:
    made = plan(cart, pre_grasp(TURN))
    assert isinstance(made, Plan)
    shifted = turned(WAY.turned(made.turned).grasp, (0.0, 0.0, 0.0), 0.004)
    goal = MoveGoal(candidates=(Candidate(pose=shifted),), straight=True, turn=to_go_on(shifted))
    straight = plan(cart, goal, made.trajectory.positions[-1])
    assert isinstance(straight, Plan)
    assert 0.0 < abs(straight.turned) < 0.02


def test_an_arm_of_seven_joints_plans_as_if_nothing_might_turn(hulls: RobotHulls) -> None:
    def planned(turn: TurnAbout | None) -> Trajectory:
        arm = Arm(hulls, panda(), "arm")
        pose = Pose(position=(0.45, 0.0, 0.4), orientation=from_rpy(math.pi, 0.0, 0.0))
        made = plan(arm, MoveGoal(candidates=(Candidate(pose=pose),), frame="base", turn=turn))
        assert isinstance(made, Plan)
        assert made.turned == 0.0
        return made.trajectory

    free = planned(TurnAbout(point=(0.45, 0.0, 0.0), most=0.5))
    assert np.array_equal(free.positions, planned(None).positions)
