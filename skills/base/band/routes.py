"""Bands to begin with, and old ones carried on to now."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.skills.base.band.limits import Begin, Task
from tandem.skills.base.band.timed import Bands
from tandem.skills.base.floor import FloatArray
from tandem.skills.geometry.poses import wrap

PIECES: Final = 14
"""Intervals of a band: poses 0.15 m apart, or less. A plan's processor time grows with the square of them."""
CRUISE: Final = 0.8
"""Share of the drive's speed that a band begins with."""
LATER: Final = 2.2
"""Times as slow the band begins that is to let people pass."""
BESIDE: Final = 0.15
"""Metres more than needed by which a band begins to pass beside somebody."""
SPREAD: Final = 0.55
"""Metres along the way over which it swings out."""


def along(points: FloatArray, task: Task, *, slower: float = 1.0) -> Bands:
    """Return a band along the points, shape (m, 2), from the base's pose on."""
    ways = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))))
    even = np.linspace(0.0, ways[-1], PIECES + 1)
    x, y = np.interp(even, ways, points[:, 0]), np.interp(even, ways, points[:, 1])
    headings = np.arctan2(np.gradient(y), np.gradient(x))
    start = task.begin.pose
    headings = np.unwrap(np.concatenate(([start.yaw], headings[1:])))
    poses = np.stack((x, y, headings), axis=1)
    poses[0] = start.x, start.y, start.yaw
    drive = task.drive
    rolls = np.hypot(*np.diff(poses[:, :2], axis=0).T) / (CRUISE * drive.forward)
    turns = np.abs(np.diff(headings)) / (CRUISE * drive.turn)
    times = slower * np.clip(np.maximum(rolls, turns), 0.05, 0.9 / slower)
    return Bands(poses[None], times[None])


def beside(points: FloatArray, first: Bands, task: Task, side: int) -> Bands:
    """Return a band that passes to the left (1) or right (-1) of whom the first band comes nearest to."""
    at, moments = first.poses[..., :2], first.moments
    gaps = task.around.gaps(at, moments)
    person, _, pose = np.unravel_index(int(np.argmin(gaps.spare)), gaps.spare.shape)
    spot = at[0, pose]
    whom = spot - gaps.away[person, 0, pose] * (gaps.spare[person, 0, pose] + task.around.apart)
    heading = float(first.poses[0, max(int(pose), 1), 2])
    left = np.array([-math.sin(heading), math.cos(heading)])
    out = side * (task.around.apart + BESIDE) + float((whom - spot) @ left)
    if side * out <= 0.0:
        out = 0.0
    ways = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))))
    even = np.linspace(0.0, ways[-1], 4 * PIECES)
    way = np.stack((np.interp(even, ways, points[:, 0]), np.interp(even, ways, points[:, 1])), axis=1)
    nearest = even[int(np.argmin(np.hypot(*(way - spot).T)))]
    swing = np.exp(-(((even - nearest) / SPREAD) ** 2) / 2.0)
    # Both ends stay where they are.
    swing *= np.minimum(1.0, np.minimum(even, even[-1] - even) / 0.4)
    return along(way + out * swing[:, None] * left, task)


def carried(old: Bands, passed: float, begin: Begin, more: FloatArray, forward: float) -> Bands | None:
    """Return an old band as it is from now on; None when it has ended.

    Args:
        old: one band.
        passed: seconds since it was made.
        begin: where the base is.
        more: points, shape (m, 2), from the old band's end to the new one's; may be none.
        forward: m/s of the drive.
    """
    moments, poses = old.moments[0], old.poses[0]
    if passed > moments[-1] - 0.3 or not np.isfinite(poses).all():
        return None
    if len(more):
        steps = np.diff(np.concatenate((poses[-1:, :2], more)), axis=0)
        far = np.hypot(*steps.T)
        headings = poses[-1, 2] + np.array(
            [wrap(h - poses[-1, 2]) for h in np.arctan2(steps[:, 1], steps[:, 0])]
        )
        moments = np.concatenate((moments, moments[-1] + np.cumsum(np.maximum(far, 1e-3) / forward)))
        poses = np.concatenate((poses, np.column_stack((more, headings))))
    even = np.linspace(passed, moments[-1], PIECES + 1)
    made = np.stack([np.interp(even, moments, poses[:, axis]) for axis in range(3)], axis=1)
    made[:, 2] += begin.pose.yaw + wrap(made[0, 2] - begin.pose.yaw) - made[0, 2]
    made[0] = begin.pose.x, begin.pose.y, begin.pose.yaw
    return Bands(made[None], np.diff(even)[None])
