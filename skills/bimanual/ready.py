"""Where both hands begin to close in, and where they go when they let go."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.bimanual.object_frame import Span
from tandem.skills.geometry.poses import (
    about,
    add,
    compose,
    conjugate,
    invert,
    multiply,
    rotate,
    scale,
    transform,
)
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.message import Quaternion, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import SiteItem

STRAIGHT: Final[Quaternion] = (0.0, 0.0, 0.0, 1.0)
"""No turn."""


def ready_tools(
    item_in_base: Pose, item: SiteItem, tools: tuple[Pose, Pose], before: float, lean: float = 0.0
) -> tuple[Pose, Pose]:
    """Return both tools in the base, ``before`` metres before the item's surface, left first.

    Each keeps its turn about its own fingers: it is only swung until they point inwards, or nearly so.

    Args:
        item_in_base: the item's centre frame.
        item: says where its grasp points are.
        tools: both tools now.
        before: metres between the surface and the tool's origin.
        lean: radians by which they may go on pointing past inwards.
    """
    made = []
    for side, tool in zip(PAIR, tools, strict=True):
        point = next(each for each in item.grasp_points if each.side == side)
        inwards = rotate(item_in_base.orientation, point.inwards)
        size = math.sqrt(sum(part * part for part in inwards))
        inwards = scale(inwards, 1.0 / size)
        position = add(transform(item_in_base, point.position), scale(inwards, -before))
        made.append(Pose(position=position, orientation=pointing(tool.orientation, inwards, lean)))
    left, right = made
    return left, right


def pointing(orientation: Quaternion, along: Vector3, lean: float = 0.0) -> Quaternion:
    """Return the attitude swung by the smallest turn that brings its x to a unit direction, or near enough.

    Args:
        orientation: the attitude.
        along: the unit direction.
        lean: radians between the two that are near enough.
    """
    x = rotate(orientation, (1.0, 0.0, 0.0))
    axis = (
        x[1] * along[2] - x[2] * along[1],
        x[2] * along[0] - x[0] * along[2],
        x[0] * along[1] - x[1] * along[0],
    )
    sine, cosine = (
        math.sqrt(sum(part * part for part in axis)),
        sum(a * b for a, b in zip(x, along, strict=True)),
    )
    if sine < 1e-9:  # noqa: PLR2004 - there already, or the other way round, which no hand is
        return orientation
    return multiply(about(axis, max(0.0, math.atan2(sine, cosine) - lean)), orientation)


def between(item_in_base: Pose, middle_in_base: Pose) -> Pose:
    """Return the item in the hands' middle, which its two sides have been brought to: y is 0 there."""
    found = compose(invert(middle_in_base), item_in_base)
    x, _, z = found.position
    return Pose(position=(x, 0.0, z), orientation=found.orientation)


def swing(came: tuple[Pose, Pose], ready: tuple[Pose, Pose]) -> tuple[Quaternion, Quaternion]:
    """Return by how much each hand was turned when it came, in the axes that it has when it is ready."""
    left, right = (
        multiply(conjugate(b.orientation), a.orientation) for a, b in zip(came, ready, strict=True)
    )
    return left, right


def ways_back(
    span: Span,
    middle: Pose,
    inwards: tuple[float, float],
    came: tuple[Quaternion, Quaternion],
    apart: float,
) -> list[tuple[Pose, Pose]]:
    """Return where both tools may be drawn back to, the best first: as far as asked, or less.

    Each hand turns again to how it came: an arm that points straight inwards has its wrist bent to the
    limit, and gets no farther out like that.

    Args:
        span: of the hands.
        middle: of the hands in the base.
        inwards: metres by which each is nearer to the middle than at first.
        came: as of ``swing``.
        apart: metres to be drawn back.
    """
    ends = []
    for way in (apart, 0.75 * apart, 0.5 * apart, 0.3 * apart):
        tools = span.tools(middle, (inwards[0] - way, inwards[1] - way))
        left, right = (
            Pose(position=tool.position, orientation=multiply(tool.orientation, turn))
            for tool, turn in zip(tools, came, strict=True)
        )
        ends.append((left, right))
    return ends
