"""The way that an arm has come, so that it can go back along it (two-arm thesis, 4.3.1: rm_L and rm_R)."""

from __future__ import annotations

from typing import Final

import numpy as np

from tandem.skills.kinematics.transforms import Array

PHI: Final = 0.25
"""Seconds of motion between two samples that are told: the thesis's phi, for which it gives no number."""
FINE: Final = 0.02
"""Radians by which some joint differs between two positions that are kept."""
BACK: Final = 0.12
"""Radians between two positions of a way back: closer ones would make its curve rough, and so slow."""


class Record:
    """Positions of the joints; those told to others are the samples, thinned by ``phi`` seconds of motion.

    Sample 0 is where the arm started. Standing still records nothing.

    Args:
        phi: seconds.
    """

    def __init__(self, phi: float = PHI) -> None:
        self._phi = phi
        self._way: list[Array] = []
        self._samples: list[int] = []
        self._moved = 0.0

    @property
    def samples(self) -> int:
        """How many samples there are."""
        return len(self._samples)

    def add(self, q: Array, seconds: float) -> None:
        """Note where the arm is after so many seconds of motion."""
        if not self._way:
            self._way.append(q.copy())
            self._samples.append(0)
            return
        self._moved += seconds
        due = self._moved >= self._phi - 1e-9
        if due or float(np.abs(q - self._way[-1]).max()) >= FINE:
            self._way.append(q.copy())
        if due:
            self._samples.append(len(self._way) - 1)
            self._moved = 0.0

    def sample(self, number: int) -> Array:
        """Return a sample's positions (n,); beyond the record, the last or the first."""
        return self._way[self._samples[self._bounded(number)]]

    def way_back(self, q: Array, number: int) -> Array:
        """Return the positions (m, n) from q back along the record to a sample."""
        first = self._samples[self._bounded(number)]
        path = [q, *reversed(self._way[first:])]
        kept = [path[0]]
        for each in path[1:-1]:
            if float(np.abs(each - kept[-1]).max()) >= BACK:
                kept.append(each)
        last = path[-1]
        while len(kept) > 1 and float(np.abs(last - kept[-1]).max()) < BACK:
            kept.pop()
        return np.array([*kept, last])

    def cut(self, number: int) -> None:
        """Forget what came after a sample: the arm stands there again."""
        last = self._bounded(number)
        self._way = self._way[: self._samples[last] + 1]
        self._samples = self._samples[: last + 1]
        self._moved = 0.0

    def cut_at(self, q: Array) -> None:
        """Forget what came after the position nearest to q: the arm stands there, on its way back."""
        last = int(np.argmin([float(np.abs(each - q).max()) for each in self._way]))
        self._way = self._way[: last + 1]
        self._samples = [k for k in self._samples if k <= last]
        self._moved = 0.0

    def _bounded(self, number: int) -> int:
        """Return the sample's number within the record; the lower bound is 0."""
        return max(0, min(number, len(self._samples) - 1))
