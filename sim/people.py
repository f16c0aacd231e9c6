"""People of a scenario: where each walks, how fast, and how often it stops, turns and gives way.

``sim.walker`` moves them. Nothing but the simulation, reports and tests knows these; a robot sees legs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Final, Literal

from pydantic import Field

from tandem.sim.floor_plan import Plan, gap, plan_of
from tandem.sim.things import Coordinate, Name
from tandem.skills.ports.message import Message

if TYPE_CHECKING:
    from tandem.sim.placing import Placed
    from tandem.sim.scene import SceneBody

MOST_PEOPLE: Final = 3
"""Of one scenario: as many as the crossings draw at the most."""
RADIUS: Final = 0.20
"""Metres around a person's axis that its trunk and its legs take."""
NEAREST: Final = 0.05
"""Metres between two points of a path that are two."""

Point = tuple[Coordinate, Coordinate]


class Person(Message):
    """Somebody who walks along straight lines from point to point (m, in map), from the first one on."""

    name: Name
    path: Annotated[tuple[Point, ...], Field(min_length=2, max_length=20)]
    speed: float = Field(ge=0.3, le=1.4)
    """m/s where nothing slows them."""
    after: float = Field(default=0.0, ge=0.0, le=3600.0)
    """Seconds for which they stand at the first point before they set out."""
    then: Literal["back", "stay"] = "back"
    """At the path's end: walk it back, and so on; or stand there for good."""
    stops: float = Field(default=0.0, ge=0.0, le=1.0)
    """Times a second that they stop for a while, on average."""
    turns: float = Field(default=0.0, ge=0.0, le=1.0)
    """Times a second that they turn round, on average."""
    gives_way: float = Field(default=0.5, ge=0.0, le=1.0)
    """Share of their meetings with a robot in which they wait for it to pass."""


def path_problems(
    people: Sequence[Person],
    bounds: tuple[float, float, float, float],
    bodies: Sequence[SceneBody],
    robots: Sequence[Placed],
) -> Iterator[tuple[str, str]]:
    """Give the path in a scenario of each person who has no room, and why.

    Args:
        people: as the scenario has them.
        bounds: of the floor: x, y from; x, y to (m, in map).
        bodies: furniture, items and obstacles.
        robots: where they start.
    """
    plans = [(body.name, plan_of(body)) for body in bodies if body.pose.position[2] > 0.0]
    x_min, y_min, x_max, y_max = bounds
    for index, person in enumerate(people):
        where = f"people.{index}.path"
        for number, (start, end) in enumerate(zip(person.path, person.path[1:], strict=False)):
            if math.dist(start, end) < NEAREST:
                yield f"{where}.{number + 1}", f"expected a point more than {NEAREST} m from the last one"
                continue
            way = Plan((start, end), RADIUS)
            hit = next((name for name, plan in plans if gap(way, plan) <= 0.0), None)
            if hit is not None:
                yield f"{where}.{number + 1}", f"the way there takes {RADIUS} m around it, and meets {hit}"
        for number, (x, y) in enumerate(person.path):
            if not (x_min < x < x_max and y_min < y < y_max):
                expected = (
                    f"expected a place in the room, {bounds} (x, y from; x, y to), found ({x:g}, {y:g})"
                )
                yield f"{where}.{number}", expected
        yield from ((f"{where}.0", reason) for reason in _crowded(index, people, robots))


def _crowded(index: int, people: Sequence[Person], robots: Sequence[Placed]) -> Iterator[str]:
    start = people[index].path[0]
    for other in people[:index]:
        if math.dist(start, other.path[0]) < 2 * RADIUS:
            yield f"{people[index].name} would start inside {other.name}"
    for robot in robots:
        if math.dist(start, (robot.start.x, robot.start.y)) < RADIUS + robot.robot.footprint_radius:
            yield f"{people[index].name} would start inside {robot.words}"
