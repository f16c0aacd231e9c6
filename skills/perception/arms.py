"""The arms as lines in the base, so that the camera does not take them for clutter."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from itertools import pairwise

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import transform
from tandem.skills.ports.message import HandName, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import RobotDescription

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
        self._arms = [
            (self._chains[hand.side], description.group(hand.group).joints)
            for hand in description.end_effectors
        ]

    @property
    def reach(self) -> float:
        """Metres from the base's axis, in plan, that no hand gets beyond, nor what it holds.

        A stretched arm is as long as the way from joint to joint is. Joints before the arm's own (a torso's)
        are taken to lift. Infinity without a hand, and for an arm that slides out.
        """
        return max((_stretched(*each) for each in self._arms), default=math.inf)

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


def _stretched(chain: Chain, joints: Collection[str]) -> float:
    """Return the metres in plan from the root to the tip with the arm, these joints, stretched out."""
    first = next(index for index, step in enumerate(chain.steps) if step.name in joints)
    at_zero = chain.poses(dict.fromkeys((step.name for step in chain.steps), 0.0))
    shoulder = at_zero[first].position
    if any(step.kind == "prismatic" for step in chain.steps[first:]):
        return math.inf
    parts = (*(step.origin for step in chain.steps[first + 1 :]), chain.end)
    length = sum(math.hypot(*part.position) for part in parts)
    return math.hypot(*shoulder[:2]) + length + _BEYOND_TOOL
