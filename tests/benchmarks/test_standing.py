"""When a robot slows down and stands, as the benchmark of stops reads it."""

from __future__ import annotations

import pytest

from benchmarks.standing import STILL, Motion
from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.hardware import BaseVelocity, JointStates, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, JOINT_STATES, ODOMETRY
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.wire.memory import MemoryBus

DESCRIPTION = robot_model("tiago_dual").description
LIMIT = DESCRIPTION.group("arm_left").limits[0]


class Scene:
    """A robot of which one joint and the base are told about."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        self.motion = Motion(self.bus, DESCRIPTION)

    def joint(self, speed: float, at: float) -> None:
        """One message of the joint, heard when it is sent."""
        states = JointStates(
            stamp=RobotTime(boot="b", seconds=at),
            names=(LIMIT.joint,),
            positions=(0.0,),
            velocities=(speed,),
            efforts=(0.0,),
        )
        JOINT_STATES.publish(self.bus, states)
        self.motion.look(at)

    def base(self, linear: float, at: float) -> None:
        """One message of odometry."""
        stamp, here = RobotTime(boot="b", seconds=at), FloorPose(x=0.0, y=0.0, yaw=0.0)
        ODOMETRY.publish(self.bus, Odometry(stamp=stamp, base_in_odom=here, linear=linear, angular=0.0))

    def command(self, linear: float, at: float) -> None:
        """One command to the wheels."""
        BASE_VELOCITY.publish(self.bus, BaseVelocity(linear=linear, angular=0.0))
        self.motion.look(at)


def test_rest_is_held_against_the_stated_deceleration() -> None:
    scene = Scene()
    scene.joint(-1.0, at=1.0)
    scene.motion.mark()
    scene.joint(-0.5, at=1.2)
    assert scene.motion.slower_at == 1.2
    assert not scene.motion.stands
    scene.joint(0.0, at=1.9)
    assert scene.motion.longer == pytest.approx(0.9 - (1.0 - STILL) / LIMIT.acceleration)


def test_a_base_that_still_rolls_does_not_stand() -> None:
    scene = Scene()
    scene.base(0.3, at=1.0)
    scene.joint(0.0, at=1.0)
    scene.motion.mark()
    scene.joint(0.0, at=1.1)
    assert not scene.motion.stands
    scene.base(0.0, at=1.5)
    scene.joint(0.0, at=1.5)
    assert scene.motion.longer == pytest.approx(0.5 - (0.3 - STILL) / DESCRIPTION.driven.acceleration)


def test_a_robot_that_stands_already_is_not_timed() -> None:
    scene = Scene()
    scene.joint(0.0, at=1.0)
    scene.motion.mark()
    scene.joint(0.0, at=1.01)
    assert scene.motion.stands
    assert scene.motion.longer is None


@pytest.mark.parametrize(("before", "braked"), [((0.3, 0.3), 2.0), ((0.3, 0.2), None)])
def test_a_base_that_slowed_down_before_tells_nothing(
    before: tuple[float, ...], braked: float | None
) -> None:
    scene = Scene()
    for speed in before:
        scene.command(speed, at=1.0)
    scene.motion.mark()
    scene.command(0.1, at=2.0)
    assert scene.motion.braked_at == braked
