"""Joint limits of whole paths: what is beyond them is led back smoothly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.optimising.smoothness import Smoothness
from tandem.skills.kinematics.transforms import Array

ROUNDS: Final = 8
"""Corrections, after which the rest is cut off."""
NOTHING: Final = 1e-9
"""Weighed radians beyond a limit that are rounding, not a violation: without it the rounds would go on for
rounding."""


@dataclass(frozen=True)
class Bounds:
    """Limits of weighed joint positions, each (n,)."""

    lower: Array
    upper: Array

    def bring_back(self, path: Array, form: Smoothness) -> Array:
        """Return the path (N + 2, n) with its points between the ends within the limits.

        Each joint's violation is spread by A^-1 and scaled so that the greatest one vanishes, a few times
        over (Zucker et al. 2013, 4.2): a bend remains where cutting off would leave corners.
        """
        inner = path[1:-1].copy()
        for _ in range(ROUNDS):
            beyond = np.clip(inner, self.lower, self.upper) - inner
            worst = np.argmax(np.abs(beyond), axis=0)
            columns = np.flatnonzero(np.abs(beyond[worst, range(inner.shape[1])]) > NOTHING)
            if not len(columns):
                break
            spread = form.inverse @ beyond[:, columns]
            rows = worst[columns]
            inner[:, columns] += spread * (
                beyond[rows, columns] / spread[rows, range(len(columns))]
            )  # fmt: skip
        return np.concatenate((path[:1], np.clip(inner, self.lower, self.upper), path[-1:]))
