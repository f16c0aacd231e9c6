"""The end of a way to a pose: the base turns to its heading while it still brakes.

A base that turns while it rolls gets aside, to where it turns. So the last straight piece ends as far on the
other side of the pose, and the turn begins where it will carry the base over to it.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.skills.base.path import Path
from tandem.skills.base.planner import SLACK, Clearances
from tandem.skills.base.wheels import CYCLE, stopping_speed
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive

LATENCY: Final = 0.05
"""Seconds between a command and what the base does about it."""
TURNED: Final = 0.75
"""Radians that the base turns before it has come to rest. TIAGo takes 1.2 s for them and gets 56 mm aside; a
cycle's delay costs 4 mm of the 30 that a goal may be missed by. At 0.5 these are 1.0 s, 26 and 2 mm; at 1.2
it would turn across its line before it is there."""
STEPS: Final = 150
"""Cycles that are looked ahead: 3 s, in which every base that brakes has come to rest."""
STRAIGHT: Final = 0.8
"""Metres that the last piece should have, to be on its line by then. Shorter ways may be backed up, too."""
LITTLE: Final = 0.3
"""Radians of a turn that is over so soon that nothing is gained."""
ARRIVED: Final = 0.004
"""Metres before the end at which the way counts as driven."""
ACROSS: Final = 1.3
"""Radians off its line from which on the base gets no nearer to its end."""


def laid_aside(path: Path, goal: FloorPose, drive: Drive, clearances: Clearances) -> Path:
    """Return the path with its end beside the goal, so that the turn there carries the base to it.

    The path itself where the last piece is short, little is to be turned, or there is no room beside it.
    """
    start, end = path.points[-2], path.points[-1]
    length = float(np.hypot(*(end - start)))
    heading = path.heading_at(path.length)
    angle = wrap(goal.yaw - heading)
    if length < STRAIGHT or abs(angle) < LITTLE:
        return path
    turned = min(TURNED, 2.0 * abs(angle))  # all of a smaller turn: up to its middle it gets quicker
    left = drive.acceleration * turned / drive.turn_acceleration
    aside = swerve(left, stopping_speed(left, drive.acceleration, LATENCY), angle, drive)
    way = math.copysign(aside, angle)
    beside = end + way * np.array([math.sin(heading), -math.cos(heading)])
    if math.isinf(aside) or clearances.spare_between(tuple(start), tuple(beside)) < -SLACK / 2.0:
        return path
    return Path(np.vstack((path.points[:-1], beside)))


def swerve(
    remaining: float, speed: float, angle: float, drive: Drive, *, off: float = 0.0, rate: float = 0.0
) -> float:
    """Return how far (m) a base that begins to turn now is carried aside until its way ends.

    Args:
        remaining: metres of the way; it is braked for their end.
        speed: m/s now.
        angle: radians to turn; the result is positive to that side.
        drive: limits.
        off: radians by which the base is turned to that side already.
        rate: rad/s at which it turns there; negative away from it.

    Returns:
        Infinity for a base that would turn across before it is there.
    """
    aside, turned, rest = 0.0, off, abs(angle)
    for _ in range(STEPS):
        if remaining <= ARRIVED:
            return aside
        if turned > ACROSS:
            break
        speed = min(speed, stopping_speed(remaining, drive.acceleration, LATENCY))
        most = min(stopping_speed(rest, drive.turn_acceleration, LATENCY), drive.turn)
        rate = min(rate + drive.turn_acceleration * CYCLE, most)
        turned, rest = turned + rate * CYCLE, rest - rate * CYCLE
        remaining -= speed * math.cos(turned) * CYCLE
        aside += speed * math.sin(turned) * CYCLE
    return math.inf
