"""A scene as data: every body of the room with its shape and place, made from a site and a scenario.

Both the physics (``sim.world``) and the picture of it (``sim.twin``) are built from these, so that what is
seen is what collides.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from sim.faults import DepotTaken, Fault, ItemMoves, ObstacleAppears, Place
from sim.scenario import Scenario, ScenarioError
from sim.things import FLOOR, BoxShape, CylinderShape, Obstacle, TrueItem
from skills.ports.geometry import Pose, about
from skills.ports.site import Site, SiteBox
from skills.ports.world import Box

GAP: Final = 0.0005
"""Metres above its support at which a body is made, so that nothing starts inside something else."""

FURNITURE_FRICTION: Final = 0.6
ITEM_COLOUR: Final = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class Label:
    """The tag on a body's upright sides: its number and the edge in metres of its black square."""

    tag: int
    tag_size: float


@dataclass(frozen=True)
class SceneBody:
    """One body: ``pose`` is that of its centre in map; a mass of 0 makes it immovable."""

    name: str
    shape: BoxShape | CylinderShape
    pose: Pose
    mass: float
    friction: float
    colour: tuple[float, float, float]
    label: Label | None = None
    stiffness: float | None = None


def item_name(tag: int) -> str:
    """Return the name of an item's body."""
    return f"item_{tag}"


def build_scene(site: Site, scenario: Scenario, *, source: str = "scenario") -> tuple[SceneBody, ...]:
    """Return the bodies: furniture, items, obstacles, in this order.

    Raises:
        ScenarioError: when the scenario doesn't fit the site; ``source`` is the file that is named.
    """
    problems = _problems(site, scenario, source)
    if problems:
        raise ScenarioError("\n".join(problems))
    return (
        *furniture_bodies(site),
        *(item_body(site, item) for item in scenario.items),
        *(obstacle_body(site, obstacle) for obstacle in scenario.obstacles),
    )


def furniture_bodies(site: Site) -> tuple[SceneBody, ...]:
    """Return each box of the site's furniture, named ``table.0``, ``table.1``, ..."""
    return tuple(
        SceneBody(
            name=f"{piece.name}.{index}",
            shape=BoxShape(size=box.size),
            pose=box.box().pose,
            mass=0.0,
            friction=FURNITURE_FRICTION,
            colour=piece.colour,
        )
        for piece in site.furniture
        for index, box in enumerate(piece.boxes)
    )


def item_body(site: Site, item: TrueItem) -> SceneBody:
    """Return a tagged item where the scenario puts it.

    Raises:
        KeyError: when the site knows no such item, or nothing is there to stand on.
    """
    known = site.item(item.tag)
    if known is None:
        raise KeyError(f"site {site.name} knows no item {item.tag}")
    z = support_height(site, item.support, item.x, item.y) + known.size[2] / 2 + GAP
    return SceneBody(
        name=item_name(item.tag),
        shape=BoxShape(size=known.size),
        pose=Pose(position=(item.x, item.y, z), orientation=about((0, 0, 1), item.yaw)),
        mass=item.mass,
        friction=item.friction,
        colour=ITEM_COLOUR,
        label=Label(item.tag, known.tag_size),
        stiffness=item.stiffness,
    )


def obstacle_body(site: Site, obstacle: Obstacle) -> SceneBody:
    """Return an untagged thing where the scenario puts it.

    Raises:
        KeyError: when nothing is there to stand on.
    """
    shape = obstacle.shape
    height = shape.size[2] if isinstance(shape, BoxShape) else shape.height
    z = support_height(site, obstacle.support, obstacle.x, obstacle.y) + height / 2 + GAP
    return SceneBody(
        name=obstacle.name,
        shape=shape,
        pose=Pose(position=(obstacle.x, obstacle.y, z), orientation=about((0, 0, 1), obstacle.yaw)),
        mass=obstacle.mass,
        friction=obstacle.friction,
        colour=obstacle.colour,
    )


def support_height(site: Site, support: str, x: float, y: float) -> float:
    """Return the height in metres of the top of a piece of furniture at a point of the map; the floor's is 0.

    Raises:
        KeyError: when there is no such furniture, or it has nothing below the point.
    """
    if support == FLOOR:
        return 0.0
    names = [piece.name for piece in site.furniture]
    if support not in names:
        raise KeyError(f"no furniture '{support}' at site {site.name}; there are {', '.join(names)}, {FLOOR}")
    boxes = site.furniture[names.index(support)].boxes
    tops = [box.centre[2] + box.size[2] / 2 for box in boxes if _covers(box, x, y)]
    if not tops:
        raise KeyError(f"({x:g}, {y:g}) is not above {support}")
    return max(tops)


def _covers(box: SiteBox, x: float, y: float) -> bool:
    dx, dy = x - box.centre[0], y - box.centre[1]
    c, s = math.cos(box.yaw), math.sin(box.yaw)
    return abs(c * dx + s * dy) <= box.size[0] / 2 and abs(c * dy - s * dx) <= box.size[1] / 2


def _problems(site: Site, scenario: Scenario, source: str) -> list[str]:
    """Return a line for each thing in the scenario that the site has no place or no name for."""
    found: list[str] = []
    taken = {item_name(item.tag) for item in scenario.items}
    for index, item in enumerate(scenario.items):
        if site.item(item.tag) is None:
            known = ", ".join(str(each.item) for each in site.items)
            found.append(f"{source}: items.{index}.tag: one of {known} was expected, found {item.tag}")
        found += _support_problem(site, item, f"{source}: items.{index}")
    for index, obstacle in enumerate(scenario.obstacles):
        if obstacle.name in taken:
            found.append(f"{source}: obstacles.{index}.name: {obstacle.name} is an item's name")
        found += _support_problem(site, obstacle, f"{source}: obstacles.{index}")
    for index, surface in enumerate(scenario.surfaces):
        for corner, (x, y) in (("lower", surface.lower), ("upper", surface.upper)):
            try:
                support_height(site, surface.support, x, y)
            except KeyError as error:
                found.append(f"{source}: surfaces.{index}.{corner}: {error.args[0]}")
    found += fault_problems(site, scenario.faults, source)
    x_min, y_min, x_max, y_max = site.bounds
    if not (x_min < scenario.start.x < x_max and y_min < scenario.start.y < y_max):
        found.append(f"{source}: start: a place in the room was expected, {site.bounds} (x, y from; x, y to)")
    return found


def fault_problems(site: Site, faults: Iterable[Fault], source: str) -> list[str]:
    """Return a line for each thing in the faults that the site has no place or no name for."""
    found = []
    for index, fault in enumerate(faults):
        where = f"{source}: faults.{index}"
        tag = getattr(fault, "tag", None)
        if tag is not None and site.item(tag) is None:
            known = ", ".join(str(each.item) for each in site.items)
            found.append(f"{where}.tag: one of {known} was expected, found {tag}")
        if isinstance(fault, DepotTaken):
            found += _slot_problem(site, fault, where)
        elif isinstance(fault, ObstacleAppears) and fault.x is not None and fault.y is not None:
            found += _support_problem(site, Place(support=fault.support, x=fault.x, y=fault.y), where)
        elif isinstance(fault, ItemMoves) and fault.to is not None:
            found += _support_problem(site, fault.to, f"{where}.to")
    return found


def _slot_problem(site: Site, fault: DepotTaken, where: str) -> list[str]:
    depot = site.depot(fault.depot)
    if depot is None:
        known = ", ".join(each.name for each in site.depots)
        return [f"{where}.depot: one of {known} was expected, found {fault.depot}"]
    if fault.slot >= len(depot.slots):
        return [f"{where}.slot: 0 to {len(depot.slots) - 1} was expected, found {fault.slot}"]
    return []


def _support_problem(site: Site, thing: TrueItem | Obstacle | Place, where: str) -> list[str]:
    try:
        support_height(site, thing.support, thing.x, thing.y)
    except KeyError as error:
        return [f"{where}.support: {error.args[0]}"]
    return []


def as_box(body: SceneBody) -> Box:
    """Return the box around a body, with the body's pose."""
    if isinstance(body.shape, CylinderShape):
        edge = 2 * body.shape.radius
        return Box(size=(edge, edge, body.shape.height), pose=body.pose)
    return Box(size=body.shape.size, pose=body.pose)
