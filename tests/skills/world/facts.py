"""Facts that the tests of the world share."""

from __future__ import annotations

import math

from tandem.skills.geometry.poses import about, multiply
from tandem.skills.grasping.item_frames import TAG_TURN
from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box, Sighting


def at(seconds: float, boot: str = "b") -> RobotTime:
    return RobotTime(boot=boot, seconds=seconds)


def tag(x: float, y: float, facing: float = math.pi, z: float = 0.74) -> Pose:
    """An upright tag that looks along the heading ``facing``."""
    return Pose(position=(x, y, z), orientation=multiply(about((0, 0, 1), facing), TAG_TURN))


def sighting(item: int, pose: Pose, seconds: float, quality: float = 0.8) -> Sighting:
    return Sighting(
        item=item,
        stamp=at(seconds),
        tag_in_map=pose,
        tag_in_base=pose,
        tag_in_camera=pose,
        distance=1.0,
        quality=quality,
        position_sigma=0.001,
    )


def cube(x: float, y: float, z: float = 0.76, edge: float = 0.1) -> Box:
    size: Vector3 = (edge, edge, edge)
    return Box(size=size, pose=Pose(position=(x, y, z)))
