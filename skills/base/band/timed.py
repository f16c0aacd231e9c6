"""Timed bands: poses on the floor, and the time between each two of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.base.floor import FloatArray


@dataclass(frozen=True)
class Bands:
    """Of k bands with n intervals each: poses in map and times.

    Headings are continuous: they don't jump by a turn from one pose to the next.
    """

    poses: FloatArray
    """x, y (m) and heading (rad), shape (k, n + 1, 3)."""
    times: FloatArray
    """Seconds between two poses, shape (k, n)."""

    @property
    def moments(self) -> FloatArray:
        """Seconds from now to each pose, shape (k, n + 1)."""
        start = np.zeros((len(self.times), 1))
        return np.concatenate((start, np.cumsum(self.times, axis=1)), axis=1)

    @property
    def lasts(self) -> FloatArray:
        """Seconds from the first to the last pose, shape (k,)."""
        return np.asarray(self.times.sum(axis=1))

    def chosen(self, number: int) -> Bands:
        """Return one of them."""
        return Bands(self.poses[number : number + 1], self.times[number : number + 1])


@dataclass(frozen=True)
class Motion:
    """How the bands move in each interval; all of shape (k, n)."""

    along: FloatArray
    """Metres along the mean heading."""
    aside: FloatArray
    """Metres across it: a differential drive can't; 0 on an arc of a circle (Rösmann et al., equation 5)."""
    cos: FloatArray
    sin: FloatArray
    """Of the mean heading."""
    linear: FloatArray
    """m/s."""
    angular: FloatArray
    """rad/s."""


def motion(bands: Bands) -> Motion:
    """Return how the bands move."""
    step = np.diff(bands.poses, axis=1)
    mean = (bands.poses[:, 1:, 2] + bands.poses[:, :-1, 2]) / 2
    c, s = np.cos(mean), np.sin(mean)
    along, aside = step[..., 0] * c + step[..., 1] * s, step[..., 1] * c - step[..., 0] * s
    return Motion(along, aside, c, s, along / bands.times, step[..., 2] / bands.times)


def joined(bands: list[Bands]) -> Bands:
    """Return several as one batch."""
    return Bands(
        np.concatenate([each.poses for each in bands]), np.concatenate([each.times for each in bands])
    )
