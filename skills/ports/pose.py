"""Poses as messages. Their arithmetic is in ``skills/geometry/poses.py``.

Frames are right-handed, x forward (REP-103); quaternions are x, y, z, w. A pose's name says which frame
in which: ``tag_in_map`` maps points of the tag's frame into the map.
"""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import AfterValidator

from tandem.skills.ports.message import Message, Quaternion, Vector3


def _unit(quaternion: Quaternion) -> Quaternion:
    x, y, z, w = quaternion
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    if abs(norm - 1.0) > 1e-3:  # noqa: PLR2004
        raise ValueError(f"expected a unit quaternion (x, y, z, w), this one has length {norm:.4f}")
    if abs(norm - 1.0) < 1e-12:  # noqa: PLR2004 - as good as it gets; so that a message read again is the same
        return quaternion
    return (x / norm, y / norm, z / norm, w / norm)


class Pose(Message):
    """A rigid transform: position in metres and orientation as unit quaternion (x, y, z, w)."""

    position: Vector3 = (0.0, 0.0, 0.0)
    orientation: Annotated[Quaternion, AfterValidator(_unit)] = (0.0, 0.0, 0.0, 1.0)


class FloorPose(Message):
    """A pose on the floor: x and y in metres, yaw in radians about z, in (-pi, pi] where computed here."""

    x: float
    y: float
    yaw: float


IDENTITY = Pose()
