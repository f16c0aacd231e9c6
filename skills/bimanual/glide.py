"""A straight way from rest to rest in bounded time: speed, acceleration and jerk have bounds that are kept.

Minimum-jerk: s(t) = 10 u^3 - 15 u^4 + 6 u^5 with u = t / T (Flash and Hogan 1985). Its greatest
derivatives are 15/8, 10/sqrt(3) and 60 over T, T^2 and T^3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from tandem.skills.geometry.poses import add, angle_between, conjugate, length, multiply, scale, subtract
from tandem.skills.ports.pose import Pose


@dataclass(frozen=True)
class Bounds:
    """m/s, m/s2 and m/s3; a radian counts as ``radian`` metres."""

    speed: float = 0.12
    acceleration: float = 0.4
    jerk: float = 3.0
    radian: float = 0.3


@dataclass(frozen=True)
class Glide:
    """From one pose straight to another one."""

    start: Pose
    end: Pose
    duration: float

    def at(self, seconds: float) -> Pose:
        """Return the pose after so many seconds; beyond the end, the end."""
        if seconds >= self.duration:
            return self.end
        s = share(max(0.0, seconds) / self.duration)
        way = subtract(self.end.position, self.start.position)
        return Pose(
            position=add(self.start.position, scale(way, s)), orientation=_turned(self.start, self.end, s)
        )


def share(u: float) -> float:
    """Return the share of the way after a share ``u`` of the time."""
    return u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)


def seconds_for(metres: float, bounds: Bounds) -> float:
    """Return the least duration in which the bounds are kept."""
    return max(
        15.0 / 8.0 * metres / bounds.speed,
        math.sqrt(10.0 / math.sqrt(3.0) * metres / bounds.acceleration),
        math.cbrt(60.0 * metres / bounds.jerk),
    )


def glide(start: Pose, end: Pose, bounds: Bounds) -> Glide:
    """Return the motion from pose to pose."""
    metres = length(subtract(end.position, start.position))
    radians = angle_between(start.orientation, end.orientation)
    return Glide(start, end, max(1e-6, seconds_for(max(metres, bounds.radian * radians), bounds)))


def _turned(a: Pose, b: Pose, part: float) -> tuple[float, float, float, float]:
    """Return the attitude on the shortest turn from a to b (slerp)."""
    x, y, z, w = multiply(conjugate(a.orientation), b.orientation)
    sign = -1.0 if w < 0.0 else 1.0
    size = math.sqrt(x * x + y * y + z * z)
    if size < 1e-9:  # noqa: PLR2004 - no turn to speak of
        return a.orientation
    half = part * math.atan2(size, sign * w)
    factor = sign * math.sin(half) / size
    return multiply(a.orientation, (x * factor, y * factor, z * factor, math.cos(half)))
