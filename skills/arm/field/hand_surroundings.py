"""What stands around a hand, as the choice of its way sees it: posts with a round base, and large boxes.

Two-arm thesis, 4.1.2: an obstacle has a regular base, r is the farthest that the base reaches from its
centre, and a hand keeps d(e, Q) > r + d_s.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose

POST_AT_MOST: Final = 0.35
"""Metres of r up to which a thing is gone around; what is larger (a table, a wall) has no sides to pass."""
OTHER_GOAL: Final = 0.10
"""Metres about the other arm's goal that are left to it: its r (two-arm thesis, 4.3)."""


@dataclass(frozen=True)
class Post:
    """An upright thing: its centre in the base (m), r, and half of its height."""

    centre: Vector3
    radius: float
    half: float


@dataclass(frozen=True)
class Block:
    """A box that is too large to go around: its centre frame in the base and its full edges (m)."""

    pose: Pose
    size: Vector3


class Around:
    """Distances from points to all of it.

    Args:
        posts: what can be gone around.
        blocks: what can't.
    """

    def __init__(self, posts: Sequence[Post], blocks: Sequence[Block]) -> None:
        self.posts = tuple(posts)
        self._centres = np.array([each.centre for each in posts]).reshape(-1, 3)
        self._radii = np.array([each.radius for each in posts])
        self._halves = np.array([each.half for each in posts])
        placed = [to_se3(each.pose) for each in blocks]
        self._origins = np.array([each.translation for each in placed]).reshape(-1, 3)
        self._turns = np.array([each.rotation for each in placed]).reshape(-1, 3, 3)
        self._sizes = np.array([each.size for each in blocks]).reshape(-1, 3) / 2.0

    def post_gaps(self, points: Array) -> Array:
        """Return the metres (m, posts) between points (m, 3) and each post's surface, 0 inside."""
        away = points[:, None, :] - self._centres
        plan = np.maximum(np.hypot(away[..., 0], away[..., 1]) - self._radii, 0.0)
        up = np.maximum(np.abs(away[..., 2]) - self._halves, 0.0)
        return np.asarray(np.hypot(plan, up))

    def gaps(self, points: Array) -> Array:
        """Return the metres (m,) between points (m, 3) and the nearest thing, 0 inside; infinite for none."""
        nearest = np.full(len(points), np.inf)
        if len(self._radii):
            nearest = np.minimum(nearest, self.post_gaps(points).min(axis=1))
        if len(self._sizes):
            local = np.einsum("kji,mkj->mki", self._turns, points[:, None, :] - self._origins)
            outside = np.maximum(np.abs(local) - self._sizes, 0.0)
            nearest = np.minimum(nearest, np.sqrt((outside * outside).sum(axis=2)).min(axis=1))
        return nearest


def split(boxes: Sequence[tuple[Pose, Vector3]], other_goal: Vector3 | None) -> Around:
    """Return what stands around: boxes in the base, and the other arm's goal as one more post."""
    posts: list[Post] = []
    blocks: list[Block] = []
    for pose, size in boxes:
        radius = math.hypot(size[0], size[1]) / 2.0
        if radius <= POST_AT_MOST:
            posts.append(Post(pose.position, radius, size[2] / 2.0))
        else:
            blocks.append(Block(pose, size))
    if other_goal is not None:
        posts.append(Post(other_goal, OTHER_GOAL, OTHER_GOAL))
    return Around(posts, blocks)
