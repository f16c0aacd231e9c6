"""Whether a band may be driven, and what it costs."""

from __future__ import annotations

from typing import Final

import numpy as np

from tandem.skills.base.band.limits import Task
from tandem.skills.base.band.timed import Bands, motion
from tandem.skills.base.floor import BoolArray, FloatArray
from tandem.skills.base.people.cost import costs

EXCESS: Final = 1.05
"""Of speeds over the drive's limits."""
PUSHED: Final = 1.3
"""Of accelerations over them: the wheels keep theirs, and a new plan begins from what they have done."""
BACK: Final = 0.05
"""Share of the speed ahead: as good as standing."""
SKIDS: Final = 0.03
"""Metres across the heading in an interval."""
BITES: Final = 0.01
"""Metres that a pose may be nearer to a thing than it has to be."""
NEARS: Final = 0.06
"""The same of people."""
LEAVES: Final = 1.2
"""Seconds in which a base that is just before somebody has to be out of their way."""
UNEASE: Final = 1.5
"""Seconds that a second is worth right where somebody will be."""


def may_be_driven(bands: Bands, task: Task) -> BoolArray:
    """Say which bands, shape (k,), keep the limits, clear all things and stay away from people."""
    return _can_be_moved(bands, task) & _clears(bands, task) & _away(bands, task)


def price(bands: Bands, task: Task) -> FloatArray:
    """Return what the bands cost, shape (k,): seconds, and what being near people is worth in seconds."""
    k, n = bands.times.shape
    points, moments = bands.poses[:, 1:, :2].reshape(-1, 2), bands.moments[:, 1:].reshape(-1)
    near = costs(points, moments + task.around.age, task.around.people).reshape(k, n)
    return np.asarray(bands.lasts + UNEASE * (near * bands.times).sum(axis=1))


def _can_be_moved(bands: Bands, task: Task) -> BoolArray:
    how, drive, begin = motion(bands), task.drive, task.begin
    fast = np.maximum(how.linear / drive.forward, np.abs(how.angular) / drive.turn).max(axis=1)
    back, skids = -how.linear.min(axis=1), np.abs(how.aside).max(axis=1)
    half = (bands.times[:, 1:] + bands.times[:, :-1]) / 2
    pushed = np.abs(np.diff(how.linear, axis=1) / half).max(axis=1) / drive.acceleration
    turned = np.abs(np.diff(how.angular, axis=1) / half).max(axis=1) / drive.turn_acceleration
    sets_off = np.abs(how.linear[:, 0] - begin.linear) / (drive.acceleration * bands.times[:, 0])
    moved: BoolArray = (fast <= EXCESS) & (back <= BACK * drive.forward) & (skids <= SKIDS)
    pushes: BoolArray = np.maximum(np.maximum(pushed, turned), sets_off) <= PUSHED
    return moved & pushes


def _clears(bands: Bands, task: Task) -> BoolArray:
    """Look at poses and the middles between them."""
    at = bands.poses[..., :2]
    points = np.concatenate((at[:, 1:], (at[:, 1:] + at[:, :-1]) / 2), axis=1)
    flat = points.reshape(-1, 2)
    clearances = task.around.clearances
    spare = clearances.field.at(flat) - clearances.required(flat)
    return np.asarray((spare.reshape(points.shape[:2]) >= -BITES).all(axis=1))


def _away(bands: Bands, task: Task) -> BoolArray:
    """Nobody comes nearer than they may; who is nearer already comes no nearer.

    A base that is before somebody now has a moment to leave.
    """
    at, moments = bands.poses[..., :2], bands.moments
    spare = task.around.gaps(at, moments, front=0.0).spare
    bodies = spare >= np.minimum(0.0, spare[..., :1]) - NEARS
    before = task.around.gaps(at, moments).spare >= -NEARS
    leaves = (moments < LEAVES) & ~before[..., :1]
    return np.asarray((bodies & (before | leaves)).all(axis=(0, 2)))
