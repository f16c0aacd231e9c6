"""Is the base where it should be?"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.check import Check
from tandem.trees.context import TreeContext

POSITION_TOLERANCE: Final = 0.06
"""Metres within which the base need not be driven again."""
YAW_TOLERANCE: Final = math.radians(5.0)
"""Radians, likewise."""


def near(context: TreeContext, pose: FloorPose) -> bool:
    """Say whether the localised robot stands at ``pose``."""
    robot = context.knowledge.robot
    return (
        robot is not None
        and robot.localised
        and floor_distance(robot.base_in_map, pose) < POSITION_TOLERANCE
        and abs(wrap(robot.base_in_map.yaw - pose.yaw)) < YAW_TOLERANCE
    )


def at_any(name: str, context: TreeContext, poses: Callable[[], tuple[FloorPose, ...]]) -> Check:
    """Return the condition "the base stands at one of the poses"."""
    return Check(name, lambda: any(near(context, pose) for pose in poses()))
