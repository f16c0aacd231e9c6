"""Driving on the planar fake: there, round things, and not when it must not."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills.base.path import Path
from tandem.skills.base.path_follower import Follower
from tandem.skills.base.planner import Clearances
from tandem.skills.base.wheels import stopping_speed
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.actions.arm import ArmState
from tandem.skills.ports.actions.base import (
    BASE_STATUS,
    BaseState,
    DriveGoal,
    DriveResult,
    LocaliseGoal,
    RotateGoal,
)
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import SiteBox
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.site import load
from tests.fakes.base_rig import Rig, make_rig

LAB = load("lab")


def pose(x: float, y: float, yaw: float = 0.0) -> FloorPose:
    return FloorPose(x=x, y=y, yaw=yaw)


def go(
    rig: Rig, *goals: FloorPose, command: Callable[[float], Command] = lambda _: Command.GO_ON
) -> Outcome[DriveResult]:
    goal = DriveGoal(poses=goals, serves_item=29)
    assert rig.base.drive.check(goal) is None
    return rig.run(rig.base.drive.run(goal, "g"), command)


SOUTH = pose(-1.0, -1.6)


@pytest.mark.parametrize(
    ("deceleration", "latency", "remaining"), [(0.5, 0.05, 1.0), (1.05, 0.0, 0.3), (0.5, 0.1, 0.001)]
)
def test_from_the_stopping_speed_the_base_stops_in_time(
    deceleration: float, latency: float, remaining: float
) -> None:
    speed = stopping_speed(remaining, deceleration, latency)
    assert speed * latency + speed * speed / (2 * deceleration) == pytest.approx(remaining)


def test_it_arrives_where_it_should_and_says_so() -> None:
    rig = make_rig(LAB, LAB.home)
    states = Latest(rig.bus, BASE_STATUS, depth=1000)
    goal = LAB.spots[2].pose
    outcome = go(rig, goal)
    assert outcome.result is not None
    assert floor_distance(rig.robot.truth, goal) < 0.015
    assert abs(wrap(rig.robot.truth.yaw - goal.yaw)) < 0.015
    told = [status.state for status in states.take()]
    assert list(dict.fromkeys(told)) == [BaseState.BASE_TO_GOAL, BaseState.BASE_GOAL_OK]
    assert states.value is not None
    assert states.value.serves_item == 29


@pytest.mark.parametrize(("way", "bound"), [(2.0, 4.0), (4.0, 6.0)])
def test_straight_ahead_takes_little_more_than_the_drives_limits_allow(way: float, bound: float) -> None:
    rig = make_rig(LAB, pose(-2.2, 1.7))
    start = rig.now
    assert go(rig, pose(-2.2 + way, 1.7)).result is not None
    assert rig.now - start < bound + 0.5


def test_the_turn_at_the_end_begins_while_the_base_still_brakes() -> None:
    rig, rolled = make_rig(LAB, SOUTH), []

    def watch(_: float) -> Command:
        rolled.append((rig.robot.linear, rig.robot.angular))
        return Command.GO_ON

    goal = pose(0.5, -1.6, 1.5)
    assert go(rig, goal, command=watch).result is not None
    assert any(linear > 0.1 and angular > 0.2 for linear, angular in rolled)
    assert floor_distance(rig.robot.truth, goal) < 0.015
    assert abs(wrap(rig.robot.truth.yaw - goal.yaw)) < 0.015


def test_in_a_narrow_place_it_rolls_before_its_turn_to_the_way_has_ended() -> None:
    rig, turning = make_rig(LAB, pose(-0.10, 0.40, 0.75)), []

    def watch(_: float) -> Command:
        if 0.05 < rig.robot.linear < 0.2:
            turning.append(abs(rig.robot.angular))
        return Command.GO_ON

    assert go(rig, pose(-1.0, 1.2, 2.4), command=watch).result is not None
    assert turning[0] > 0.3


@pytest.mark.parametrize(("speed", "turns"), [(0.28, True), (0.02, False)])
def test_only_a_base_that_brakes_for_its_end_turns_there_early(speed: float, *, turns: bool) -> None:
    rig = make_rig(LAB, SOUTH)
    path = Path(np.array([(-1.0, -1.6), (0.0, -1.6)]))
    course = rig.base.drive.course
    clearances, goal = Clearances(course.site_map.plan, 0.3, SOUTH), pose(0.0, -1.6, 1.5)
    follower = Follower(path, course.drive, clearances, goal, way=0.9)
    _, angular = follower.speeds(pose(-0.1, -1.6), speed, None)
    assert (angular > 0.5) is turns
    assert follower.turns_on is turns


def test_the_first_pose_with_a_way_is_taken() -> None:
    rig = make_rig(LAB, SOUTH)
    outcome = go(rig, pose(1.0, 0.5), pose(-0.5, -1.7))
    assert outcome.result is not None
    assert outcome.result.pose == 1


def test_without_any_way_it_says_why_for_each_pose_and_stays() -> None:
    rig = make_rig(LAB, SOUTH)
    outcome = go(rig, pose(1.0, 0.5), pose(8.0, 0.0))
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.BASE_NO_PATH
    assert len(outcome.failure.causes) == 2
    assert "goal_clearance_m" in outcome.failure.causes[0].evidence
    assert rig.robot.driven == 0.0


def test_a_short_way_straight_back_is_backed_up() -> None:
    rig = make_rig(LAB, SOUTH)
    start = rig.now
    assert go(rig, pose(-1.3, -1.6)).result is not None
    assert rig.now - start < 3.0


def test_something_that_turns_up_on_the_way_is_gone_round_without_touching_it() -> None:
    rig = make_rig(LAB, SOUTH)
    stone = SiteBox(size=(0.3, 0.3, 0.5), centre=(1.0, -1.6, 0.25))
    closest = [math.inf]

    def appear(seconds: float) -> Command:
        if seconds > 1.5 and stone not in rig.robot.boxes:
            rig.robot.boxes.append(stone)
        closest[0] = min(closest[0], rig.robot.clearance())
        return Command.GO_ON

    outcome = go(rig, pose(2.0, -1.6), command=appear)
    assert outcome.result is not None
    assert outcome.result.replans >= 1
    assert closest[0] > rig.robot.description.footprint_radius


def test_before_a_barrier_it_gives_up_and_names_what_stands_there() -> None:
    rig = make_rig(LAB, SOUTH)
    barrier = SiteBox(size=(1.5, 0.3, 0.5), centre=(2.0, -1.8, 0.25))

    def appear(seconds: float) -> Command:
        if seconds > 1.0 and barrier not in rig.robot.boxes:
            rig.robot.boxes.append(barrier)
        return Command.GO_ON

    outcome = go(rig, pose(2.25, -2.45), command=appear)
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.BASE_BLOCKED
    assert "obstacle_x_m" in outcome.failure.evidence
    assert rig.robot.linear == 0.0


def test_something_that_leaves_again_is_waited_for() -> None:
    rig = make_rig(LAB, SOUTH)
    barrier = SiteBox(size=(1.5, 0.3, 0.5), centre=(2.0, -1.8, 0.25))

    def appear(seconds: float) -> Command:
        rig.robot.boxes[:] = [box for box in rig.robot.boxes if box is not barrier]
        if 1.0 < seconds < 6.0:
            rig.robot.boxes.append(barrier)
        return Command.GO_ON

    goal = pose(2.25, -2.45)
    outcome = go(rig, goal, command=appear)
    assert outcome.result is not None, outcome.failure
    assert outcome.result.replans >= 1
    assert floor_distance(rig.robot.truth, goal) < 0.02


def test_an_occupied_pose_is_left_for_the_next() -> None:
    rig = make_rig(LAB, SOUTH)
    stone = SiteBox(size=(0.4, 0.4, 0.5), centre=(0.0, -1.6, 0.25))
    rig.robot.boxes.append(stone)
    rig.wait(1.0)
    outcome = go(rig, pose(0.0, -1.6), pose(-0.8, -1.6))
    assert outcome.result is not None
    assert outcome.result.pose == 1


def test_where_one_pose_is_blocked_on_the_way_another_is_taken() -> None:
    rig = make_rig(LAB, SOUTH)
    barrier = SiteBox(size=(1.5, 0.3, 0.5), centre=(2.0, -1.8, 0.25))

    def appear(seconds: float) -> Command:
        if seconds > 1.0 and barrier not in rig.robot.boxes:
            rig.robot.boxes.append(barrier)
        return Command.GO_ON

    outcome = go(rig, pose(2.25, -2.45), pose(-0.5, -1.6), command=appear)
    assert outcome.result is not None, outcome.failure
    assert outcome.result.pose == 1


def test_cancelled_it_brakes_and_only_then_ends() -> None:
    rig = make_rig(LAB, SOUTH)
    states = Latest(rig.bus, BASE_STATUS)
    outcome = go(rig, pose(2.0, -1.6), command=lambda t: Command.CANCEL if t > 2.0 else Command.GO_ON)
    assert outcome.canceled
    assert (rig.robot.linear, rig.robot.angular) == (0.0, 0.0)
    status = states.refresh()
    assert status is not None
    assert status.state is BaseState.BASE_IDLE


def test_paused_it_stands_and_resumed_it_arrives() -> None:
    rig = make_rig(LAB, SOUTH)
    script = [(1.5, Command.PAUSE), (6.0, Command.RESUME)]
    stood = []

    def command(seconds: float) -> Command:
        if 5.0 < seconds < 6.0:
            stood.append(rig.robot.linear)
        if script and seconds > script[0][0]:
            return script.pop(0)[1]
        return Command.GO_ON

    assert go(rig, pose(2.0, -1.6), command=command).result is not None
    assert set(stood) == {0.0}


def stop(rig: Rig) -> None:
    rig.robot.stopped = True


def silence(rig: Rig) -> None:
    rig.robot.laser_on = False


def stretch(rig: Rig) -> None:
    rig.extent = 0.9


def move_arm(rig: Rig) -> None:
    rig.arm_state = ArmState.ARM_RUNNING


def lose(rig: Rig) -> None:
    rig.base.localiser.localised = False


def test_a_bumper_pressed_on_the_way_stops_it_but_not_one_pressed_before() -> None:
    rig = make_rig(LAB, SOUTH)
    rig.robot.pressed = ("behind",)
    rig.wait(0.3)
    assert go(rig, pose(-0.5, -1.6)).result is not None

    def touch(seconds: float) -> Command:
        if seconds > 1.5:
            rig.robot.pressed = ("behind", "ahead")
        return Command.GO_ON

    outcome = go(rig, pose(2.0, -1.6), command=touch)
    assert outcome.failure is not None
    assert (outcome.failure.kind, outcome.failure.reason.kind) == (
        FailureKind.OVERRIDDEN,
        FailureKind.BASE_BLOCKED,
    )
    assert outcome.failure.evidence == outcome.failure.evidence | {"reflex": "bumper", "bumper": "ahead"}


def leap(rig: Rig) -> None:
    rig.robot.leap(FloorPose(x=0.2, y=0.1, yaw=0.3))


def test_odometry_that_jumps_stops_it_within_a_second_and_it_can_be_found_again() -> None:
    rig = make_rig(LAB, SOUTH)
    leapt = []

    def command(seconds: float) -> Command:
        if seconds > 1.5 and not leapt:
            leap(rig)
            leapt.append(rig.now)
        return Command.GO_ON

    outcome = go(rig, pose(2.0, -1.6), command=command)
    assert outcome.failure is not None
    assert outcome.failure.reason.kind is FailureKind.NOT_LOCALISED
    assert "jumped" in outcome.failure.message
    assert rig.robot.linear == 0.0
    assert rig.now - leapt[0] < 2.0, "at rest, braking included"
    assert rig.run(rig.base.localise.run(LocaliseGoal(), "l")).result is not None
    assert go(rig, pose(2.0, -1.6)).result is not None
    assert floor_distance(rig.robot.truth, pose(2.0, -1.6)) < 0.02


def test_carried_off_on_the_way_it_soon_stops() -> None:
    rig = make_rig(LAB, SOUTH)
    carried: list[float] = []

    def command(seconds: float) -> Command:
        if seconds > 1.5 and not carried:
            rig.robot.truth = pose(1.3, 1.9, 2.0)
            carried.append(rig.now)
        return Command.GO_ON

    outcome = go(rig, pose(2.0, -1.6), command=command)
    assert outcome.failure is not None
    assert outcome.failure.reason.kind is FailureKind.NOT_LOCALISED
    assert rig.now - carried[0] < 2.0, "at rest, braking included"
    assert rig.robot.linear == 0.0


def test_the_time_of_a_pause_does_not_count() -> None:
    rig = make_rig(LAB, SOUTH)
    script = [(0.0, Command.PAUSE), (8.0, Command.RESUME)]

    def command(seconds: float) -> Command:
        return script.pop(0)[1] if script and seconds > script[0][0] else Command.GO_ON

    assert go(rig, pose(2.0, -1.6), command=command).result is not None


FAULTS = [
    (stop, FailureKind.HARDWARE_STOPPED),
    (silence, FailureKind.LASER_SILENT),
    (stretch, FailureKind.BASE_HELD),
    (move_arm, FailureKind.BASE_HELD),
    (lose, FailureKind.NOT_LOCALISED),
]


@pytest.mark.parametrize(("fault", "kind"), FAULTS)
def test_a_fault_on_the_way_brings_it_to_rest(fault: Callable[[Rig], None], kind: FailureKind) -> None:
    rig = make_rig(LAB, SOUTH)

    def command(seconds: float) -> Command:
        if seconds > 1.5:
            fault(rig)
        return Command.GO_ON

    outcome = go(rig, pose(2.0, -1.6), command=command)
    assert outcome.failure is not None
    assert (outcome.failure.kind, outcome.failure.reason.kind) == (FailureKind.OVERRIDDEN, kind)
    assert rig.robot.linear == 0.0


@pytest.mark.parametrize(("fault", "kind"), FAULTS)
def test_with_a_fault_it_does_not_even_begin(fault: Callable[[Rig], None], kind: FailureKind) -> None:
    rig = make_rig(LAB, SOUTH)
    fault(rig)
    rig.wait(0.7)
    for refusal in (
        rig.base.drive.check(DriveGoal(poses=(SOUTH,))),
        rig.base.rotate.check(RotateGoal(angle=1.0)),
    ):
        assert refusal is not None
        assert refusal.kind is kind


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        (stretch, "reaches 0.90 m out: the base drives with 0."),
        (move_arm, "is at work (ARM_RUNNING): the base drives when it rests"),
    ],
)
def test_an_arm_that_holds_the_base_is_told_with_what_would_let_it_go(
    fault: Callable[[Rig], None], said: str
) -> None:
    rig = make_rig(LAB, SOUTH)
    fault(rig)
    rig.wait(0.7)
    refusal = rig.base.drive.check(DriveGoal(poses=(SOUTH,)))
    assert refusal is not None
    assert said in refusal.message


def test_an_arm_that_was_never_heard_keeps_the_base_where_it_is() -> None:
    rig = make_rig(LAB, SOUTH)
    fresh = make_rig(LAB, SOUTH, localised=False)
    assert rig.base.drive.check(DriveGoal(poses=(SOUTH,))) is None
    refusal = fresh.base.drive.check(DriveGoal(poses=(SOUTH,)))
    assert refusal is not None
    assert refusal.kind is FailureKind.NOT_LOCALISED


def test_only_one_skill_has_the_wheels() -> None:
    rig = make_rig(LAB, SOUTH)
    run = rig.base.rotate.run(RotateGoal(angle=1.0), "g")
    next(run)
    refusal = rig.base.drive.check(DriveGoal(poses=(SOUTH,)))
    assert refusal is not None
    assert refusal.kind is FailureKind.BUSY
    run.close()
    assert rig.base.drive.check(DriveGoal(poses=(SOUTH,))) is None


def test_closed_on_the_way_it_leaves_a_stop_behind() -> None:
    rig = make_rig(LAB, SOUTH)
    run = rig.base.drive.run(DriveGoal(poses=(pose(2.0, -1.6),)), "g")
    next(run)
    for _ in range(100):
        rig.tick()
        run.send(Command.GO_ON)
    assert rig.robot.linear > 0.2
    run.close()
    rig.wait(3.0)
    assert rig.robot.linear == 0.0
