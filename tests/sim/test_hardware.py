"""The hardware node over physics, driven through its messages."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from benchmarks.rig import GRASP, LIFT, Rig
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer, BaseVelocity, CancelMotion, MotionState, Stop, StopRelease
from tandem.skills.ports.lease import Claim, Lease, LeaseRequest


@pytest.fixture
def rig() -> Iterator[Rig]:
    made = Rig(friction=None)
    made.ticks(10)
    yield made
    made.close()


def test_it_describes_itself(rig: Rig) -> None:
    pending = keys.DESCRIPTION.query(rig.bus, keys.Nothing())
    rig.ticks(1)
    payload = pending.poll()
    assert payload is not None
    assert keys.DESCRIPTION.decode_answer(payload) == rig.model.description


def test_a_trajectory_ends_where_it_says(rig: Rig) -> None:
    status = rig.move("arm_left", GRASP, 1.0)
    assert status.state is MotionState.SUCCEEDED
    assert np.abs(rig.positions("arm_left") - GRASP).max() < 0.002


def test_an_arm_at_rest_does_not_sag(rig: Rig) -> None:
    rig.move("arm_left", LIFT, 1.0)
    rig.ticks(100)
    before = rig.body.frame_matrix("gripper_left_grasping_frame")[:3, 3]
    rig.ticks(200)
    after = rig.body.frame_matrix("gripper_left_grasping_frame")[:3, 3]
    assert np.linalg.norm(after - before) < 1e-4


def test_an_arm_that_is_blocked_aborts_and_names_the_joint(rig: Rig) -> None:
    x, y, z = rig.body.frame_matrix("gripper_left_grasping_frame")[:3, 3]
    rig.physics.add_box((0.05, 0.6, 0.6), 0.0, (x + 0.06, y, z))
    status = rig.move("arm_left", (0.9, 0.5, 1.1, 0.6, -0.9, -0.5, -0.3), 2.0)
    assert status.state is MotionState.ABORTED
    assert status.joint.startswith("arm_left_")
    assert status.error > 0.15


def test_what_is_not_a_goal_is_refused_with_the_place_of_the_mistake(rig: Rig) -> None:
    pending = rig.bus.query("hw/group/torso/goal", b'{"id": "x", "points": [{"time": 0}]}')
    rig.ticks(1)
    payload = pending.poll()
    assert payload is not None
    answer = Answer.model_validate_json(payload)
    assert not answer.accepted
    assert answer.reason.startswith("points.0.positions")


def test_the_stop_brings_all_to_rest_and_keeps_it_there(rig: Rig) -> None:
    rig.send("arm_left", rig.goal("arm_left", LIFT, 1.0))
    rig.drive(0.3, 0.0, 0.5)
    keys.STOP.query(rig.bus, Stop(by="test", reason="to see"))
    rig.ticks(100)
    assert rig.status("arm_left").state is MotionState.ABORTED
    where = rig.positions("arm_left"), rig.body.base_pose()[0]
    assert "stop" in rig.send("arm_left", rig.goal("arm_left", GRASP, 1.0)).reason
    rig.drive(0.3, 0.0, 0.5)
    assert np.allclose(where[0], rig.positions("arm_left"), atol=1e-3)
    assert np.allclose(where[1], rig.body.base_pose()[0], atol=1e-3)
    keys.STOP_RELEASE.query(rig.bus, StopRelease(by="test"))
    rig.ticks(1)
    assert rig.send("arm_left", rig.goal("arm_left", LIFT, 1.5)).accepted


def lease(rig: Rig, role: str, generation: int) -> Lease:
    """Ask for the lease of a role as the so-manieth process of one parent."""
    claim = Claim("aa", generation, 1, "host").text
    pending = keys.LEASE.query(rig.bus, LeaseRequest(role=role, claim=claim))
    rig.ticks(1)
    granted = keys.LEASE.decode_answer(pending.poll() or b"").lease
    assert granted is not None
    return granted


def test_whoever_was_replaced_moves_nothing_and_may_still_bring_all_to_rest(rig: Rig) -> None:
    old, arm = lease(rig, "base", 1), lease(rig, "arm_left", 1)
    base, later = lease(rig, "base", 2), lease(rig, "arm_left", 2)
    assert (old.epoch, base.epoch) == (1, 2)
    where = rig.body.base_pose()[0]
    for command in (None, old, old.model_copy(update={"boot": "before"})):
        keys.BASE_VELOCITY.publish(rig.bus, BaseVelocity(linear=0.3, angular=0.0, lease=command))
        rig.ticks(20)
    assert np.allclose(where, rig.body.base_pose()[0], atol=1e-3)
    assert sum(rig.bus.ear.refused.values()) == 3
    for command, said in ((None, "no lease"), (arm, "epoch 1 is over")):
        goal = rig.goal("arm_left", LIFT, 1.0).model_copy(update={"lease": command})
        answer = rig.send("arm_left", goal)
        assert not answer.accepted
        assert said in answer.reason
    goal = rig.goal("arm_left", LIFT, 1.0).model_copy(update={"lease": later})
    assert rig.send("arm_left", goal).accepted
    both = rig.goal("arm_right", GRASP, 4.0).model_copy(update={"lease": lease(rig, "bimanual", 1)})
    assert rig.send("arm_right", both).accepted, "roles don't share a lease"
    rig.ticks(20)
    keys.group_cancel("arm_left").query(rig.bus, CancelMotion(lease=arm))
    rig.ticks(100)
    assert rig.status("arm_left").state is MotionState.CANCELED


def test_the_wheels_carry_the_base_as_odometry_says_and_it_stands_still(rig: Rig) -> None:
    odometry = keys.Latest(rig.bus, keys.ODOMETRY)
    rig.drive(0.4, 0.5, 2.0)
    rig.ticks(200)
    seen = odometry.refresh()
    assert seen is not None
    position, orientation = rig.body.base_pose()
    assert (seen.base_in_odom.x, seen.base_in_odom.y) == pytest.approx(position[:2], abs=0.003)
    rig.ticks(300)
    assert rig.body.base_pose()[0] == pytest.approx(position, abs=5e-4)
    assert rig.body.base_pose()[1] == pytest.approx(orientation, abs=5e-4)


def test_a_bumper_tells_on_which_side_the_base_touches(rig: Rig) -> None:
    bumpers = keys.Latest(rig.bus, keys.BUMPERS)
    rig.physics.add_box((0.1, 1.0, 0.3), 0.0, (0.45, 0.0, 0.15))
    rig.drive(0.3, 0.0, 1.5)
    told = bumpers.refresh()
    assert told is not None
    assert told.pressed == ("front",)


def test_the_wrist_feels_the_weight_of_the_hand(rig: Rig) -> None:
    wrench = keys.Latest(rig.bus, keys.wrench("left"))
    rig.ticks(50)
    told = wrench.refresh()
    assert told is not None
    turn = rig.body.frame_matrix("wrist_left_ft_tool_link")[:3, :3]
    assert turn @ np.array(told.force) == pytest.approx([0.0, 0.0, -0.8 * 9.81], abs=0.1)


def test_the_clock_comes_last_in_each_period(rig: Rig) -> None:
    everything = rig.bus.subscribe("hw/**")
    rig.ticks(1)
    heard = [sample.key for sample in everything.drain()]
    assert heard[0] == keys.JOINT_STATES.key
    assert heard[-1] == keys.CLOCK.key


def test_a_command_that_is_old_stops_the_base(rig: Rig) -> None:
    keys.BASE_VELOCITY.publish(rig.bus, BaseVelocity(linear=0.1, angular=0.0))
    rig.ticks(100)
    assert rig.hardware.base.controller.linear == 0.0
