"""What the field asks of the hand: a velocity and a rate of turn, from the poles and what is near."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from tandem.skills.arm.field.escape import HAND_RADIUS, Pole, choose, way_length
from tandem.skills.arm.field.hand_surroundings import OTHER_GOAL, Around
from tandem.skills.arm.field.potential import Gains, pull, push
from tandem.skills.kinematics.proximity import Nearby
from tandem.skills.kinematics.transforms import Array, rotation_vector
from tandem.skills.ports.message import Vector3

CHOOSE_EVERY: Final = 5
"""Periods between two choices of a pole."""


@dataclass(frozen=True)
class DesiredTwist:
    """The twist (6,) of the hand in the base's axes, what draws it, and what is left: metres and seconds."""

    twist: Array
    pole: Pole
    remaining: float
    seconds: float


class Chooser:
    """Remembers which pole is pursued."""

    def __init__(self) -> None:
        self._pole: Pole | None = None
        self._count = 0
        self.escapes = 0
        """How often an escape point was used."""

    def pole(self, hand: Array, goal: Array, around: Around) -> Pole:
        """Return the pole for now; the choice is made anew every few periods."""
        self._count += 1
        before = self._pole
        if before is not None and self._count < CHOOSE_EVERY:
            return before if before.escape else Pole(goal)
        self._count = 0
        chosen = choose(hand, goal, around, "" if before is None else before.label)
        if chosen.escape and (before is None or chosen.label != before.label):
            self.escapes += 1
        self._pole = chosen
        return chosen

    def reset(self) -> None:
        """Forget the pole."""
        self._pole = None


def desired_twist(  # noqa: PLR0917 - the field's parts
    hand: Array, goal: Array, pole: Pole, rho: Array, normals: Array, gains: Gains, soonest: float
) -> DesiredTwist:
    """Return what the field asks: way and turn end together.

    Args:
        hand: the tool frame in the base, (4, 4).
        goal: where it shall be, (4, 4).
        pole: what draws it.
        rho: metres to what is near the hand, (m,).
        normals: unit vectors from it to the hand, (m, 3).
        gains: of the field.
        soonest: seconds that turn and joints need at the least.
    """
    p, g = hand[:3, 3], goal[:3, 3]
    remaining = way_length(pole, p, g) if pole.escape else float(np.linalg.norm(g - p))
    drawn = pull(p, pole.point, remaining, gains.escape if pole.escape else gains.goal, gains)
    seconds = max(remaining / max(float(np.linalg.norm(drawn)), 1e-3), soonest)
    drawn *= min(1.0, remaining / seconds / max(float(np.linalg.norm(drawn)), 1e-9))
    velocity = drawn + push(rho, normals, float(np.linalg.norm(g - p)), gains)
    size = float(np.linalg.norm(velocity))
    if size > gains.cruise:
        velocity *= gains.cruise / size
    turn = rotation_vector(hand[:3, :3], goal[:3, :3])
    return DesiredTwist(np.concatenate((velocity, turn / seconds)), pole, remaining, seconds)


def nearest_of_hand(near: Nearby, hand: npt.NDArray[np.bool_], first_obstacle: int) -> tuple[Array, Array]:
    """Return distances (m,) and normals (m, 3) of the hand to each obstacle that it is near to, one for each.

    Args:
        near: all pairs that are near.
        hand: which bodies belong to the hand, (bodies,) of bools.
        first_obstacle: number of the first body that is one.
    """
    rows = np.flatnonzero(hand[near.body] & (near.other >= first_obstacle))
    rows = rows[np.argsort(near.distance[rows], kind="stable")]
    kept = rows[np.sort(np.unique(near.other[rows], return_index=True)[1])]
    return near.distance[kept], near.normal[kept]


def with_other_goal(
    rho: Array, normals: Array, hand: Array, other_goal: Vector3 | None
) -> tuple[Array, Array]:
    """Return distances and normals with the other arm's goal as one more obstacle (two-arm thesis, 4.3)."""
    if other_goal is None:
        return rho, normals
    away = hand - np.array(other_goal)
    size = max(float(np.linalg.norm(away)), 1e-6)
    gap = size - OTHER_GOAL - HAND_RADIUS
    return np.append(rho, gap), np.concatenate((normals.reshape(-1, 3), away[None, :] / size))
