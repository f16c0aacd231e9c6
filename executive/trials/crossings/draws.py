"""Draws a crossing: a drive through the room, and one to three people whose paths cross it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final, TypeVar

import numpy as np

from tandem.sim.floor_plan import Plan, gap, plan_of
from tandem.sim.people import RADIUS, Person
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.scene import furniture_bodies, obstacle_body
from tandem.sim.things import CylinderShape, Obstacle
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import Site

T = TypeVar("T")
Place = tuple[float, float]
"""x and y in the map (m)."""
FREE: Final = 0.40
"""Metres around the robot's axis that are free where a drive begins and ends."""
DRIVES: Final = 1.8
"""Metres of a drive at least."""
WALKS: Final = 1.6
"""Metres of a person's path at least."""
ACROSS: Final = (0.3, 0.7)
"""Where on the drive it is crossed, as a share of it."""
APART: Final = 1.0
"""Metres between anybody and the robot, and between two people, at the start."""
SPEED: Final = (0.3, 1.4)
"""m/s, from and to: what a ``Person`` allows."""
BEGINS: Final = (1.5, 4.5)
"""Seconds after which a person sets out; the drive begins after 1.5 s, when the base knows where it is."""
STEP: Final = 0.05
"""Metres by which a person's way grows while it is free."""
CHAIR: Final = 0.36
"""Metres between the legs of a chair that no map knows."""
MOST_DRAWS: Final = 2000
"""After which nothing is taken to fit."""


def draw(site: Site, rng: np.random.Generator) -> tuple[Scenario, FloorPose]:
    """Return a scenario, and where to drive in it: the LoCoBot's room without items, with a chair in it.

    Raises:
        ValueError: when nothing fits.
    """
    base = load_scenario("Locobot").model_copy(update={"items": (), "surfaces": ()})
    chair = _first(lambda: _chair(rng), lambda legs: _fits(site, base, legs))
    base = base.model_copy(update={"obstacles": (*base.obstacles, *chair)})
    plans = _plans(site, base)
    start = _first(lambda: _pose(rng), lambda at: _free(site, plans, (at.x, at.y), FREE))
    goal = _first(
        lambda: _pose(rng),
        lambda at: (
            _free(site, plans, (at.x, at.y), FREE) and math.dist((at.x, at.y), (start.x, start.y)) > DRIVES
        ),
    )
    people: list[Person] = []
    for name in ("anna", "ben", "cem")[: int(rng.integers(1, 4))]:
        taken = [(start.x, start.y), *(each.path[0] for each in people)]
        path = _first(
            lambda: _path(site, plans, start, goal, rng),
            lambda path: path is not None and all(math.dist(path[0], at) > APART for at in taken),  # noqa: B023
        )
        assert path is not None
        people.append(_person(name, path, rng))
    scenario = base.model_copy(update={"name": "crossing", "start": start, "people": tuple(people)})
    return scenario, goal


def _plans(site: Site, scenario: Scenario) -> list[Plan]:
    things = (obstacle_body(site, each) for each in scenario.obstacles)
    return [plan_of(body) for body in (*furniture_bodies(site), *things)]


def _person(name: str, path: Sequence[Place], rng: np.random.Generator) -> Person:
    return Person(
        name=name,
        path=tuple((round(x, 3), round(y, 3)) for x, y in path),
        speed=round(float(rng.uniform(*SPEED)), 2),
        after=round(float(rng.uniform(*BEGINS)), 2),
        stops=round(float(rng.uniform(0.0, 0.1)), 3),
        turns=round(float(rng.uniform(0.0, 0.1)), 3),
    )


def _path(
    site: Site, plans: Sequence[Plan], start: FloorPose, goal: FloorPose, rng: np.random.Generator
) -> tuple[Place, ...] | None:
    """Return a way over the drive's line: to both sides as far as there is room, perhaps with a bend."""
    share, angle = float(rng.uniform(*ACROSS)), float(rng.uniform(-math.pi, math.pi))
    bend = float(rng.uniform(-0.8, 0.8)) if rng.random() < 0.5 else 0.0  # noqa: PLR2004 - every other one
    middle = (start.x + share * (goal.x - start.x), start.y + share * (goal.y - start.y))
    if not _free(site, plans, middle, RADIUS + 0.05):
        return None
    ends = [_as_far(site, plans, middle, way, rng) for way in (angle, angle + math.pi + bend)]
    if sum(math.dist(middle, end) for end in ends) < WALKS or min(math.dist(middle, e) for e in ends) < STEP:
        return None
    return (ends[0], middle, ends[1]) if bend else (ends[0], ends[1])


def _as_far(site: Site, plans: Sequence[Plan], start: Place, angle: float, rng: np.random.Generator) -> Place:
    most, at, way = float(rng.uniform(0.6, 2.0)), start, 0.0
    while way < most:
        way += STEP
        there = (start[0] + way * math.cos(angle), start[1] + way * math.sin(angle))
        if not _free(site, plans, there, RADIUS + 0.05):
            break
        at = there
    return at


def _free(site: Site, plans: Sequence[Plan], at: Place, room: float) -> bool:
    x_min, y_min, x_max, y_max = site.bounds
    inside = x_min + room < at[0] < x_max - room and y_min + room < at[1] < y_max - room
    return inside and all(gap(Plan((at,)), plan) > room for plan in plans)


def _fits(site: Site, base: Scenario, legs: Sequence[Obstacle]) -> bool:
    plans = _plans(site, base)
    return all(_free(site, plans, (leg.x, leg.y), 0.10) for leg in legs)


def _chair(rng: np.random.Generator) -> tuple[Obstacle, ...]:
    """Return the four legs of a chair."""
    x, y, yaw = (float(rng.uniform(-1.6, 1.6)) for _ in range(3))
    c, s = CHAIR / 2 * math.cos(yaw), CHAIR / 2 * math.sin(yaw)
    at = ((x + c - s, y + s + c), (x - c - s, y - s + c), (x - c + s, y - s - c), (x + c + s, y + s - c))
    shape = CylinderShape(radius=0.02, height=0.45)
    return tuple(
        Obstacle(name=f"leg_{number}", shape=shape, x=round(px, 3), y=round(py, 3), mass=0.0)
        for number, (px, py) in enumerate(at)
    )


def _pose(rng: np.random.Generator) -> FloorPose:
    x, y, yaw = rng.uniform(-1.7, 1.7), rng.uniform(-1.7, 1.7), rng.uniform(-math.pi, math.pi)
    return FloorPose(x=round(float(x), 3), y=round(float(y), 3), yaw=round(float(yaw), 3))


def _first(one: Callable[[], T], fits: Callable[[T], bool]) -> T:
    """Return the first that fits of those that are drawn."""
    for _ in range(MOST_DRAWS):
        drawn = one()
        if fits(drawn):
            return drawn
    raise ValueError(f"nothing fits among {MOST_DRAWS} draws")
