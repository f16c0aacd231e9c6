"""A joint that stayed behind: the arm goes on only when that joint follows a small step."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.doubt import STEP, Doubt, small_steps
from tandem.skills.arm.problem import Arm
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.action import GoalCommand, GoalState, command_service
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import TrajectoryGoal
from tandem.skills.ports.skill import Command
from tests.fakes.arm_rig import PANDA_HOME, ArmRig, panda

ELBOW = "panda_joint4"
COLUMN = 3
SIDE = tuple(q + d for q, d in zip(PANDA_HOME, (0.6, 0.2, 0.0, 0.4, 0.0, 0.0, 0.0), strict=True))


@pytest.fixture
def stuck(hulls: RobotHulls) -> ArmRig:
    """Return an arm whose elbow has stalled on the way to SIDE, and is stuck still."""
    rig = ArmRig(panda(), "arm", hulls=hulls)
    rig.hardware.stuck = ELBOW
    status = rig.run(MoveGoal(joints=SIDE))
    assert status.failure is not None
    assert status.failure.kind is FailureKind.ARM_STOPPED
    return rig


def moving(goal: TrajectoryGoal) -> list[int]:
    """Return the columns of the joints that a motion moves."""
    first, last = np.array(goal.points[0].positions), np.array(goal.points[-1].positions)
    return [int(k) for k in np.flatnonzero(np.abs(last - first) > 1e-9)]


def test_while_a_joint_is_stuck_nothing_else_is_asked_to_move(stuck: ArmRig) -> None:
    stands, before = dict(stuck.hardware.positions), len(stuck.hardware.goals)
    status = stuck.run(MoveGoal(posture="home"), "t/move/2")
    assert status.failure is not None
    assert status.failure.kind is FailureKind.ARM_STOPPED
    assert status.failure.evidence["joint"] == ELBOW
    assert "has not followed" in status.failure.message
    asked = stuck.hardware.goals[before:]
    assert len(asked) > 2, "it is asked again for a while"
    assert {tuple(moving(goal)) for goal in asked} == {(COLUMN,)}
    assert stuck.hardware.positions == stands


def test_once_it_follows_the_motion_is_planned_from_where_the_arm_stands(stuck: ArmRig) -> None:
    stuck.send(MoveGoal(posture="home"), "t/move/2")
    stuck.rounds(150)
    stuck.hardware.stuck = ""
    status = stuck.until(GoalState.SUCCEEDED, GoalState.FAILED)
    assert np.allclose(stuck.result(status).positions, PANDA_HOME)


def test_a_joint_that_has_followed_is_doubted_no_longer(stuck: ArmRig) -> None:
    stuck.hardware.stuck = ""
    stuck.result(stuck.run(MoveGoal(posture="home"), "t/move/2"))
    before = len(stuck.hardware.goals)
    stuck.result(stuck.run(MoveGoal(joints=SIDE), "t/move/3"))
    assert len(stuck.hardware.goals) == before + 1


def test_a_move_that_waits_for_its_joint_can_be_cancelled(stuck: ArmRig) -> None:
    stuck.send(MoveGoal(posture="home"), "t/move/2")
    stuck.rounds(50)
    command_service("arm/move").query(stuck.bus, GoalCommand(goal_id="t/move/2", command=Command.CANCEL))
    stuck.until(GoalState.CANCELED)


def test_the_step_back_to_where_the_joint_came_from_is_tried_first(hulls: RobotHulls) -> None:
    arm, start = Arm(hulls, panda(), "arm"), np.array(PANDA_HOME)
    ways = [step.positions[-1] - start for step in small_steps(arm, start, Doubt(ELBOW, ahead=0.3))]
    assert [way[COLUMN] for way in ways] == pytest.approx([-STEP, STEP])


def test_no_step_leads_beyond_a_joints_limit(hulls: RobotHulls) -> None:
    arm, start = Arm(hulls, panda(), "arm"), np.array(PANDA_HOME)
    start[COLUMN] = arm.group.limits[COLUMN].upper - STEP / 2.0
    (step,) = small_steps(arm, start, Doubt(ELBOW))
    assert step.positions[-1][COLUMN] < start[COLUMN]
