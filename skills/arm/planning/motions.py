"""Straight motions in joint space and how finely they are checked.

Joints are weighed by how far they can move the hand: a step of ``x = w * q`` of length d moves no point of
the arm by much more than d metres. So a turn of the shoulder is checked finely and one of the wrist coarsely.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.model import Chain, Limits
from tandem.skills.kinematics.transforms import Array

STEP = 0.025
"""Metres (weighed) between two checked states of a motion."""
SMALLEST_WEIGHT = 0.3
"""So that a joint's step never exceeds STEP / 0.3 = 0.083 rad."""
LARGEST_WEIGHT = 1.0


@dataclass(frozen=True)
class Space:
    """The joints' limits and weights: metres a radian (or a metre), each (n,)."""

    limits: Limits
    weights: Array

    def length(self, a: Array, b: Array) -> float:
        """Return the weighed length of the straight motion, in metres."""
        return float(np.linalg.norm((b - a) * self.weights))

    def seconds(self, a: Array, b: Array) -> float:
        """Return the time of the straight motion at the joints' full speeds."""
        return float(np.max(np.abs(b - a) / self.limits.velocity))


def weigh(chain: Chain, limits: Limits, frame: str, samples: int = 12) -> Array:
    """Return the joints' weights (n,): the farthest that ``frame`` gets from each joint's origin.

    Taken over configurations spread evenly over the limits, so that it is the same each time.
    """
    weights = np.full(len(chain.joints), SMALLEST_WEIGHT)
    for k in range(samples):
        fractions = (np.arange(len(chain.joints)) * 0.618 + k / samples) % 1.0
        q = limits.lower + fractions * (limits.upper - limits.lower)
        tip = chain.placement(q, frame).translation
        for i, joint in enumerate(chain.joints):
            reach = float(np.linalg.norm(tip - chain.placement(q, joint).translation))
            weights[i] = max(weights[i], reach)
    return np.asarray(np.minimum(weights, LARGEST_WEIGHT))


class Motions:
    """Checks straight motions of a group.

    Args:
        checker: says which states are free.
        space: weighs the joints.
        step: metres (weighed) between two states that are checked.
    """

    def __init__(self, checker: CollisionChecker, space: Space, step: float = STEP) -> None:
        self.checker, self.space, self.step = checker, space, step

    def free(self, a: Array, b: Array) -> bool:
        """Say whether the straight motion from a to b is free; a itself is known to be.

        The end is checked first and then the middle, the quarters and so on: what is blocked is found early.
        """
        steps = max(1, int(np.ceil(self.space.length(a, b) / self.step)))
        states = np.concatenate((b[None], a + _order(steps) * ((b - a) / steps)))
        return self.checker.first_contact(states) is None


@functools.lru_cache(maxsize=1024)
def _order(steps: int) -> Array:
    """Return ``halving`` as a column (steps - 1, 1)."""
    return np.array(halving(steps), dtype=float).reshape(-1, 1)


def halving(steps: int) -> list[int]:
    """Return 1 .. steps - 1, middle first, then the middles of the halves and so on (van der Corput)."""
    order: list[int] = []
    layer = [(0, steps)]
    while layer:
        below: list[tuple[int, int]] = []
        for low, high in layer:
            if high - low > 1:
                middle = (low + high) // 2
                order.append(middle)
                below += [(low, middle), (middle, high)]
        layer = below
    return order
