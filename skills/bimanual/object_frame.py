"""Two hands as one: their middle frame, and each hand's place in it (two-arm thesis, eq. 4.2).

The thesis has both hands shifted by the same vector. Told in the frame of the thing between them, that is:
each hand's pose in that frame stays as it is, however the frame moves or turns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from tandem.skills.geometry.poses import (
    add,
    compose,
    conjugate,
    from_axes,
    invert,
    length,
    multiply,
    rotate,
    scale,
    subtract,
)
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose

_UP: Vector3 = (0.0, 0.0, 1.0)


class HandsApartError(ValueError):
    """The hands do not face each other; the message says how they stand."""


@dataclass(frozen=True)
class Span:
    """Both hands around a thing: their middle in the base, and each tool in that middle.

    The middle's y points from the right hand to the left one, its z is up as far as that leaves it free.
    """

    middle_in_base: Pose
    left_in_middle: Pose
    right_in_middle: Pose

    def tools(self, middle_in_base: Pose, inwards: tuple[float, float]) -> tuple[Pose, Pose]:
        """Return both tools in the base, left first, for a middle.

        Args:
            middle_in_base: where the thing is brought to.
            inwards: metres by which the left and the right hand are nearer to the middle than at first.
        """
        left = _shifted(self.left_in_middle, (0.0, -inwards[0], 0.0))
        right = _shifted(self.right_in_middle, (0.0, inwards[1], 0.0))
        return compose(middle_in_base, left), compose(middle_in_base, right)

    def middle(self, left_in_base: Pose, right_in_base: Pose) -> Pose:
        """Return where the middle is, as both tools' poses tell it: between what each of them says."""
        says = [
            compose(left_in_base, invert(self.left_in_middle)),
            compose(right_in_base, invert(self.right_in_middle)),
        ]
        position = scale(add(says[0].position, says[1].position), 0.5)
        return Pose(position=position, orientation=_halfway(says[0], says[1]))


def span(left_in_base: Pose, right_in_base: Pose) -> Span:
    """Return the span of two hands that point at each other.

    Raises:
        HandsApartError: when their fingers don't point at each other, within about 30 degrees.
    """
    between = subtract(left_in_base.position, right_in_base.position)
    apart = length(between)
    pointing = subtract(
        rotate(right_in_base.orientation, (1.0, 0.0, 0.0)), rotate(left_in_base.orientation, (1.0, 0.0, 0.0))
    )
    facing = math.inf if apart == 0.0 else sum(a * b for a, b in zip(pointing, between, strict=True)) / apart
    if not 1.7 < facing < math.inf:  # noqa: PLR2004 - 2 cos(30 degrees)
        raise HandsApartError(
            f"expected hands that point at each other; their fingers and the line between them agree "
            f"by {facing:.2f} of 2, {apart:.3f} m apart"
        )
    y = scale(between, 1.0 / apart)
    up = subtract(_UP, scale(y, y[2]))
    z = scale(up, 1.0 / length(up))
    x = (y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0])
    centre = scale(add(left_in_base.position, right_in_base.position), 0.5)
    middle = Pose(position=centre, orientation=from_axes(x, y, z))
    inverse = invert(middle)
    return Span(middle, compose(inverse, left_in_base), compose(inverse, right_in_base))


def tilt(before: Pose, now: Pose) -> float:
    """Return the angle (rad) by which what was upright leans now; turning about the upright is none."""
    turned = multiply(now.orientation, conjugate(before.orientation))
    return math.acos(max(-1.0, min(1.0, rotate(turned, _UP)[2])))


def _shifted(pose: Pose, by: Vector3) -> Pose:
    return Pose(position=add(pose.position, by), orientation=pose.orientation)


def _halfway(a: Pose, b: Pose) -> tuple[float, float, float, float]:
    """Return the attitude half-way between two that are near each other."""
    turn = multiply(conjugate(a.orientation), b.orientation)
    sign = -1.0 if turn[3] < 0.0 else 1.0
    half = tuple(0.5 * sign * part for part in turn[:3])
    size = math.sqrt(sum(part * part for part in half) + (0.5 * (sign * turn[3] + 1.0)) ** 2)
    unit = (half[0] / size, half[1] / size, half[2] / size, 0.5 * (sign * turn[3] + 1.0) / size)
    return multiply(a.orientation, unit)
