"""The robot's bodies, out of its description."""

from __future__ import annotations

import numpy as np

from skills.arm.problem import HOME
from skills.kinematics.hulls import RobotHulls
from skills.kinematics.model import RobotKinematics
from skills.ports.hardware import RobotDescription


def load_hulls(description: RobotDescription, seed: int = 0) -> RobotHulls:
    """Return the robot's bodies; takes some 0.2 s. The arms of one process can share them."""
    robot = RobotKinematics(description.urdf, {group.name: group.joints for group in description.groups})
    home = {
        joint: value
        for posture in description.postures
        if posture.name == HOME
        for joint, value in zip(description.group(posture.group).joints, posture.positions, strict=True)
    }
    homes = [home] if home else []
    return RobotHulls(robot, homes, np.random.default_rng(seed))
