"""What a stranger publishes on a robot's ROS topics is counted by topic and reason, and ends no process."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills.ports import keys
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.keys import Latest
from tandem.skills.ros import types
from tandem.skills.ros.naming import data_key
from tests.skills.ros.ros_rig import ODOM, SCAN, SONAR, TF_POSE, Rig

POSE = {"topic": "/mocap", "type": types.POSE_STAMPED, "to": "pose", "sensor": "markers"}
JOINTS = {"topic": "/j", "type": types.JOINT_STATE, "to": "joints"}
BAD = (float("nan"), float("inf"), 1e300)


def odometry(rig: Rig, value: float, *, twist: bool) -> None:
    told = rig.odometry(0.0 if twist else value, 0.0, 0.0, value if twist else 0.0)
    rig.tell("/odom", types.ODOMETRY, **told)


def mocap(rig: Rig, value: float) -> None:
    rig.tell("/mocap", types.POSE_STAMPED, header=rig.header("map"), pose=rig.pose(value, 0.0, 0.0))


def turned(rig: Rig, value: float) -> None:
    rig.tell("/mocap", types.POSE_STAMPED, header=rig.header("map"), pose=rig.pose(0.0, 0.0, value))


def tf(rig: Rig, value: float) -> None:
    rig.tell("/tf", types.TF, transforms=[rig.transform("map", "base_link", (value, 0.0, 0.0))])


def joints(rig: Rig, value: float, velocity: float = 0.0) -> None:
    names = [joint for group in rig.description.groups for joint in group.joints]
    names += [joint for hand in rig.description.end_effectors for joint in hand.gripper.joints]
    zero = np.zeros(len(names))
    told = {"position": zero + value, "velocity": zero + velocity, "effort": zero}
    rig.tell("/j", types.JOINT_STATE, header=rig.header(), name=names, **told)


def scan(rig: Rig, value: float, beams: int | None = None) -> None:
    laser = rig.description.lasers[0]
    rig.tell(
        "/scan",
        types.LASER_SCAN,
        header=rig.header(laser.frame),
        angle_min=value,
        angle_max=0.0,
        angle_increment=laser.angle_step,
        time_increment=0.0,
        scan_time=0.1,
        range_min=0.05,
        range_max=10.0,
        ranges=np.full(laser.beams if beams is None else beams, 2.0, np.float32),
        intensities=np.array([], np.float32),
    )


Told = Callable[[Rig], None]
HOSTILE: list[tuple[str, dict[str, str], Told, Reason]] = [
    *(("p3dx", ODOM, lambda rig, v=v: odometry(rig, v, twist=False), Reason.MISFIT) for v in BAD),
    *(("p3dx", ODOM, lambda rig, v=v: odometry(rig, v, twist=True), Reason.MISFIT) for v in BAD),
    *(("p3dx", POSE, lambda rig, v=v: mocap(rig, v), Reason.MISFIT) for v in BAD),
    ("p3dx", POSE, lambda rig: turned(rig, float("nan")), Reason.MISFIT),
    *(("p3dx", TF_POSE, lambda rig, v=v: tf(rig, v), Reason.MISFIT) for v in BAD),
    *(("panda", JOINTS, lambda rig, v=v: joints(rig, v), Reason.MISFIT) for v in BAD),
    *(("tiago_base", SCAN, lambda rig, v=v: scan(rig, v), Reason.MISFIT) for v in BAD[:2]),
    ("tiago_base", SCAN, lambda rig: scan(rig, 0.0, beams=0), Reason.MISFIT),
]


def raw(rig: Rig, made: dict[str, str], payload: bytes, told: str = "") -> None:
    rig.net.put(data_key(0, made["topic"], made["type"], told or types.HASHES[made["type"]]), payload)


def rig_of(robot: str, *inputs: dict[str, str]) -> Rig:
    made = Rig(robot, inputs, None)
    made.step(0.1)
    return made


@pytest.mark.parametrize(("robot", "made", "tell", "reason"), HOSTILE)
def test_numbers_that_are_none_are_counted_and_end_nothing(
    robot: str, made: dict[str, str], tell: Told, reason: Reason
) -> None:
    rig = rig_of(robot, made)
    tell(rig)
    rig.step()
    assert rig.bus.ear.refused == {(made["topic"], reason): 1}


@pytest.mark.parametrize("made", [ODOM, SCAN, SONAR, TF_POSE])
@pytest.mark.parametrize(
    ("payload", "told", "reason"),
    [
        (b"", "", Reason.MALFORMED),
        (b"\xff" * 64, "", Reason.MALFORMED),
        (b'{"stamp": {"boot": "b", "seconds": 1}}', "", Reason.MALFORMED),
        (b"\x00\x01\x00\x00" + b"\xff" * 100_000, "", Reason.MALFORMED),
        (b"\x00\x01\x00\x00", "RIHS01_other", Reason.MISFIT),
    ],
)
def test_what_is_no_message_of_the_type_is_counted(
    made: dict[str, str], payload: bytes, told: str, reason: Reason
) -> None:
    rig = rig_of("tiago_base" if made is SCAN else "p3dx", made)
    raw(rig, made, payload, told)
    rig.step()
    assert rig.bus.ear.refused == {(made["topic"], reason): 1}


def test_a_joint_whose_velocity_is_not_measured_is_told_at_rest() -> None:
    rig = rig_of("panda", JOINTS)
    heard = Latest(rig.bus, keys.JOINT_STATES)
    joints(rig, 0.0, velocity=float("nan"))
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert set(told.velocities) == {0.0}
