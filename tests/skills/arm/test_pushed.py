"""Has the base been pushed since a motion to a place in the map was planned?"""

from __future__ import annotations

import math
from typing import Literal

import pytest

from tandem.skills.arm.pushed import PushedBase
from tandem.skills.geometry.poses import from_rpy
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.world import ROBOT_POSE, RobotPose
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.arm_rig import ArmRig, panda

AHEAD = Candidate(pose=Pose(position=(0.45, 0.2, 0.4), orientation=from_rpy(math.pi, 0.0, 0.0)))
ORIGIN = FloorPose(x=0.0, y=0.0, yaw=0.0)


class Told:
    """What the robot tells of its pose after a plan was made at the map's origin."""

    def __init__(self, frame: Literal["map", "base"] = "map") -> None:
        self.bus = MemoryBus()
        self.base = PushedBase(Latest(self.bus, ROBOT_POSE), "arm/move")
        self.base.begin(MoveGoal(candidates=(AHEAD,), frame=frame), ORIGIN)

    def tell(self, pose: FloorPose, *, localised: bool = True) -> None:
        told = RobotPose(
            stamp=RobotTime(boot="test", seconds=1.0),
            localised=localised,
            base_in_map=pose,
            odom_in_map=ORIGIN,
            position_sigma=0.0,
            yaw_sigma=0.0,
            moving=False,
        )
        ROBOT_POSE.publish(self.bus, told)


@pytest.mark.parametrize(
    ("pose", "moved_m"),
    [
        (FloorPose(x=0.04, y=0.0, yaw=0.0), 0.04),
        (FloorPose(x=0.0, y=0.0, yaw=0.1), 2 * math.sin(0.05) * math.hypot(0.45, 0.2)),
    ],
    ids=["aside", "turned"],
)
def test_the_goal_is_elsewhere_for_a_base_that_was_pushed(pose: FloorPose, moved_m: float) -> None:
    told = Told()
    told.tell(pose)
    failure = told.base.moved()
    assert failure is not None
    assert failure.kind is FailureKind.ARM_STOPPED
    assert failure.evidence["moved_m"] == pytest.approx(moved_m, abs=1e-4)


@pytest.mark.parametrize(
    ("pose", "localised", "frame"),
    [
        (FloorPose(x=0.012, y=0.0, yaw=0.02), True, "map"),
        (FloorPose(x=0.5, y=0.0, yaw=0.0), False, "map"),
        (FloorPose(x=0.5, y=0.0, yaw=0.0), True, "base"),
    ],
    ids=["noise", "does not know where it is", "goal in the base's frame"],
)
def test_the_motion_goes_on(pose: FloorPose, *, localised: bool, frame: Literal["map", "base"]) -> None:
    told = Told(frame)
    told.tell(pose, localised=localised)
    assert told.base.moved() is None


@pytest.mark.parametrize("rounds", [2, 60], ids=["while it is planned", "while it moves"])
def test_an_arm_stops_for_a_place_that_is_elsewhere_now(hulls: RobotHulls, rounds: int) -> None:
    rig = ArmRig(panda(), "arm", hulls=hulls)
    rig.send(MoveGoal(candidates=(AHEAD,)))
    rig.rounds(rounds)
    rig.tell_pose(0.10)
    status = rig.until(GoalState.SUCCEEDED, GoalState.FAILED)
    assert status.failure is not None
    assert status.failure.kind is FailureKind.ARM_STOPPED
    assert "has been pushed" in status.failure.message
    before = dict(rig.hardware.positions)
    rig.rounds(20)
    assert rig.hardware.positions == before
