"""The move of an arm, on a robot known by its description alone."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tandem.skills.arm.move import Move
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import LIMIT_MARGIN, Arm, Plan
from tandem.skills.arm.status import ArmStatusBoard
from tandem.skills.geometry.poses import from_rpy
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.action import GoalCommand, GoalState, GoalStatus, command_service, status_topic
from tandem.skills.ports.actions.arm import (
    MOST_CORNERS,
    ArmState,
    Candidate,
    MoveFeedback,
    MoveGoal,
    MovePhase,
)
from tandem.skills.ports.actions.bimanual import RIGHT_OF_WAY, ArmOrder, Order, RightOfWay
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.skill import Command, Slice
from tandem.skills.ports.steps import run_through
from tandem.skills.ports.world import SceneObject
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.workers import InlineCompute
from tests.fakes.arm_rig import PANDA_HOME, ArmRig, box, panda

DOWN = from_rpy(np.pi, 0.0, 0.0)
SIDE = tuple(q + d for q, d in zip(PANDA_HOME, (0.6, 0.2, 0, 0, 0, 0, 0), strict=True))


def pose(x: float, y: float, z: float) -> Candidate:
    return Candidate(pose=Pose(position=(x, y, z), orientation=DOWN))


def test_it_moves_to_joints_and_tells_its_states(rig: ArmRig) -> None:
    result = rig.result(rig.run(MoveGoal(joints=SIDE)))
    assert np.allclose(result.positions, SIDE)
    rig.rounds(60)
    assert rig.states == [ArmState.ARM_IDLE, ArmState.ARM_RUNNING, ArmState.ARM_SUCCESS, ArmState.ARM_IDLE]


def test_it_moves_the_hand_to_a_pose_and_in_a_straight_line(rig: ArmRig) -> None:
    assert rig.result(rig.run(MoveGoal(candidates=(pose(0.45, -0.2, 0.4),)))).error < 1e-3
    down = rig.result(rig.run(MoveGoal(candidates=(pose(0.45, -0.2, 0.3),), straight=True), "b"))
    assert down.error < 1e-3


@pytest.mark.parametrize(("lost", "failure"), [(2, None), (3, FailureKind.HARDWARE_LOST)])
def test_a_goal_whose_answer_is_lost_is_sent_again(
    rig: ArmRig, lost: int, failure: FailureKind | None
) -> None:
    rig.hardware.answers_lost = lost
    status = rig.run(MoveGoal(joints=SIDE))
    assert (None if status.failure is None else status.failure.kind) is failure
    assert len(rig.hardware.goals) == 1, "the hardware knows it again by its id"


def test_a_motion_may_stray_as_far_as_the_description_says_of_the_group(hulls: RobotHulls) -> None:
    narrow = panda().model_copy(
        update={"groups": tuple(each.model_copy(update={"path_tolerance": 0.01}) for each in panda().groups)}
    )
    rig = ArmRig(narrow, "arm", hulls=hulls)
    rig.result(rig.run(MoveGoal(joints=SIDE)))
    assert {each.path_tolerance for each in rig.hardware.goals} == {0.01}


def test_feedback_tells_the_way_of_the_hand_while_it_moves(rig: ArmRig, hulls: RobotHulls) -> None:
    heard = Latest(rig.bus, status_topic("arm/move"), depth=256)
    rig.result(rig.run(MoveGoal(joints=SIDE)))
    told = [
        MoveFeedback.model_validate_json(json.dumps(each.feedback)) for each in heard.take() if each.feedback
    ]
    ways = {each.way for each in told if each.phase is MovePhase.MOVING}
    assert {each.way for each in told if each.phase is MovePhase.PLANNING} <= {()}
    (way,) = ways
    frame, end = panda().end_effectors[0].frame, rig.hardware.positions
    assert 2 <= len(way) <= MOST_CORNERS
    assert np.allclose(way[-1], hulls.robot.pose(frame, end).position, atol=1e-3)


def test_the_first_candidate_that_is_reachable_is_taken(rig: ArmRig) -> None:
    goal = MoveGoal(candidates=(pose(3.0, 0.0, 0.4), pose(0.45, 0.2, 0.4)))
    assert rig.result(rig.run(goal)).candidate == 1


def test_what_follows_must_be_reachable_as_well(rig: ArmRig) -> None:
    beyond = Candidate(
        pose=pose(0.45, 0.2, 0.4).pose, followed_by=(Pose(position=(2.0, 0.2, 0.4), orientation=DOWN),)
    )
    assert rig.result(rig.run(MoveGoal(candidates=(beyond, pose(0.45, 0.2, 0.4))))).candidate == 1


def test_a_robot_that_does_not_know_where_it_is_moves_only_where_nothing_stands(rig: ArmRig) -> None:
    rig.tell_pose(localised=False)
    assert rig.run(MoveGoal(posture="home")).state is GoalState.SUCCEEDED
    rig.set_scene(box("crate", (0.2, 0.2, 0.2), (1.5, 1.0, 0.35)), version=2)
    lost = rig.run(MoveGoal(posture="home"), "b")
    assert lost.failure is not None
    assert lost.failure.kind is FailureKind.NOT_LOCALISED


def test_out_of_reach_is_no_ik_with_the_distance(rig: ArmRig) -> None:
    status = rig.run(MoveGoal(candidates=(pose(2.0, 0.0, 0.4),)))
    assert status.failure is not None
    assert status.failure.kind is FailureKind.NO_IK
    assert float(status.failure.evidence["distance_m"]) > 0.5
    assert rig.hardware.goals == []


def test_a_pose_inside_a_box_names_what_is_in_the_way(rig: ArmRig) -> None:
    rig.set_scene(box("crate", (0.2, 0.2, 0.2), (0.5, 0.3, 0.35)), version=2)
    status = rig.run(MoveGoal(candidates=(pose(0.5, 0.3, 0.35),)))
    assert status.failure is not None
    assert status.failure.kind is FailureKind.NO_IK
    assert "crate" in str(status.failure.evidence["contact"])


def test_the_hand_may_touch_only_the_item_that_it_grasps(rig: ArmRig) -> None:
    rig.set_scene(box("item_29", (0.03, 0.03, 0.03), (0.45, 0.2, 0.4), item=29), version=2)
    assert rig.run(MoveGoal(candidates=(pose(0.45, 0.2, 0.4),))).state is GoalState.FAILED
    goal = MoveGoal(candidates=(pose(0.45, 0.2, 0.4),), touch_item=29)
    rig.hardware.positions |= {"panda_finger_joint1": 0.03, "panda_finger_joint2": 0.03}
    assert rig.run(goal, "b").state is GoalState.SUCCEEDED


@pytest.mark.parametrize(
    ("item", "touched"),
    [
        pytest.param(None, None, id="a hand that goes somewhere else"),
        pytest.param(29, ((0.45, 0.2, 0.35),), id="a hand that will approach the item from there"),
    ],
)
def test_nothing_comes_between_open_fingers_that_may_move_on_the_way(
    rig: ArmRig, item: int | None, touched: tuple[tuple[float, float, float], ...] | None
) -> None:
    rig.set_scene(box("item_29", (0.03, 0.03, 0.03), (0.45, 0.2, 0.4), item=29), version=2)
    rig.hardware.positions |= {"panda_finger_joint1": 0.03, "panda_finger_joint2": 0.03}
    then = tuple(Pose(position=at, orientation=DOWN) for at in touched or ())
    there = pose(0.45, 0.2, 0.4).model_copy(update={"followed_by": then})
    status = rig.run(MoveGoal(candidates=(there,), touch_item=item))
    assert status.failure is not None
    assert status.failure.evidence["contact"] == "space between the fingers of right and item_29"


def test_what_enters_the_scene_after_planning_is_found_by_the_last_check(hulls: RobotHulls) -> None:
    arm = Arm(hulls, panda(), "arm")
    planner = MovePlanner(arm, PlannerSettings(), "arm/move")
    rig = ArmRig(panda(), "arm", hulls=hulls)
    goal = MoveGoal(joints=SIDE)
    moment = rig.moment()
    plan = run_through(planner.plan(goal, moment, np.random.default_rng(0)))
    assert isinstance(plan, Plan)
    assert run_through(planner.recheck(plan.trajectory, goal, moment)) is None
    tool = hulls.robot.pose("panda_hand_tcp", dict(zip(rig.group.joints, SIDE, strict=True))).position
    found = run_through(
        planner.recheck(plan.trajectory, goal, rig.moment(box("late", (0.1, 0.1, 0.1), tool)))
    )
    assert isinstance(found, Failure)
    assert found.kind is FailureKind.PATH_IN_COLLISION
    assert "late" in str(found.evidence["contact"])


def command(rig: ArmRig, what: Command, goal_id: str = "t/move/1") -> None:
    command_service("arm/move").query(rig.bus, GoalCommand(goal_id=goal_id, command=what))


def test_a_cancel_stops_the_hardware_and_ends_at_rest(rig: ArmRig) -> None:
    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(30)
    assert rig.hardware.goals
    command(rig, Command.CANCEL)
    status = rig.until(GoalState.CANCELED, most=20)
    assert status.failure is None
    stood = dict(rig.hardware.positions)
    rig.rounds(20)
    assert rig.hardware.positions == stood
    assert not np.allclose(list(stood.values()), SIDE)


def test_a_pause_stops_and_a_resume_gets_there(rig: ArmRig) -> None:
    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(30)
    command(rig, Command.PAUSE)
    rig.rounds(20)
    stood = dict(rig.hardware.positions)
    rig.rounds(50)
    assert rig.hardware.positions == stood
    command(rig, Command.RESUME)
    assert np.allclose(rig.result(rig.until(GoalState.SUCCEEDED)).positions, SIDE)


@pytest.mark.parametrize("rounds", [0, 1, 3])
def test_one_who_is_resumed_before_it_stands_gets_there_too(rig: ArmRig, rounds: int) -> None:
    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(30)
    command(rig, Command.PAUSE)
    rig.rounds(rounds)
    command(rig, Command.RESUME)
    assert np.allclose(rig.result(rig.until(GoalState.SUCCEEDED)).positions, SIDE)


@pytest.mark.parametrize("order", [Order.HOLD, Order.STOP])
def test_an_order_of_the_coordination_stops_it_until_it_may_go(rig: ArmRig, order: Order) -> None:
    def say(told: Order) -> None:
        orders = (ArmOrder(side="right", order=told),)
        RIGHT_OF_WAY.publish(rig.bus, RightOfWay(stamp=rig.hardware.stamp, episode=1, orders=orders))

    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(30)
    say(order)
    rig.rounds(20)
    stood = dict(rig.hardware.positions)
    rig.rounds(50)
    assert rig.hardware.positions == stood
    say(Order.GO)
    assert np.allclose(rig.result(rig.until(GoalState.SUCCEEDED)).positions, SIDE)


def in_the_way(rig: ArmRig, hulls: RobotHulls) -> SceneObject:
    """Return a box where the hand is to end at SIDE."""
    tool = hulls.robot.pose("panda_hand_tcp", dict(zip(rig.group.joints, SIDE, strict=True))).position
    return box("late", (0.1, 0.1, 0.1), tool)


def test_what_enters_the_scene_on_the_way_stops_the_arm(rig: ArmRig, hulls: RobotHulls) -> None:
    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(30)
    assert rig.hardware.goals
    rig.set_scene(in_the_way(rig, hulls), version=2)
    status = rig.until(GoalState.FAILED, most=60)
    assert status.failure is not None
    assert status.failure.kind is FailureKind.PATH_IN_COLLISION
    assert "late" in str(status.failure.evidence["contact"])
    assert not np.allclose(list(rig.hardware.positions.values())[:7], SIDE, atol=0.05)


def test_what_enters_the_scene_elsewhere_or_behind_stops_nothing(rig: ArmRig) -> None:
    rig.send(MoveGoal(joints=SIDE))
    rig.rounds(60)
    rig.set_scene(box("far", (0.1, 0.1, 0.1), (-0.5, 0.5, 0.5)), version=2)
    assert rig.until(GoalState.SUCCEEDED, GoalState.FAILED).state is GoalState.SUCCEEDED


@pytest.mark.parametrize("what", [Command.CANCEL, Command.PAUSE])
def test_a_command_in_any_slice_before_sending_is_obeyed(hulls: RobotHulls, what: Command) -> None:
    """The scene changes after the first slice, so that the last slices are those of the last check."""
    rig = ArmRig(panda(), "arm", hulls=hulls)
    arm = Arm(hulls, panda(), "arm")
    board = ArmStatusBoard(rig.bus, rig.clocks, arm)
    skill = Move(rig.bus, rig.clocks, arm, board, PlannerSettings())
    rig.tell_pose()
    for number in range(4):
        rig.set_scene()
        rig.rounds(2)
        run = skill.run(MoveGoal(joints=SIDE), "a")
        yielded = next(run)
        rig.set_scene(box("far", (0.1, 0.1, 0.1), (-0.5, 0.5, 0.5)), version=2)
        for _ in range(number):
            yielded = run.send(Command.GO_ON)
        assert isinstance(yielded, Slice)
        if what is Command.CANCEL:
            with pytest.raises(StopIteration) as stop:
                run.send(what)
            assert stop.value.value.canceled
        else:
            answer = run.send(what)
            assert isinstance(answer, MoveFeedback)
            assert answer.phase is MovePhase.STOPPING
        run.close()
        rig.rounds(1)
        assert rig.hardware.goals == []


def test_a_joint_a_hair_beyond_its_limit_is_where_the_motion_begins(rig: ArmRig) -> None:
    joint, limit = rig.group.joints[3], rig.group.limits[3]
    rig.hardware.positions[joint] = limit.upper + 0.002
    rig.rounds(1)
    rig.result(rig.run(MoveGoal(joints=PANDA_HOME)))
    first = rig.hardware.goals[0].points[0]
    assert first.positions[3] == pytest.approx(limit.upper + 0.002)


def test_a_posture_at_a_limit_is_reached(rig: ArmRig) -> None:
    at_limit = list(PANDA_HOME)
    at_limit[6] = rig.group.limits[6].upper
    reached = rig.result(rig.run(MoveGoal(joints=tuple(at_limit)))).positions
    assert reached == pytest.approx(at_limit, abs=LIMIT_MARGIN + 1e-3)
    rig.result(rig.run(MoveGoal(joints=PANDA_HOME), "b"))


def test_an_arm_that_strays_is_told_with_its_joint(rig: ArmRig) -> None:
    rig.hardware.stray_at = 0.5
    status = rig.run(MoveGoal(joints=SIDE))
    assert status.failure is not None
    assert status.failure.kind is FailureKind.ARM_STOPPED
    assert status.failure.evidence["joint"] == rig.group.joints[0]


@pytest.mark.parametrize(
    "goal",
    [MoveGoal(joints=(0.0,)), MoveGoal(posture="sitting")],
    ids=["too few joints", "unknown posture"],
)
def test_goals_that_contradict_the_robot_are_rejected(rig: ArmRig, goal: MoveGoal) -> None:
    sent = rig.send(goal)
    rig.rounds(1)
    answer = sent.poll()
    assert answer is not None
    assert GoalStatus.model_validate_json(answer).state is GoalState.REJECTED


def test_the_same_seed_sends_the_same_motion(hulls: RobotHulls) -> None:
    sent = []
    for _ in range(2):
        rig = ArmRig(panda(), "arm", hulls=hulls)
        rig.set_scene(box("post", (0.1, 0.1, 0.8), (0.45, 0.1, 0.4)), version=2)
        rig.run(MoveGoal(candidates=(pose(0.4, 0.4, 0.3),)))
        sent.append(rig.hardware.goals[-1].points)
    assert sent[0] == sent[1]


def test_a_planner_that_cannot_be_sliced_is_run_by_a_worker_and_charged(hulls: RobotHulls) -> None:
    settings = PlannerSettings(planner=PlannerName.AORRTC, improving_checks=3000)
    clocks = SteppedClocks("test")
    planner = MovePlanner(Arm(hulls, panda(), "arm"), settings, "arm/move", InlineCompute(clocks))
    rig = ArmRig(panda(), "arm", hulls=hulls)
    here = [q + d for q, d in zip(PANDA_HOME, (-0.9, 0.6, 0, 0, 0, 0, 0), strict=True)]
    rig.hardware.positions |= dict(zip(rig.group.joints, here, strict=True))
    there = tuple(q + d for q, d in zip(PANDA_HOME, (0.9, 0.6, 0, 0, 0, 0, 0), strict=True))
    wall = box("wall", (0.5, 0.05, 0.6), (0.6, 0.0, 0.3))
    steps = planner.plan(MoveGoal(joints=there), rig.moment(wall), np.random.default_rng(0))
    waited = 0
    while True:
        try:
            waited += next(steps) == 0
        except StopIteration as stop:
            planned = stop.value
            break
        clocks.advance(0.01)
    assert isinstance(planned, Plan)
    assert waited > 3


def test_joints_outside_their_limits_are_refused_with_the_limits(rig: ArmRig) -> None:
    pending = rig.send(MoveGoal(joints=(9.0, *PANDA_HOME[1:])))
    rig.rounds(2)
    status = GoalStatus.model_validate_json(pending.poll() or b"")
    assert status.state is GoalState.REJECTED
    assert status.failure is not None
    assert status.failure.kind is FailureKind.INVALID_GOAL
    assert ", 9.000 given" in status.failure.message
