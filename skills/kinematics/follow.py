"""Have a hand follow a moving pose: joint positions a little further each period."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from skills.kinematics.model import Chain, Limits, RobotKinematics
from skills.kinematics.transforms import Array, to_se3
from skills.ports.geometry import Pose

DAMPING: Final = 1e-4
"""Of the least squares: (metre, radian)^2. Holds joints back near a singularity only."""
ROUNDS: Final = 2
"""Newton steps a call: poses that come every 10 ms are nearly there after one."""


@dataclass(frozen=True)
class Followed:
    """Joint positions (n,), and by how much the frame is off the pose there (m, rad)."""

    q: Array
    metres: float
    radians: float


class PoseFollower:
    """Differential inverse kinematics of one frame: damped least squares from the joints as last told.

    Args:
        robot: the kinematics.
        joints: those that move the frame.
        positions: where all others stand.
        frame: what follows.
        limits: of the joints; they are never left.
    """

    def __init__(
        self,
        robot: RobotKinematics,
        joints: Sequence[str],
        positions: Mapping[str, float],
        *,
        frame: str,
        limits: Limits,
    ) -> None:
        self._chain, self._frame, self._limits = Chain(robot, joints, positions), frame, limits

    def pose(self, q: Array) -> Pose:
        """Return the frame in the base at q (n,)."""
        return self._chain.pose(q, self._frame)

    def follow(self, q: Array, pose_in_base: Pose) -> Followed:
        """Return joint positions near q (n,) at which the frame is at the pose, or as near as it gets."""
        target = to_se3(pose_in_base)
        for _ in range(ROUNDS):
            twist, jacobian = self._chain.twist_to(q, self._frame, target)
            q = q + self._step(q, twist, jacobian)
        twist, _ = self._chain.twist_to(q, self._frame, target)
        return Followed(q, float(np.linalg.norm(twist[:3])), float(np.linalg.norm(twist[3:])))

    def _step(self, q: Array, twist: Array, jacobian: Array) -> Array:
        """Return one step (n,): a joint that would leave its limits stays, the others make up for it."""
        low, high = self._limits.lower - q, self._limits.upper - q
        step, free = np.zeros(len(q)), np.ones(len(q), dtype=bool)
        while free.any():
            left = twist - jacobian[:, ~free] @ step[~free]
            part = jacobian[:, free]
            normal = part @ part.T + DAMPING * np.eye(6)
            step[free] = part.T @ np.linalg.solve(normal, left)
            beyond = free & ((step < low) | (step > high))
            if not beyond.any():
                break
            step[beyond] = np.clip(step[beyond], low[beyond], high[beyond])
            free &= ~beyond
        return step
