"""The base's controller: from velocity commands to wheel speeds, and from wheel encoders to odometry."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import fmean
from typing import TYPE_CHECKING

from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from tandem.sim.model import Wheels
    from tandem.sim.scenario import Noise
    from tandem.skills.ports.hardware import BaseVelocity
    from tandem.skills.ports.robot_description import Drive

WHEEL_GAIN = 8.0
"""1/s: how fast a wheel makes up for a lag behind its reference; keeps the base from creeping, too."""
MAX_LAG = 0.3
"""rad that a wheel's reference may run ahead: a blocked base does not wind up."""


class BaseController:
    """Obeys velocity commands within the drive's limits; without a fresh one it brakes and stands.

    Args:
        drive: limits.
        wheels: geometry.
        angles: where the wheels are, rad, in the order of ``wheels.joints``.
    """

    def __init__(self, drive: Drive, wheels: Wheels, angles: Sequence[float]) -> None:
        self._drive = drive
        self._wheels = wheels
        self._reference = list(angles)
        self._wish = (0.0, 0.0)
        self._age = math.inf
        self.linear = 0.0
        self.angular = 0.0

    @property
    def stands(self) -> bool:
        """Whether the base is told to stand, and its reference does."""
        told = self._age <= self._drive.dead_man + 1e-9 and self._wish != (0.0, 0.0)
        return not told and self.linear == 0.0 and self.angular == 0.0

    def command(self, velocity: BaseVelocity) -> None:
        """Take a command: m/s ahead and rad/s to the left, cut to the drive's limits."""
        linear = min(max(velocity.linear, -self._drive.backward), self._drive.forward)
        angular = min(max(velocity.angular, -self._drive.turn), self._drive.turn)
        self._wish = (linear, angular)
        self._age = 0.0

    def stop(self) -> None:
        """Forget the command: brake and stand."""
        self._age = math.inf

    def advance(self, period: float, angles: Sequence[float]) -> tuple[float, ...]:
        """Return the wheels' speeds (rad/s) for the next period, in the order of ``wheels.joints``."""
        linear, angular = self._wish if self._age <= self._drive.dead_man + 1e-9 else (0.0, 0.0)
        self._age += period
        # Told to stand at once, it uses its brakes; who slows down step by step is not told so.
        most = self._drive.hardest if linear == 0.0 else self._drive.acceleration
        self.linear = _towards(self.linear, linear, most * period)
        self.angular = _towards(self.angular, angular, self._drive.turn_acceleration * period)
        sideways = self.angular * self._wheels.track / 2.0
        left, right = (way / self._wheels.radius for way in (self.linear - sideways, self.linear + sideways))
        speeds = [left] * len(self._wheels.left) + [right] * len(self._wheels.right)
        return tuple(self._wheel(i, speed, period, angles[i]) for i, speed in enumerate(speeds))

    def _wheel(self, index: int, speed: float, period: float, angle: float) -> float:
        lag = min(max(self._reference[index] - angle, -MAX_LAG), MAX_LAG)
        self._reference[index] = angle + lag + speed * period
        return speed + WHEEL_GAIN * lag


def _towards(value: float, target: float, step: float) -> float:
    return min(max(target, value - step), value + step)


@dataclass
class _Encoders:
    left: float
    right: float


class Odometer:
    """Dead reckoning from wheel encoders, with the errors of wheels that are not what they are taken for.

    The way is wrong by ``odometry_scale``, each turn by ``odometry_turn_scale``, and the heading walks by
    ``odometry_drift`` rad per square root of a metre that the wheels roll.

    Args:
        wheels: geometry.
        angles: where the wheels are, rad, in the order of ``wheels.joints``.
        noise: how large the errors are.
        rng: their source.
    """

    def __init__(
        self, wheels: Wheels, angles: Sequence[float], noise: Noise, rng: np.random.Generator
    ) -> None:
        self._wheels = wheels
        self._noise = noise
        self._rng = rng
        self._last = self._sides(angles)
        self.pose = FloorPose(x=0.0, y=0.0, yaw=0.0)
        self.linear = 0.0
        self.angular = 0.0

    def update(self, period: float, angles: Sequence[float]) -> None:
        """Take the wheels' angles (rad) of a period later: moves ``pose``, sets ``linear`` and ``angular``.

        Integrates at the midpoint heading (second order Runge-Kutta).
        """
        now = self._sides(angles)
        left = (now.left - self._last.left) * self._wheels.radius
        right = (now.right - self._last.right) * self._wheels.radius
        self._last = now
        rolled = (abs(left) + abs(right)) / 2.0
        way = (left + right) / 2.0 * (1.0 + self._noise.odometry_scale)
        turn = (right - left) / self._wheels.track * (1.0 + self._noise.odometry_turn_scale)
        turn += float(self._rng.normal(0.0, 1.0)) * self._noise.odometry_drift * math.sqrt(rolled)
        middle = self.pose.yaw + turn / 2.0
        self.pose = FloorPose(
            x=self.pose.x + way * math.cos(middle),
            y=self.pose.y + way * math.sin(middle),
            yaw=wrap(self.pose.yaw + turn),
        )
        self.linear = way / period
        self.angular = turn / period

    def _sides(self, angles: Sequence[float]) -> _Encoders:
        """Return the mean angle of each side's wheels."""
        first = len(self._wheels.left)
        return _Encoders(fmean(angles[:first]), fmean(angles[first:]))

    def jump(self, dx: float, dy: float, dyaw: float) -> None:
        """Step aside without having moved: metres ahead and to the left, rad to the left."""
        c, s = math.cos(self.pose.yaw), math.sin(self.pose.yaw)
        self.pose = FloorPose(
            x=self.pose.x + c * dx - s * dy,
            y=self.pose.y + s * dx + c * dy,
            yaw=wrap(self.pose.yaw + dyaw),
        )
