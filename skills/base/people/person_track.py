"""One thing that may be a person, over time: a Kalman filter (Kalman 1960) with constant velocity."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.people.segments import Candidate

SHAKE: Final = 1.2
"""m/s2: how people change their velocity; they stop within a second."""
FIRST_SPEED: Final = 0.8
"""m/s, one standard deviation: of somebody who has just come into view."""
MOVED: Final = 0.25
"""Metres over which a thing must have gone, scan by scan, before it is a person."""
SCANS: Final = (5, 12)
"""Scans of this: at least; at the most, for somebody at 0.3 m/s."""
STRAIGHT: Final = 0.045
"""Metres, root mean square, off an even pace along a straight line. Between the legs of a chair a track jumps
to and fro by 0.1 m and more; the middle of two walking legs is as exact as the laser."""
SUSPECTED: Final = (3, 0.35, 0.12)
"""Scans, m/s and metres from which on a thing is a suspect."""
STANDS: Final = 0.15
"""m/s below which a person stands."""
COASTS: Final = 0.6
"""Seconds in which the velocity of somebody who is hidden falls to a third."""


@dataclass
class Track:
    """Place and velocity in map, and their covariance; ``walked`` once it can be no furniture."""

    id: int
    state: FloatArray
    covariance: FloatArray
    recent: list[tuple[float, float]] = field(default_factory=list)
    """Where the last scans showed it (m), the newest last; what one has missed begins anew."""
    misses: int = 0
    unseen: float = 0.0
    """Robot seconds since a scan showed it."""
    stood: float = 0.0
    """Robot seconds for which it has stood."""
    walked: bool = False
    on_still: bool = False
    """Whether it was seen last where something has stood for a while."""

    @classmethod
    def of(cls, number: int, seen: Candidate) -> Track:
        """Begin with what a scan shows."""
        spread = np.diag([seen.sigma**2, seen.sigma**2, FIRST_SPEED**2, FIRST_SPEED**2])
        return cls(number, np.array([seen.x, seen.y, 0.0, 0.0]), spread, [(seen.x, seen.y)])

    @property
    def place(self) -> tuple[float, float]:
        """X and y (m)."""
        return float(self.state[0]), float(self.state[1])

    @property
    def velocity(self) -> tuple[float, float]:
        """m/s along x and y."""
        return float(self.state[2]), float(self.state[3])

    @property
    def speed(self) -> float:
        """m/s."""
        return math.hypot(*self.velocity)

    @property
    def sigma(self) -> float:
        """How well the place is known (m)."""
        return math.sqrt(max(float(self.covariance[0, 0] + self.covariance[1, 1]) / 2, 0.0))

    @property
    def suspect(self) -> bool:
        """Whether it may be a person who has just set out: enough to brake for, not to tell anybody."""
        if self.walked or self.on_still or self.misses or len(self.recent) < SUSPECTED[0]:
            return False
        return self.speed > SUSPECTED[1] and math.dist(self.recent[-1], self.recent[0]) > SUSPECTED[2]

    def predict(self, seconds: float) -> None:
        """Let time pass."""
        carry = np.eye(4)
        carry[0, 2] = carry[1, 3] = seconds
        self.state = carry @ self.state
        if self.unseen > 0.0:
            self.state[2:] *= math.exp(-seconds / COASTS)
        half, whole = seconds * seconds / 2, seconds
        push = np.array([[half, 0.0], [0.0, half], [whole, 0.0], [0.0, whole]])
        self.covariance = carry @ self.covariance @ carry.T + push @ push.T * SHAKE**2
        self.unseen += seconds
        if self.unseen <= seconds:  # whose velocity only fades may walk on
            self.stood = self.stood + seconds if self.speed < STANDS else 0.0

    def update(self, seen: Candidate, *, still: bool = False) -> None:
        """Take in what a scan shows of it; ``still``: where something has stood for a while."""
        spread = self.covariance[:2, :2] + np.eye(2) * seen.sigma**2
        gain = self.covariance[:, :2] @ np.linalg.inv(spread)
        self.state = self.state + gain @ (np.array([seen.x, seen.y]) - self.state[:2])
        self.covariance = self.covariance - gain @ self.covariance[:2, :]
        if self.misses:
            self.recent.clear()
        self.recent = [*self.recent[-SCANS[1] + 1 :], (seen.x, seen.y)]
        self.misses, self.unseen, self.on_still = 0, 0.0, still
        self.walked = self.walked or (not still and goes(self.recent))


def goes(places: list[tuple[float, float]]) -> bool:
    """Say whether the last of the places, one a scan, are those of somebody who walks at an even pace."""
    for count in range(SCANS[0], len(places) + 1):
        last = np.array(places[-count:])
        if float(np.hypot(*(last[-1] - last[0]))) < MOVED:
            continue
        even = np.stack((np.ones(count), np.arange(count)), axis=1)
        off = last - even @ np.linalg.lstsq(even, last, rcond=None)[0]
        if math.sqrt(float((off**2).sum(axis=1).mean())) < STRAIGHT:
            return True
    return False
