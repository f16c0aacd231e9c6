"""The arms as lines in the base, so that the camera does not take them for clutter."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import transform
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.ports.message import HandName, Vector3
from tandem.skills.ports.pose import Pose

_BEYOND_TOOL = 0.06
"""Metres beyond the tool frame, for what is held."""


class Arms:
    """The chains to the tool frames."""

    def __init__(self, description: RobotDescription) -> None:
        """Read the chains."""
        self._chains = {
            hand.side: Chain.from_urdf(description.urdf, description.base_frame, hand.frame)
            for hand in description.end_effectors
        }

    def hands(self, positions: Mapping[str, float]) -> Mapping[HandName, Pose]:
        """Return each hand's tool frame in the base at these joint positions; none while they are unknown."""
        return {side: chain.pose(positions) for side, chain in self._chains.items()} if positions else {}

    def segments(self, positions: Mapping[str, float]) -> tuple[tuple[Vector3, Vector3], ...]:
        """Return the lines from joint to joint (m, in the base) at these joint positions."""
        lines: list[tuple[Vector3, Vector3]] = []
        for chain in self._chains.values():
            poses = chain.poses(positions)
            beyond = transform(poses[-1], (_BEYOND_TOOL, 0.0, 0.0))
            points = [pose.position for pose in poses] + [beyond]
            lines.extend(pairwise(points))
        return tuple(lines)
