"""An arm's ways as joint positions, and the true clearance between two arms' ways: the eager criterion.

Each position of the one is paired with each of the other: who goes when is not known. Two ways are clear of
each other when no pair is nearer than a margin. Which ways those are is in ``announced.py``.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.geometry.poses import add, length, scale, subtract
from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.hand_following import PoseFollower
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose

MARGIN: Final = 0.06
"""Metres between the arms that ways must leave: twice what the reflex stops at."""
STRIDE: Final = 0.04
"""Metres of the hand between two poses that are looked at."""
MOST: Final = 20
"""Poses of one straight way, at the most."""
APART: Final = 0.12
"""Radians by which recorded poses must differ to be looked at each."""
AT_ONCE: Final = 10
"""Pairs a slice: about 1 ms."""


def clear(
    bodies: ArmsClearance, left: list[Array], right: list[Array], margin: float = MARGIN
) -> Generator[None, None, bool]:
    """Say whether each of the left arm's positions (n,) keeps clear of each of the right arm's.

    Yields:
        After each slice.
    """
    done = 0
    for a in left:
        for b in right:
            if bodies.at(np.concatenate((a, b))).distance < margin:
                return False
            done += 1
            if done % AT_ONCE == 0:
                yield
    return True


def straight(follower: PoseFollower, q: Array, goal: Vector3, short: float) -> list[Array]:
    """Return joint positions (n,) along the hand's straight way to a point in the base, its attitude kept.

    Args:
        follower: of the arm.
        q: where it begins; not among what is returned.
        goal: the point.
        short: metres before it at which the way ends.
    """
    start = follower.pose(q)
    way = subtract(goal, start.position)
    metres = length(way) - short
    if metres <= 0.0:
        return []
    count = min(MOST, int(np.ceil(metres / STRIDE)))
    found = []
    for k in range(1, count + 1):
        position = add(start.position, scale(way, k / count * metres / length(way)))
        q = follower.follow(q, Pose(position=position, orientation=start.orientation)).q
        found.append(q)
    return found


def joined(a: Array, b: Array, count: int = 4) -> list[Array]:
    """Return ``count`` positions on the straight line from a (left out) to b."""
    return [a + (b - a) * k / count for k in range(1, count + 1)]


def thinned(record: list[Array]) -> list[Array]:
    """Return the recorded positions that differ by some, the last one always."""
    kept: list[Array] = []
    for q in record:
        if not kept or float(np.max(np.abs(q - kept[-1]))) >= APART:
            kept.append(q)
    if record and kept[-1] is not record[-1]:
        kept.append(record[-1])
    return kept
