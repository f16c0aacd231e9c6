"""Escape points around obstacles, and which pole to pursue: the goal or one of them (two-arm thesis, 2.4).

A hand that only goes down its potential stops where pull and push cancel. So around each post
(``around.Post``) that lies between hand and goal, points are made at r + d_s and a little more from its
axis: to the left and to the right of the way, and above it. Each is a pole that may draw the hand instead
of the goal.

Which one is a soft constraint satisfaction problem in the sense of Bistarelli ([3] of the thesis), with
one variable, the pole, and two constraints over the weighted c-semiring <R+ u {inf}, min, +, inf, 0>: costs
are added, the least is best, inf is forbidden and 0 is perfect. For the way hand -> pole -> goal

    avoid(pole) = -ln clip(clearance / WIDE, e^-7, 1)           how near the way comes to anything
    reach(pole) = -ln (|hand - goal| / |hand - pole - goal|)    how much longer it is than the straight one
    cost(pole)  = AVOID avoid(pole) + REACH reach(pole)

(in the probabilistic semiring <[0, 1], max, *, 0, 1> the same choice: the product of both preferences with
the weights as exponents). The pole of before costs KEPT less, so that the choice does not flicker. The
thesis gives neither formula nor weights: with AVOID = 1 and REACH = 2 a way around that is a third longer
(0.57) is taken as soon as the straight one has less than about half of the clearance wanted (0.69), and
never for less than a fifth of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.field.hand_surroundings import Around, Post
from tandem.skills.kinematics.transforms import Array

HAND_RADIUS: Final = 0.05
"""Metres about the tool's origin that the hand takes."""
SAFE: Final = 0.08
"""d_s: metres between the tool's origin and an obstacle's surface: the hand's radius and 3 cm."""
BEYOND: Final = 0.02
"""Metres beyond r + d_s at which escape points lie."""
WIDE: Final = 0.09
"""Metres of clearance that are as good as any."""
AVOID, REACH = 1.0, 2.0
KEPT: Final = 0.1
"""Of cost, by which the pole of before is cheaper: a twentieth of the way's length, or a tenth of its
clearance. With less the choice flickers between two ways as good; with more a worse way is kept."""
WORST: Final = 7.0
"""Of ``avoid`` at the most, which it is at e^-7 of WIDE, less than 0.1 mm of clearance: nearer is no worse,
as both touch."""
SAMPLES: Final = 9
"""Points of each leg at which its clearance is taken."""
NEAR_END: Final = 0.10
"""Metres around the goal that don't count: what stands there is the guard's business, not the way's."""


@dataclass(frozen=True)
class Pole:
    """What draws the hand: a point (3,) in the base. ``label`` tells it from others: "" is the goal."""

    point: Array
    label: str = ""

    @property
    def escape(self) -> bool:
        """Whether it is an escape point."""
        return bool(self.label)


def escape_points(hand: Array, goal: Array, around: Around) -> tuple[Pole, ...]:
    """Return the escape points around all posts that the straight way comes too near to."""
    legs = _leg(hand, goal)
    if not around.posts or not len(legs):
        return ()
    blocking = np.flatnonzero(around.post_gaps(legs).min(axis=0) < SAFE)
    return tuple(pole for k in blocking for pole in _around_post(int(k), around.posts[k], hand, goal))


def choose(hand: Array, goal: Array, around: Around, before: str = "") -> Pole:
    """Return the pole of least cost.

    Args:
        hand: where the hand is, (3,).
        goal: where it shall be.
        around: what stands around.
        before: label of the pole that was pursued.
    """
    poles = (Pole(goal), *escape_points(hand, goal, around))
    costs = [cost(pole, hand, goal, around) - KEPT * (pole.label == before) for pole in poles]
    return poles[int(np.argmin(costs))]


def cost(pole: Pole, hand: Array, goal: Array, around: Around) -> float:
    """Return what the way through a pole costs."""
    way = (
        np.concatenate((_leg(hand, pole.point), _leg(pole.point, goal))) if pole.escape else _leg(hand, goal)
    )
    way = way[np.linalg.norm(way - goal, axis=1) > NEAR_END]
    clearance = float(around.gaps(way).min(initial=np.inf))
    avoid = min(WORST, -float(np.log(np.clip(clearance / WIDE, 1e-9, 1.0))))
    straight = max(float(np.linalg.norm(goal - hand)), 1e-6)
    reach = float(np.log(way_length(pole, hand, goal) / straight))
    return AVOID * avoid + REACH * max(0.0, reach)


def way_length(pole: Pole, hand: Array, goal: Array) -> float:
    """Return the metres from the hand through the pole to the goal."""
    return max(float(np.linalg.norm(pole.point - hand) + np.linalg.norm(goal - pole.point)), 1e-6)


def _leg(a: Array, b: Array) -> Array:
    """Return points (SAMPLES, 3) from a, itself left out, to b."""
    shares = np.arange(1, SAMPLES + 1)[:, None] / SAMPLES
    return np.asarray(a + (b - a) * shares)


def _around_post(number: int, post: Post, hand: Array, goal: Array) -> tuple[Pole, ...]:
    way = goal[:2] - hand[:2]
    size = float(np.linalg.norm(way))
    ahead = way / size if size > 1e-6 else np.array([1.0, 0.0])  # noqa: PLR2004
    left = np.array([-ahead[1], ahead[0], 0.0])
    centre = np.array(post.centre)
    off = post.radius + SAFE + BEYOND
    level = np.array([centre[0], centre[1], hand[2] + _share(centre, hand, goal) * (goal[2] - hand[2])])
    above = np.array([centre[0], centre[1], centre[2] + post.half + SAFE + BEYOND])
    return (
        Pole(level + off * left, f"{number}/left"),
        Pole(level - off * left, f"{number}/right"),
        Pole(above, f"{number}/above"),
    )


def _share(centre: Array, hand: Array, goal: Array) -> float:
    """Return at which share of the way, in plan, the centre is passed."""
    way = goal[:2] - hand[:2]
    return float(np.clip((centre[:2] - hand[:2]) @ way / max(float(way @ way), 1e-9), 0.0, 1.0))
