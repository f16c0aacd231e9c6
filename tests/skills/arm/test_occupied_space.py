"""Arms plan against occupied cells, and stop before those that turn up in their way."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.scene import OCCUPIED, obstacles
from tandem.skills.geometry.poses import transform
from tandem.skills.kinematics.bodies import CellsShape
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.world import SCENE, Box, PlanningScene
from tests.fakes.arm_rig import PANDA_HOME, ArmRig
from tests.fakes.occupied import occupied

START = tuple(np.array(PANDA_HOME) + np.array([-0.9, 0.6, 0, 0, 0, 0, 0]))
END = tuple(np.array(PANDA_HOME) + np.array([0.9, 0.6, 0, 0, 0, 0, 0]))
WALL = Box(size=(0.5, 0.05, 0.6), pose=Pose(position=(0.6, 0.0, 0.3)))
STAMP = RobotTime(boot="b", seconds=1.0)


def scene(rig: ArmRig, *boxes: Box, version: int = 2) -> PlanningScene:
    stamp = rig.hardware.stamp
    return PlanningScene(stamp=stamp, version=version, objects=(), occupied=occupied(stamp, *boxes))


def test_cells_within_reach_are_one_obstacle_where_they_are() -> None:
    base, far = FloorPose(x=0.3, y=-0.2, yaw=0.7), Box(size=(0.2, 0.2, 0.2), pose=Pose(position=(4, 4, 1)))
    told = PlanningScene(stamp=STAMP, version=1, objects=(), occupied=occupied(STAMP, WALL, far))
    (found,) = obstacles(told, base, 1.0)
    assert found.name == OCCUPIED
    assert isinstance(found.shape, CellsShape)
    in_map = np.array(
        [
            transform(
                Pose(position=(base.x, base.y, 0.0), orientation=(0, 0, np.sin(0.35), np.cos(0.35))), each
            )
            for each in (transform(found.pose_in_base, tuple(at)) for at in found.shape.centres)
        ]
    )
    assert in_map.min(axis=0) == pytest.approx((0.375, -0.025, 0.025), abs=0.026)
    assert in_map.max(axis=0) == pytest.approx((0.825, 0.025, 0.575), abs=0.026)
    assert obstacles(told, FloorPose(x=-3, y=-3, yaw=0), 1.0) == ()


def test_a_motion_leads_around_occupied_cells(rig: ArmRig, hulls: RobotHulls) -> None:
    rig.hardware.positions.update(zip(rig.group.joints, START, strict=True))
    SCENE.publish(rig.bus, told := scene(rig, WALL))
    rig.rounds(2)
    assert rig.run(MoveGoal(joints=END)).state is GoalState.SUCCEEDED
    (goal,) = rig.hardware.goals
    cells = obstacles(told, FloorPose(x=0, y=0, yaw=0), 2.0)
    checker = CollisionChecker(hulls, rig.group.joints, {}, cells)
    assert checker.first_contact(np.linspace(START, END, 40)) is not None
    assert checker.first_contact(np.array([each.positions for each in goal.points])) is None


def test_a_motion_ends_before_cells_that_turn_up_in_its_way(rig: ArmRig) -> None:
    rig.hardware.positions.update(zip(rig.group.joints, START, strict=True))
    rig.rounds(2)
    rig.send(MoveGoal(joints=END))
    while not rig.hardware.goals:
        rig.rounds(1)
    rig.rounds(5)
    SCENE.publish(rig.bus, scene(rig, WALL))
    status = rig.until(GoalState.SUCCEEDED, GoalState.FAILED)
    assert status.failure is not None
    assert status.failure.kind is FailureKind.PATH_IN_COLLISION
    assert OCCUPIED in str(status.failure.evidence["contact"])
