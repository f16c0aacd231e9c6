"""Each kind of fault has its effect, seen through the hardware's messages and in the physics."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from pydantic import ValidationError

from benchmarks.rig import GRASP, LIFT
from tandem.sim.body import RobotBody
from tandem.sim.faults import (
    ArmMoving,
    BaseAtRest,
    BaseMoving,
    BumperPressed,
    Fault,
    GripperClosed,
    GripperStuck,
    GripperWeak,
    HandOpens,
    HardwareSilent,
    ItemGone,
    ItemLifted,
    ItemMoves,
    JointStall,
    OdometryJump,
    StopSet,
)
from tandem.sim.faulty_link import FaultyLink
from tandem.sim.hardware import Hardware
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.sim.room import Room
from tandem.sim.scenario import Noise
from tandem.sim.trouble import Trouble
from tandem.sim.world import World
from tandem.skills.kinematics.described import home_positions
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import GripperMotion, MotionState
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus
from tests.sim.broken import FaultyRig

BEGAN, ENDED, REFUSED = "began", "ended", "refused"


class MakeRig:
    """Makes rigs that end with the test."""

    def __init__(self) -> None:
        self.made: list[FaultyRig] = []

    def __call__(self, *faults: Fault) -> FaultyRig:
        self.made.append(FaultyRig(*faults))
        return self.made[-1]


@pytest.fixture
def make_rig() -> Iterator[MakeRig]:
    make = MakeRig()
    yield make
    for rig in make.made:
        rig.close()


def test_a_hand_that_opens_lets_its_item_fall_and_closes_again_on_nothing(make_rig: MakeRig) -> None:
    rig = make_rig(HandOpens(when=ItemLifted(after=0.3)))
    rig.lift()
    rig.ticks(100)
    assert rig.phases() == [("hand_opens", BEGAN), ("hand_opens", ENDED)]
    assert "left" in rig.events[0].words
    assert "right" not in rig.events[0].words
    assert rig.height() < 0.79
    rig.ticks(200)
    assert rig.gripper().motion is GripperMotion.AT_WIDTH
    assert rig.gripper().force == 0.0


def test_a_weak_gripper_lets_slip_what_friction_cannot_carry(make_rig: MakeRig) -> None:
    rig = make_rig(GripperWeak(side="left", when=GripperClosed(after=0.1), force=0.02))
    rig.lift()
    rig.ticks(50)
    assert rig.phases() == [("gripper_weak", BEGAN)]
    assert rig.height() < 0.8


def test_stuck_fingers_do_not_open_and_do_again_when_it_is_over(make_rig: MakeRig) -> None:
    rig = make_rig(GripperStuck(side="left", at=0.0, lasts=2.0))
    before = rig.grip(0.0).width
    state = rig.grip(0.09)
    assert state.width == pytest.approx(before, abs=0.001)
    assert state.motion is GripperMotion.STALLED
    rig.ticks(200)
    assert rig.grip(0.09).width == pytest.approx(0.09, abs=0.002)


def test_a_fault_of_fingers_that_names_no_hand_is_about_all_whatever_they_are_called() -> None:
    physics, model, bus = Physics(), robot_model("locobot"), MemoryBus()
    body = RobotBody(physics, model, positions=dict(home_positions(model.description)))
    link = FaultyLink(bus)
    hardware = Hardware(link, body, boot="rig", noise=Noise(), rng=np.random.default_rng(1))
    room = Room(load("picking"), World(physics), body)
    Trouble(bus, link, hardware, room, (GripperStuck(at=0.0),)).step()
    assert hardware.hands["single"].defects.stuck


def test_a_joint_that_stalls_aborts_the_motion_and_is_named(make_rig: MakeRig) -> None:
    rig = make_rig(JointStall(group="arm_left", joint=3, when=ArmMoving(nth=2, after=0.2)))
    rig.move("arm_left", GRASP, 1.0)
    rig.ticks(20)
    before = rig.positions("arm_left")[3]
    status = rig.move("arm_left", (0.9, 0.5, 1.1, 0.6, -0.9, -0.5, -0.3), 2.0)
    assert status.state is MotionState.ABORTED
    assert status.joint == "arm_left_4_joint"
    assert rig.positions("arm_left")[3] == pytest.approx(before, abs=0.2)


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_stall_without_a_group_is_of_the_arm_that_moves(make_rig: MakeRig, side: str) -> None:
    rig = make_rig(JointStall(joint=3, when=ArmMoving(after=0.2)))
    status = rig.move(f"arm_{side}", (0.9, 0.5, 1.1, 0.6, -0.9, -0.5, -0.3), 2.0)
    assert status.state is MotionState.ABORTED
    assert status.joint == f"arm_{side}_4_joint"
    assert side in rig.events[0].words


def test_a_stall_without_a_group_needs_an_event_that_an_arm_has() -> None:
    with pytest.raises(ValidationError, match="expected a group's name"):
        JointStall(joint=3, when=BaseMoving())


def test_a_limp_arm_sinks(make_rig: MakeRig) -> None:
    rig = make_rig(JointStall(group="arm_left", limp=True, at=0.1))
    before = rig.body.frame_matrix("gripper_left_grasping_frame")[2, 3]
    rig.ticks(100)
    assert rig.body.frame_matrix("gripper_left_grasping_frame")[2, 3] < before - 0.05


def test_silent_hardware_hears_nothing_tells_nothing_and_its_dead_man_brakes(make_rig: MakeRig) -> None:
    rig = make_rig(HardwareSilent(at=1.0, lasts=2.0))
    rig.drive(0.3, 0.0, 0.95)
    everything = rig.bus.subscribe("hw/**")
    rig.ticks(10)
    everything.drain()
    asked = keys.DESCRIPTION.query(rig.bus, keys.Nothing())
    rig.drive(0.3, 0.0, 1.0)
    assert {sample.key for sample in everything.drain()} == {keys.BASE_VELOCITY.key}
    assert (asked.done(), asked.poll()) == (True, None)
    assert rig.hardware.base.controller.linear == 0.0
    rig.ticks(110)
    clock = keys.Latest(rig.bus, keys.CLOCK)
    rig.ticks(1)
    told = clock.refresh()
    assert told is not None
    assert told.stamp.seconds == pytest.approx(3.16, abs=0.011)


def test_odometry_jumps_and_the_base_does_not(make_rig: MakeRig) -> None:
    rig = make_rig(OdometryJump(at=0.1, dx=0.5, dy=-0.2, dyaw=0.3))
    odometry = keys.Latest(rig.bus, keys.ODOMETRY)
    rig.ticks(30)
    told = odometry.refresh()
    assert told is not None
    pose = told.base_in_odom
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((0.5, -0.2, 0.3), abs=0.01)
    assert rig.body.base_pose()[0][:2] == pytest.approx((0.0, 0.0), abs=0.01)


def test_a_bumper_reads_pressed_for_its_time(make_rig: MakeRig) -> None:
    rig = make_rig(BumperPressed(bumper="left", at=0.3, lasts=0.2))
    bumpers = rig.bus.subscribe(keys.BUMPERS.key)
    rig.ticks(60)
    told = [keys.BUMPERS.decode(sample.payload).pressed for sample in bumpers.drain()]
    changes = [each for index, each in enumerate(told) if index == 0 or each != told[index - 1]]
    assert changes == [(), ("left",), ()]


def test_a_person_stops_the_robot_and_releases_it(make_rig: MakeRig) -> None:
    rig = make_rig(StopSet(when=BaseMoving(after=0.5), lasts=1.0))
    states = keys.Latest(rig.bus, keys.STOP_STATE)
    rig.drive(0.3, 0.0, 0.8)
    told = states.refresh()
    assert told is not None
    assert (told.stopped, told.by) == (True, "a person")
    rig.drive(0.3, 0.0, 0.4)
    assert rig.hardware.base.controller.linear == 0.0
    rig.ticks(100)
    told = states.refresh()
    assert told is not None
    assert not told.stopped


def test_a_stop_that_somebody_else_has_set_stays(make_rig: MakeRig) -> None:
    rig = make_rig(StopSet(at=0.0, lasts=0.2))
    rig.ticks(5)
    keys.STOP.query(rig.bus, keys.STOP.asked(by="operator", reason="careful"))
    rig.ticks(40)
    assert rig.hardware.stop_state.by == "operator"


def test_an_item_is_moved_out_of_the_hand_that_lifts_it(make_rig: MakeRig) -> None:
    rig = make_rig(ItemMoves(dx=-0.3, dy=0.8, when=ItemLifted(item=29)))
    rig.lift()
    rig.ticks(100)
    assert rig.phases() == [("item_moves", BEGAN)]
    rig.item = rig.world.id_of("item_29")
    assert rig.height() == pytest.approx(0.03, abs=0.002)


def test_an_item_is_not_moved_into_something_else(make_rig: MakeRig) -> None:
    rig = make_rig(ItemMoves(item=29, dx=-0.68, dy=-0.15, at=0.1))
    rig.ticks(30)
    assert rig.phases() == [("item_moves", REFUSED)]
    assert "robot" in rig.events[0].words
    assert rig.world.pose("item_29").position[0] == pytest.approx(0.68, abs=0.01)


def test_an_item_is_gone_and_a_second_time_there_is_none(make_rig: MakeRig) -> None:
    rig = make_rig(ItemGone(item=29, at=0.1), ItemGone(item=29, at=0.2))
    rig.ticks(30)
    assert rig.phases() == [("item_gone", BEGAN), ("item_gone", REFUSED)]
    assert [event.number for event in rig.events] == [0, 1]


def test_an_event_strikes_at_its_nth_time(make_rig: MakeRig) -> None:
    rig = make_rig(OdometryJump(dx=1.0, when=BaseAtRest(nth=2)))
    rig.drive(0.2, 0.0, 0.5)
    rig.ticks(150)
    assert rig.events == []
    rig.drive(-0.2, 0.0, 0.5)
    rig.ticks(150)
    assert rig.phases() == [("odometry_jump", BEGAN)]


def test_a_base_that_trembles_on_the_spot_is_at_rest(make_rig: MakeRig) -> None:
    rig = make_rig(OdometryJump(dx=1.0, when=BaseAtRest()))
    rig.drive(0.2, 0.0, 0.5)
    for _ in range(150):
        rig.hardware.step()
        rig.hardware.base.odometer.angular = 0.02
        rig.trouble.step()
    rig.ticks(1)
    assert rig.phases() == [("odometry_jump", BEGAN)]


def test_what_goes_on_already_does_not_begin(make_rig: MakeRig) -> None:
    rig = make_rig(OdometryJump(dx=1.0, when=BaseMoving()))
    rig.drive(0.2, 0.0, 0.5)
    rig.trouble.ask(OdometryJump(dx=1.0, when=BaseMoving()))
    rig.drive(0.2, 0.0, 0.5)
    assert rig.phases() == [("odometry_jump", BEGAN)]


def test_faults_of_one_kind_overlap(make_rig: MakeRig) -> None:
    rig = make_rig(
        BumperPressed(bumper="left", at=0.1, lasts=0.1), BumperPressed(bumper="left", at=0.15, lasts=0.3)
    )
    rig.ticks(30)
    assert rig.hardware.base.jammed == {"left"}
    rig.ticks(30)
    assert rig.hardware.base.jammed == frozenset()


def test_the_same_faults_leave_the_same_run(make_rig: MakeRig) -> None:
    ends = []
    for _ in range(2):
        rig = make_rig(HandOpens(when=ItemLifted(after=0.1)))
        rig.lift(LIFT)
        ends.append(np.array(rig.physics.body_pose(rig.item)[0]))
    assert (ends[0] == ends[1]).all()
