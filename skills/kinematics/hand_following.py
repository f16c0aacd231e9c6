"""Have a hand follow a moving pose: joint positions a little further each period."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.kinematics.model import Chain, Limits, RobotKinematics
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.pose import Pose

DAMPING: Final = 1e-4
"""Of the least squares: (metre, radian)^2. Holds joints back near a singularity only."""
_DAMPED: Final = DAMPING * np.eye(6)
ROUNDS: Final = 2
"""Newton steps a call: poses that come every 10 ms are nearly there after one."""
_NEAREST: Final = 0.999
"""Share of the way from the middle of a joint's range to its limit beyond which its cost grows no more."""


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
        """Return one step (n,): joints that come near a limit are spared before they are there.

        Without that, a joint is stopped at its limit all at once, and the others take over with a jerk that
        an arm does not follow.
        """
        even = self._solved(q, twist, jacobian, np.ones(len(q)))
        return self._solved(q, twist, jacobian, self._costs(q, even))

    def _costs(self, q: Array, step: Array) -> Array:
        """Return what a step of each joint (n,) costs: more the nearer it comes to a limit.

        Chan and Dubey 1995, "A weighted least-norm solution based scheme for avoiding joint limits".
        """
        half = 0.5 * (self._limits.upper - self._limits.lower)
        off = np.clip((q - self._limits.lower) / half - 1.0, -_NEAREST, _NEAREST)
        slope = 2.0 * off / (half * (1.0 - off**2) ** 2)
        return np.where(step * slope > 0.0, 1.0 + np.abs(slope), 1.0)

    def _solved(self, q: Array, twist: Array, jacobian: Array, costs: Array) -> Array:
        """Return the cheapest step (n,): one that would leave its limits stays, the others make up for it."""
        low, high = self._limits.lower - q, self._limits.upper - q
        step, free = _least(jacobian, costs, twist), np.ones(len(q), dtype=bool)
        while (beyond := free & ((step < low) | (step > high))).any():
            step[beyond] = np.clip(step[beyond], low[beyond], high[beyond])
            free &= ~beyond
            if not free.any():
                break
            left = twist - jacobian[:, ~free] @ step[~free]
            step[free] = _least(jacobian[:, free], costs[free], left)
        return step


def _least(jacobian: Array, costs: Array, twist: Array) -> Array:
    """Return the cheapest step (n,) that makes a twist (6,), or nearly so near a singular place."""
    ease = jacobian / costs
    found: Array = ease.T @ np.linalg.solve(ease @ jacobian.T + _DAMPED, twist)
    return found
