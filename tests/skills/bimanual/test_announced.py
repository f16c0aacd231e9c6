"""Which ways arms have announced, in joint positions; seen by where they lead the hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.bimanual.announced import NEXT, OUT, Announced
from tandem.skills.bimanual.observer import ArmObserver
from tandem.skills.geometry.poses import transform
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.approach import GOAL_RADIUS, ApproachStatus, approach_status
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, joint_states, positions, robot

GOAL: Vector3 = (0.6, 0.1, 0.8)


class Told:
    """The left arm, which has told where it goes, and the ways that follow from it."""

    def __init__(self, *, active: bool = True, at: tuple[float, ...] = ASIDE) -> None:
        description, hulls = robot()
        assert description.arms_crossing is not None
        self.bus = MemoryBus()
        self.arm = ArmObserver(self.bus, description, description.arms_crossing, "left")
        self.ways = Announced(description, hulls, {"left": self.arm})
        self.joints: JointStates = joint_states(0.0, positions(left=at))
        self._frame, self._robot = description.end_effector("left").frame, hulls.robot
        self._tell(0.0, active=True)
        if not active:
            self._tell(0.0, active=False)

    def _tell(self, seconds: float, *, active: bool) -> None:
        status = ApproachStatus(
            stamp=RobotTime(boot="test", seconds=seconds),
            side="left",
            active=active,
            distance=0.4,
            goal_in_base=GOAL,
            goal_positions=IN_FRONT if active else (),
        )
        approach_status("arm_left").publish(self.bus, status)
        self.arm.look(self.joints)

    def hand(self, q: Array) -> Vector3:
        return self._robot.pose(self._frame, positions(left=tuple(map(float, q)))).position

    @property
    def grasp(self) -> Vector3:
        """Where the hand grasps: straight on from its proximity pose."""
        end = self._robot.pose(self._frame, positions(left=IN_FRONT))
        return transform(end, (GOAL_RADIUS, 0.0, 0.0))

    def reaches(self, way: list[Array], point: Vector3) -> bool:
        return min(math.dist(self.hand(q), point) for q in way) < 0.01


@pytest.mark.parametrize(
    ("active", "holds", "grasps"), [(True, False, True), (False, False, True), (False, True, False)]
)
def test_the_whole_way_leads_by_the_grasp_unless_that_is_made_and_home(
    *, active: bool, holds: bool, grasps: bool
) -> None:
    told = Told(active=active)
    way = told.ways.whole(told.joints, "left", holds=holds)
    assert way[0] == pytest.approx(ASIDE)
    assert told.reaches(way, told.grasp) is grasps
    assert way[-1] == pytest.approx(told.arm.safe_at)


def test_what_only_goes_home_goes_there_straight() -> None:
    told = Told(active=False)
    way = told.ways.whole(told.joints, "left", holds=True)
    assert len(way) == OUT + 1
    assert np.allclose(np.diff(np.array(way), axis=0), (told.arm.safe_at - np.array(ASIDE)) / OUT)


def test_what_lies_ahead_ends_at_the_proximity_pose() -> None:
    told = Told()
    way = told.ways.ahead(told.joints, "left")
    assert math.dist(told.hand(way[-1]), told.hand(np.array(IN_FRONT))) < 0.01


def test_the_next_part_is_the_first_of_what_lies_ahead() -> None:
    told = Told()
    way, part = told.ways.ahead(told.joints, "left"), told.ways.next(told.joints, "left", NEXT)
    assert len(way) > NEXT + 1 == len(part)
    assert np.allclose(part, way[: NEXT + 1])


def test_the_last_part_leads_on_to_the_grasp() -> None:
    told = Told(at=tuple(0.9 * np.array(IN_FRONT) + 0.1 * np.array(ASIDE)))
    assert told.reaches(told.ways.next(told.joints, "left", NEXT), told.grasp)
