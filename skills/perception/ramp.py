"""Short motions from rest to rest within limits of speed, acceleration and jerk.

One profile for all joints, of constant jerk in up to seven pieces (Biagiotti and Melchiorri, "Trajectory
Planning for Automatic Machines and Robots", 2008, section 3.4): a joint's path is then a cubic between two
points of the trajectory, which is just what the hardware's splines are.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from tandem.skills.ports.hardware import TrajectoryPoint
from tandem.skills.ports.robot_description import JointLimit


def rest_to_rest(
    start: Sequence[float], end: Sequence[float], limits: Sequence[JointLimit]
) -> tuple[TrajectoryPoint, ...]:
    """Return the points of the quickest motion in a straight line of joint space.

    The joints move in proportion; the slowest sets the time. Equal ends give a single point.
    """
    ways = [b - a for a, b in zip(start, end, strict=True)]
    moving = [(abs(way), limit) for way, limit in zip(ways, limits, strict=True) if abs(way) > 1e-9]  # noqa: PLR2004
    if not moving:
        return (TrajectoryPoint(time=0.0, positions=tuple(start), velocities=(0.0,) * len(ways)),)
    speed = min(limit.velocity / way for way, limit in moving)
    acceleration = min(limit.acceleration / way for way, limit in moving)
    jerk = min(limit.jerk / way for way, limit in moving)
    return tuple(
        TrajectoryPoint(
            time=time,
            positions=tuple(a + way * share for a, way in zip(start, ways, strict=True)),
            velocities=tuple(way * rate for way in ways),
        )
        for time, share, rate in _profile(speed, acceleration, jerk)
    )


def _profile(speed: float, acceleration: float, jerk: float) -> list[tuple[float, float, float]]:
    """Return time, share of the way (0 to 1) and its rate at each change of jerk."""
    rise, climb = _phases(speed, acceleration, jerk)
    top = jerk * rise * (rise + climb)
    cruise = max(1.0 / top - (2.0 * rise + climb), 0.0)
    pieces = (
        (rise, jerk),
        (climb, 0.0),
        (rise, -jerk),
        (cruise, 0.0),
        (rise, -jerk),
        (climb, 0.0),
        (rise, jerk),
    )
    time = share = rate = pull = 0.0
    points = [(time, share, rate)]
    for duration, change in pieces:
        if duration <= 1e-9:  # noqa: PLR2004
            continue
        share += rate * duration + pull * duration**2 / 2 + change * duration**3 / 6
        rate += pull * duration + change * duration**2 / 2
        pull += change * duration
        time += duration
        points.append((time, share, rate))
    points[-1] = (time, 1.0, 0.0)
    return points


def _phases(speed: float, acceleration: float, jerk: float) -> tuple[float, float]:
    """Return the seconds of rising acceleration and of constant acceleration, for a way of length 1."""
    rise = min(acceleration / jerk, math.sqrt(speed / jerk))
    climb = max(speed / (jerk * rise) - rise, 0.0)
    if jerk * rise * (rise + climb) * (2.0 * rise + climb) <= 1.0:
        return rise, climb
    # The top speed is not reached: rise (rise + climb) (2 rise + climb) jerk = 1.
    rise = min(acceleration / jerk, (1.0 / (2.0 * jerk)) ** (1.0 / 3.0))
    climb = -1.5 * rise + math.sqrt(0.25 * rise**2 + 1.0 / (jerk * rise))
    return rise, max(climb, 0.0)
