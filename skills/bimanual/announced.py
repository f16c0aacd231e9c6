"""Which ways the arms have told that they go, as joint positions: what eager coordination looks along.

An arm that approaches tells its item and the joints at its proximity pose. Its hand goes straight there,
then on to the item, then its joints straight to its safe place. One that has approached and holds nothing
yet has the grasp and the way out before it; any other one the way out. The follower's way is its own record
from where it stands to where it was when it turned back, then its hand straight to its goal.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tandem.skills.bimanual.observer import ArmObserver
from tandem.skills.bimanual.way import joined, straight, thinned
from tandem.skills.geometry.poses import transform
from tandem.skills.kinematics.described import by_name
from tandem.skills.kinematics.hand_following import PoseFollower
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.approach import GOAL_RADIUS
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import HandName, Vector3
from tandem.skills.ports.robot_description import RobotDescription

OUT: Final = 5
"""Positions that are looked at of the way out."""
NEXT: Final = 3
"""Positions of its way for which the follower goes on while the leader's field runs: 12 cm of its hand."""
CREEP: Final = 1
"""The same once the leader goes only where it has planned to go: nothing is slowed down by who comes near."""


class Announced:
    """Both arms' ways.

    Args:
        description: the robot.
        hulls: its bodies.
        arms: what is seen of each.
    """

    def __init__(
        self, description: RobotDescription, hulls: RobotHulls, arms: Mapping[HandName, ArmObserver]
    ) -> None:
        self._description, self._hulls, self._arms = description, hulls, arms

    def whole(self, joints: JointStates, side: HandName, *, holds: bool) -> list[Array]:
        """Return positions (n,) from where the arm is until it is in its safe place again.

        Args:
            joints: as they are now.
            side: which arm.
            holds: whether its hand holds something.
        """
        arm = self._arms[side]
        way = [arm.q, *self._in(joints, arm)[1::2]]
        if arm.goal_at is not None and not holds:
            way += [arm.goal_at, *self._grasp(joints, arm)[-1:]]
        return [*way, *joined(way[-1], arm.safe_at, OUT)]

    def ahead(self, joints: JointStates, side: HandName) -> list[Array]:
        """Return positions (n,) from where the arm is to its proximity pose, about 4 cm of the hand apart."""
        arm = self._arms[side]
        way = [arm.q, *thinned(arm.ahead())]
        return [*way, *self._in(joints, arm, way[-1])]

    def next(self, joints: JointStates, side: HandName, count: int) -> list[Array]:
        """Return the first so many of those that lie ahead; with the grasp when that is next."""
        way = self.ahead(joints, side)
        arm = self._arms[side]
        if len(way) > count + 1 or arm.goal_at is None:
            return way[: count + 1]
        return [*way, arm.goal_at, *self._grasp(joints, arm)[-1:]]

    def _in(self, joints: JointStates, arm: ArmObserver, q: Array | None = None) -> list[Array]:
        """Return positions on the hand's straight way to its proximity pose."""
        told = arm.approach
        if not arm.approaching or told is None or told.goal_in_base is None:
            return []
        follower = self._follower(joints, arm)
        start = arm.q if q is None else q
        if arm.goal_at is None:
            return straight(follower, start, told.goal_in_base, GOAL_RADIUS)
        return straight(follower, start, follower.pose(arm.goal_at).position, 0.0)

    def _grasp(self, joints: JointStates, arm: ArmObserver) -> list[Array]:
        """Return positions from the proximity pose on to the grasp."""
        assert arm.goal_at is not None  # asked only then
        follower = self._follower(joints, arm)
        grasp: Vector3 = transform(follower.pose(arm.goal_at), (GOAL_RADIUS, 0.0, 0.0))
        return straight(follower, arm.goal_at, grasp, 0.0)

    def _follower(self, joints: JointStates, arm: ArmObserver) -> PoseFollower:
        return PoseFollower(
            self._hulls.robot,
            arm.joints,
            by_name(joints.names, joints.positions),
            frame=self._description.end_effector(arm.side).frame,
            limits=self._hulls.robot.limits(arm.joints),
        )
