"""What is minimised, and its derivatives.

A sum of squares, as in Rösmann et al. 2012 (section 3), with Rösmann et al. 2017 for moving obstacles: each
second costs, and so does each excess over a limit, by a weight that makes excesses small. Limits are aimed at
with a little to spare, so that what is left of an excess is within them.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.skills.base.band.limits import Task
from tandem.skills.base.band.timed import Bands, Motion, motion
from tandem.skills.base.floor import FloatArray

SPARE: Final = 0.95
"""Share of the limits of the drive that is aimed at."""
TIME: Final = 0.5
"""For each second. The other weights are for a metre, m/s, m/s2 (or radians instead of metres)."""
ASIDE: Final = 22.0
SPEED: Final = 6.0
PUSH: Final = 2.5
THINGS: Final = 25.0
PEOPLE: Final = 6.0
"""Weights of excesses: of motion to the side (m), of speed and acceleration beyond the limits, and of
clearance that is lacking to things and to people (m). A larger one leaves less of an excess, and more of the
others: room for people gives way before room for things."""
HEADING: Final = 0.15
"""For each radian off the wished heading at the end."""
CALM: Final = 0.2
"""For each rad/s: of two ways as quick the one with fewer turns."""
ROOMY: Final = 0.04
"""Metres beyond the clearance needed that are aimed at."""

Terms = tuple[FloatArray, FloatArray]
"""Values, shape (k, r), and derivatives, shape (k, r, 4 (n + 1)): by x, y, heading and time of each pose.

The time of a pose is that of the interval after it; the last one has none.
"""


def terms(bands: Bands, task: Task) -> Terms:
    """Return all terms of all bands."""
    parts = [*_moving(bands, task), _things(bands, task), *_people(bands, task)]
    return np.concatenate([each[0] for each in parts], axis=1), np.concatenate(
        [each[1] for each in parts], axis=1
    )


def _moving(bands: Bands, task: Task) -> list[Terms]:
    how, drive = motion(bands), task.drive
    k, n = bands.times.shape
    linear, angular = _of_linear(bands, how), _of_angular(bands, how)
    time = np.zeros((k, n, 4, n + 1))
    piece = np.arange(n)
    time[:, piece, 3, piece] = TIME
    end = np.zeros((k, 1, 4, n + 1))
    end[:, 0, 2, n] = HEADING
    off = HEADING * _wrapped(bands.poses[:, -1:, 2] - task.end[2])
    half = np.concatenate(
        (bands.times[:, :1] / 2, (bands.times[:, 1:] + bands.times[:, :-1]) / 2, bands.times[:, -1:] / 2),
        axis=1,
    )
    return [
        (TIME * bands.times, _flat(time)),
        (off, _flat(end)),
        (ASIDE * how.aside, ASIDE * _flat(_of_aside(bands, how))),
        _above(how.linear, _flat(linear), SPARE * drive.forward, SPEED),
        _above(-how.linear, -_flat(linear), 0.0, SPEED),
        _within(how.angular, _flat(angular), SPARE * drive.turn, SPEED),
        (CALM * how.angular, CALM * _flat(angular)),
        _within(
            *_change(how.linear, linear, half, task.begin.linear, stops=task.stops),
            SPARE * drive.acceleration,
            PUSH,
        ),
        _within(
            *_change(how.angular, angular, half, task.begin.angular, stops=task.stops),
            SPARE * drive.turn_acceleration,
            PUSH / 2,
        ),
    ]


def _of_linear(bands: Bands, how: Motion) -> FloatArray:
    k, n = bands.times.shape
    made, piece, times = np.zeros((k, n, 4, n + 1)), np.arange(n), bands.times
    made[:, piece, 0, piece], made[:, piece, 0, piece + 1] = -how.cos / times, how.cos / times
    made[:, piece, 1, piece], made[:, piece, 1, piece + 1] = -how.sin / times, how.sin / times
    made[:, piece, 2, piece] = made[:, piece, 2, piece + 1] = how.aside / 2 / times
    made[:, piece, 3, piece] = -how.linear / times
    return made


def _of_aside(bands: Bands, how: Motion) -> FloatArray:
    k, n = bands.times.shape
    made, piece = np.zeros((k, n, 4, n + 1)), np.arange(n)
    made[:, piece, 0, piece], made[:, piece, 0, piece + 1] = how.sin, -how.sin
    made[:, piece, 1, piece], made[:, piece, 1, piece + 1] = -how.cos, how.cos
    made[:, piece, 2, piece] = made[:, piece, 2, piece + 1] = -how.along / 2
    return made


def _of_angular(bands: Bands, how: Motion) -> FloatArray:
    k, n = bands.times.shape
    made, piece, times = np.zeros((k, n, 4, n + 1)), np.arange(n), bands.times
    made[:, piece, 2, piece], made[:, piece, 2, piece + 1] = -1.0 / times, 1.0 / times
    made[:, piece, 3, piece] = -how.angular / times
    return made


def _change(speeds: FloatArray, slopes: FloatArray, half: FloatArray, begin: float, *, stops: bool) -> Terms:
    """Return accelerations between intervals, from the present speed and, if it stops, to standstill."""
    k, n = speeds.shape
    rows = n + 1 if stops else n
    ends = np.concatenate((np.full((k, 1), begin), speeds, np.zeros((k, 1))), axis=1)
    none = np.zeros((k, 1, 4, n + 1))
    slope = np.diff(np.concatenate((none, slopes, none), axis=1), axis=1) / half[..., None, None]
    change = np.diff(ends, axis=1) / half
    piece = np.arange(n)
    slope[:, piece, 3, piece] -= (change / half)[:, :n] / 2
    slope[:, piece + 1, 3, piece] -= (change / half)[:, 1:] / 2
    return change[:, :rows], _flat(slope[:, :rows])


def _things(bands: Bands, task: Task) -> Terms:
    k, n = bands.times.shape
    points = bands.poses[:, 1:, :2].reshape(-1, 2)
    clearances = task.around.clearances
    far, away = clearances.field.with_gradient(points)
    lacks = (clearances.required(points) + ROOMY - far).reshape(k, n)
    slope, pose = np.zeros((k, n, 4, n + 1)), np.arange(n)
    slope[:, pose, :2, pose + 1] = -away.reshape(k, n, 2).transpose(1, 0, 2)
    return _above(lacks, _flat(slope), 0.0, THINGS)


def _people(bands: Bands, task: Task) -> list[Terms]:
    k, n = bands.times.shape
    gaps = task.around.gaps(bands.poses[:, 1:, :2], bands.moments[:, 1:])
    pose, made = np.arange(n), []
    before = np.tri(n, n)
    for spare, away, later in zip(gaps.spare, gaps.away, gaps.later, strict=True):
        slope = np.zeros((k, n, 4, n + 1))
        slope[:, pose, :2, pose + 1] = -away.transpose(1, 0, 2)
        slope[:, :, 3, :n] = -later[:, :, None] * before
        made.append(_above(-spare, _flat(slope), 0.0, PEOPLE))
    return made


def _above(value: FloatArray, slope: FloatArray, most: float, weight: float) -> Terms:
    over = value > most
    return np.where(over, weight * (value - most), 0.0), slope * (weight * over)[..., None]


def _within(value: FloatArray, slope: FloatArray, most: float, weight: float) -> Terms:
    sign = np.sign(value)
    return _above(sign * value, sign[..., None] * slope, most, weight)


def _wrapped(angles: FloatArray) -> FloatArray:
    return (angles + math.pi) % (2 * math.pi) - math.pi


def _flat(slope: FloatArray) -> FloatArray:
    return slope.reshape(*slope.shape[:2], -1)
