"""Of a way's corners, leave out those that cost more time than they are worth.

The search counts metres, and those near things more. A base with two wheels also pays for turning: a corner
close to where it stands, or a short one before the next, has it swing one way and back. What is left out
brings the way no closer to anything than the pieces that it replaces were.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.path import Path
from tandem.skills.base.path_follower import corner_speed, tight_speeds
from tandem.skills.base.planner import SLACK, Clearances
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive

STEP: Final = 0.05
"""Metres between two places whose speeds are reckoned: half of the search's grid."""
SLOWEST: Final = 0.05
"""m/s: the follower is no slower before a corner."""


def without_slow_corners(path: Path, goal: FloorPose, drive: Drive, clearances: Clearances) -> Iterator[Path]:
    """Yield the path after each trial, quicker or as it was; the last is the answer.

    Args:
        path: as planned.
        goal: where it ends, with the heading wished there.
        drive: limits.
        clearances: what the plan keeps to, and where the base stands.
    """
    best, points = seconds(path, goal.yaw, drive, clearances), path.points
    at = 1
    while at < len(points) - 1:
        shorter = Path(np.delete(points, at, axis=0))
        if _as_clear(points, at, clearances):
            taken = seconds(shorter, goal.yaw, drive, clearances)
            if taken < best:
                best, path, points, at = taken, shorter, shorter.points, 0  # others may go now
        at += 1
        yield path


def seconds(path: Path, yaw: float, drive: Drive, clearances: Clearances) -> float:
    """Return about how long the base takes for the path, with the turns to it and, at its end, to ``yaw``.

    Speeds are the follower's: for corners and in tight places, and between them as the drive accelerates.
    """
    ways, places = path.sampled(0.0, path.length, STEP)
    most = tight_speeds(clearances.field.at(places) - clearances.needed, drive)
    turns = (
        abs(wrap(path.heading_at(0.0) - clearances.start.yaw)),
        abs(wrap(yaw - path.heading_at(path.length))),
    )
    for way, angle in path.corners:
        place = int(np.argmin(np.abs(ways - way)))
        most[place] = min(most[place], max(corner_speed(angle), SLOWEST))
    squares = (most**2).tolist()
    squares[0] = squares[-1] = 0.0
    gain = 2.0 * drive.acceleration * float(ways[1] - ways[0])
    for k in range(1, len(squares)):
        squares[k] = min(squares[k], squares[k - 1] + gain)
    for k in range(len(squares) - 2, -1, -1):
        squares[k] = min(squares[k], squares[k + 1] + gain)
    speeds = np.sqrt(squares)
    driving = 2.0 * np.diff(ways) / np.maximum(speeds[1:] + speeds[:-1], SLOWEST)
    return float(driving.sum()) + sum(_turn(angle, drive) for angle in turns)


def _turn(angle: float, drive: Drive) -> float:
    """Return the seconds of a turn (rad) from rest to rest."""
    if angle < drive.turn**2 / drive.turn_acceleration:
        return 2.0 * float(np.sqrt(angle / drive.turn_acceleration))
    return angle / drive.turn + drive.turn / drive.turn_acceleration


def _as_clear(points: FloatArray, at: int, clearances: Clearances) -> bool:
    """Say whether the line past a corner is free, and clears what the two pieces there clear."""
    before, corner, after = ((float(x), float(y)) for x, y in points[at - 1 : at + 2])
    spare = clearances.spare_between(before, after)
    kept = min(clearances.spare_between(before, corner), clearances.spare_between(corner, after))
    return spare >= max(kept, -SLACK / 2)
