"""Which joints the arm goes for while its item moves: those before, bent a little, or others."""

from __future__ import annotations

from collections.abc import Generator
from typing import TYPE_CHECKING, cast

import numpy as np
import pytest

from tandem.skills.arm.field.ends import FOLD, Ends
from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.target import Target
from tandem.skills.arm.plan_move import Reached
from tandem.skills.arm.problem import Arm
from tandem.skills.ports.keys import JOINT_STATES
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import ROBOT_POSE, SCENE, PlanningScene
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.field_rig import goal
from tests.fakes.robot_pose import localised
from tests.skills.reflex.two_arms import joint_states, positions, robot

if TYPE_CHECKING:
    from tandem.skills.arm.plan_move import MovePlanner

BEFORE_IT = np.array([0.663, 0.515, 0.985, 1.383, 0.737, -1.192, 0.422])
"""A left arm, well within its limits."""
NOW = RobotTime(boot="test", seconds=1.0)


class Planner:
    """Finds the same joints each time; says whether the grasp can be reached from others."""

    def __init__(self, *, goes_on: bool) -> None:
        self.reached, self._goes_on = 0, goes_on

    def reach(self, *_: object) -> Generator[int, None, Reached]:
        self.reached += 1
        yield 1
        return Reached(0, BEFORE_IT)

    def goes_on(self, *_: object) -> Generator[int, None, bool]:
        yield 1
        return self._goes_on


class Case:
    """An arm before its item, which then is moved towards the robot's left."""

    def __init__(self, planner: Planner) -> None:
        self.description, self.hulls = robot()
        bus, arm = MemoryBus(), Arm(self.hulls, self.description, "arm_left")
        live = Live(bus, SteppedClocks("test"), arm)
        JOINT_STATES.publish(bus, joint_states(1.0, positions(left=tuple(BEFORE_IT))))
        SCENE.publish(bus, PlanningScene(stamp=NOW, version=1, objects=()))
        ROBOT_POSE.publish(bus, localised(NOW))
        live.refresh()
        self.ends = Ends(arm, cast("MovePlanner", planner), live, goal())
        self.think(0.0)

    def think(self, moved: float) -> None:
        tool = self.hulls.robot.pose("gripper_left_grasping_frame", positions(left=tuple(BEFORE_IT)))
        x, y, z = tool.position
        there = Pose(position=(x, y + moved, z), orientation=tool.orientation)
        target = Target(item=there, proximity=(there,), grasps=(there,))
        for _ in range(100):
            self.ends.think(target, BEFORE_IT)
            if not self.ends.busy:
                return
        raise AssertionError("it looks for ever")


def test_an_item_that_moves_a_little_is_followed_with_joints_bent_a_little() -> None:
    planner = Planner(goes_on=True)
    case = Case(planner)
    case.think(0.02)
    assert case.ends.end is not None
    bent = np.abs(case.ends.end.q - BEFORE_IT).max()
    assert 0.0 < bent < FOLD
    assert (planner.reached, case.ends.aside) == (1, False)
    there = case.hulls.robot.pose("gripper_left_grasping_frame", positions(left=tuple(case.ends.end.q)))
    before = case.hulls.robot.pose("gripper_left_grasping_frame", positions(left=tuple(BEFORE_IT)))
    assert there.position[1] - before.position[1] == pytest.approx(0.02, abs=2e-3)


def test_joints_from_which_the_grasp_can_not_be_reached_are_chosen_anew() -> None:
    planner = Planner(goes_on=False)
    case = Case(planner)
    case.think(0.02)
    assert (planner.reached, case.ends.aside) == (2, True)


def test_an_item_that_stands_is_not_thought_about_again() -> None:
    planner = Planner(goes_on=True)
    case = Case(planner)
    case.think(0.0)
    assert planner.reached == 1
