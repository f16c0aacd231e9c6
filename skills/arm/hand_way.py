"""The way that a hand takes along a planned motion, for who looks on."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tandem.skills.arm.problem import Arm
from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.ports.actions.arm import MOST_CORNERS
from tandem.skills.ports.message import Vector3


def hand_way(arm: Arm, positions: Mapping[str, float], trajectory: Trajectory) -> tuple[Vector3, ...]:
    """Return where the tool frame is along a motion (m, in the base's frame), from its begin to its end.

    Args:
        arm: the group; one without a hand has no way.
        positions: of all joints; those of the group count only as far as the motion does not say them.
        trajectory: the motion. It is sampled at ``MOST_CORNERS`` moments, evenly in time.
    """
    if arm.hand is None or len(trajectory.times) == 1:
        return ()
    way: list[Vector3] = []
    for q in trajectory.sample(np.linspace(0.0, trajectory.duration, MOST_CORNERS)):
        standing = {**positions, **dict(zip(arm.group.joints, map(float, q), strict=True))}
        x, y, z = arm.hulls.robot.pose(arm.hand.frame, standing).position
        way.append((round(x, 3), round(y, 3), round(z, 3)))
    return tuple(way)
