"""One arm as it is led by set-points: what it was last told, and the next that it is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from tandem.skills.kinematics.hand_following import Followed, PoseFollower
from tandem.skills.kinematics.model import Limits, RobotKinematics
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.hardware import SetPoint
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import RobotDescription

LIMIT_MARGIN: Final = 0.01
"""Radians that the joints keep from their limits."""


class LedArm:
    """One arm with its hand.

    Args:
        description: the robot.
        robot: its kinematics.
        side: which hand.
    """

    def __init__(self, description: RobotDescription, robot: RobotKinematics, side: HandName) -> None:
        hand = description.end_effector(side)
        group = description.group(hand.group)
        self.side: HandName = side
        self.group, self.joints, self.frame = group.name, group.joints, hand.frame
        self._robot = robot
        self._limits = Limits(
            np.array([each.lower for each in group.limits]) + LIMIT_MARGIN,
            np.array([each.upper for each in group.limits]) - LIMIT_MARGIN,
            np.array([each.velocity for each in group.limits]),
        )
        self._follower: PoseFollower | None = None
        self.q: Array = np.zeros(len(group.joints))
        """What the joints were last told (n,)."""

    def begin(self, positions: Mapping[str, float]) -> None:
        """Begin from where all joints stand."""
        self.q = np.array([positions[joint] for joint in self.joints])
        self._follower = PoseFollower(
            self._robot, self.joints, positions, frame=self.frame, limits=self._limits
        )

    def towards(self, tool_in_base: Pose, period: float, now: RobotTime) -> SetPoint:
        """Return the next set-point on the way to a pose; no joint goes faster than it may."""
        most = self._limits.velocity * period
        step = np.clip(self.ahead(self.q, tool_in_base).q - self.q, -most, most)
        self.q = self.q + step
        return SetPoint(
            stamp=now,
            positions=tuple(map(float, self.q)),
            velocities=tuple(map(float, step / period)),
        )

    def ahead(self, q: Array, tool_in_base: Pose) -> Followed:
        """Return joint positions near q (n,) for a pose, and by how much they miss it. Moves nothing."""
        assert self._follower is not None, "begin first"
        return self._follower.follow(q, tool_in_base)

    def seconds(self, q: Array, further: Array) -> float:
        """Return the seconds from q to further (n,) with each joint at its full speed."""
        return float(np.max(np.abs(further - q) / self._limits.velocity))

    def strayed(self, positions: Mapping[str, float]) -> float:
        """Return by how many radians the joint that is farthest off is off what it was told."""
        return float(np.max(np.abs(self.q - [positions[joint] for joint in self.joints])))
