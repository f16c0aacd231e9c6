"""A timed motion, read as the hardware reads it: cubic splines between points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.hardware import TrajectoryPoint


@dataclass(frozen=True)
class MotionLimits:
    """Of some joints: rad/s, rad/s2, rad/s3 (m for prismatic ones), each an array (n,)."""

    velocity: Array
    acceleration: Array
    jerk: Array

    def scaled(self, share: float) -> MotionLimits:
        """Return this share of the limits."""
        return MotionLimits(self.velocity * share, self.acceleration * share, self.jerk * share)


@dataclass(frozen=True)
class Trajectory:
    """Points of a motion: ``times`` (k,) in seconds from 0, ``positions`` and ``velocities`` (k, n)."""

    times: Array
    positions: Array
    velocities: Array

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self.times[-1])

    def sample(self, times: Array) -> Array:
        """Return the positions (m, n) at the times (m,): cubic Hermite splines between the points."""
        at = np.clip(times, 0.0, self.duration)
        if len(self.times) == 1:
            return np.repeat(self.positions, len(at), axis=0)
        k = np.clip(np.searchsorted(self.times, at, side="right") - 1, 0, len(self.times) - 2)
        span = (self.times[k + 1] - self.times[k])[:, None]
        u = (at - self.times[k])[:, None] / span
        a, b, va, vb = (
            self.positions[k],
            self.positions[k + 1],
            self.velocities[k] * span,
            self.velocities[k + 1] * span,
        )
        return (
            (2 * u**3 - 3 * u**2 + 1) * a + (u**3 - 2 * u**2 + u) * va
            + (3 * u**2 - 2 * u**3) * b + (u**3 - u**2) * vb
        )  # fmt: skip

    def points(self) -> tuple[TrajectoryPoint, ...]:
        """Return the points as the hardware's goal holds them."""
        return tuple(
            TrajectoryPoint(time=float(t), positions=tuple(map(float, q)), velocities=tuple(map(float, v)))
            for t, q, v in zip(self.times, self.positions, self.velocities, strict=True)
        )
