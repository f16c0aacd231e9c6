"""Whether the things of a room have room: no two in one place, and the robot in none of them.

The physics would throw apart what starts inside something else, and the run would be of another room than
that of the file.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from tandem.sim.floor_plan import Plan, gap, plan_of
from tandem.sim.things import BoxShape, CylinderShape

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tandem.sim.robots.robot import Robot
    from tandem.sim.scene import SceneBody
    from tandem.skills.ports.pose import FloorPose

TOUCH: Final = 0.0005
"""Metres by which two things may overlap: things that are put side by side touch, to within a file's digits.
``tandem.sim.scene.GAP`` is as much, and ``tandem.sim.room`` takes the physics' word by the same measure."""


@dataclass(frozen=True)
class Placed:
    """A robot where it starts: the path of that in the scenario, and what it is called in words."""

    where: str
    words: str
    start: FloorPose
    robot: Robot


def clashes(
    furniture: Sequence[SceneBody],
    items: Sequence[SceneBody],
    obstacles: Sequence[SceneBody],
    robots: Sequence[Placed],
) -> Iterator[tuple[str, str]]:
    """Give the path in a scenario of each thing that starts inside another, and which."""
    placed = [
        *((f"items.{index}", body) for index, body in enumerate(items)),
        *((f"obstacles.{index}", body) for index, body in enumerate(obstacles)),
    ]
    before = list(furniture)
    for where, body in placed:
        if other := inside(body, before):
            yield where, f"{body.name} is in one place with {other}"
        before.append(body)
    for index, each in enumerate(robots):
        start, radius = each.start, each.robot.footprint_radius
        disc = Plan(((start.x, start.y),), radius)
        hit = [
            body.name
            for body in before
            if _span(body)[0] < each.robot.height and gap(disc, plan_of(_shrunk(body))) <= 0.0
        ]
        hit += [other.words for other in robots[:index] if _apart(each, other) <= 0.0]
        if hit:
            at = f"({start.x:g}, {start.y:g})"
            yield (
                each.where,
                f"{each.words} at {at} takes {radius} m around it and is inside {', '.join(hit)}",
            )


def _apart(one: Placed, other: Placed) -> float:
    """Return the metres between the discs that two robots take."""
    centres = math.hypot(one.start.x - other.start.x, one.start.y - other.start.y)
    return centres - one.robot.footprint_radius - other.robot.footprint_radius


def inside(body: SceneBody, others: Sequence[SceneBody]) -> str:
    """Return the name of a thing that the body overlaps, or nothing."""
    plan, (bottom, top) = plan_of(_shrunk(body)), _span(body)
    for other in others:
        low, high = _span(other)
        if min(top, high) - max(bottom, low) > TOUCH and gap(plan, plan_of(_shrunk(other))) <= 0.0:
            return other.name
    return ""


def _shrunk(body: SceneBody) -> SceneBody:
    """Return it thinner by half of what two things may overlap, on all upright sides."""
    if isinstance(body.shape, CylinderShape):
        radius = max(body.shape.radius - TOUCH / 2, TOUCH / 2)
        return replace(body, shape=body.shape.model_copy(update={"radius": radius}))
    length, width, height = body.shape.size
    size = (max(length - TOUCH, TOUCH), max(width - TOUCH, TOUCH), height)
    return replace(body, shape=BoxShape(size=size))


def _span(body: SceneBody) -> tuple[float, float]:
    """Return the heights (m) of a body's bottom and top; scenarios stand everything upright."""
    height = body.shape.size[2] if isinstance(body.shape, BoxShape) else body.shape.height
    z = body.pose.position[2]
    return z - height / 2, z + height / 2
