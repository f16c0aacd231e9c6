"""A scene as data: every body of the room with its shape and place, made from a site and a scenario.

Both the physics (``sim.world``) and the picture of it (``sim.render_world``) are built from these, so that
what is seen is what collides.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Final

from tandem.sim import placing
from tandem.sim.faults import DepotTaken, Fault, ItemMoves, ObstacleAppears, Place
from tandem.sim.people import path_problems
from tandem.sim.robots import registry
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.starts import ALONE, RobotStart
from tandem.sim.things import FLOOR, BoxShape, CylinderShape, Obstacle, TrueItem, shape_of
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import about
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import extents, name_of, solid
from tandem.skills.ports.site import Site, SiteBox
from tandem.skills.ports.sources import Source
from tandem.skills.ports.world import Box

GAP: Final = 0.0005
"""Metres above its support at which a body is made, so that nothing starts inside something else."""

FURNITURE_FRICTION: Final = 0.6
"""Chosen as wood."""
ITEM_COLOUR: Final = (1.0, 1.0, 1.0)
"""White, which leaves the colours of a texture as they are."""


@dataclass(frozen=True)
class Label:
    """What makes a body an item: its number, and the tag on its four upright sides."""

    item: int
    tag_size: float | None
    """Edge in metres of the tag's black square; none: it bears no tag."""


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


def item_name(item: int) -> str:
    """Return the name of an item's body."""
    return f"item_{item}"


def build_scene(site: Site, scenario: Scenario, source: Source | None = None) -> tuple[SceneBody, ...]:
    """Return the bodies: furniture, items, obstacles, in this order.

    Raises:
        ScenarioError: when the scenario doesn't fit the site, or two things would be in one place; ``source``
            is the file that is named; without one, the scenario.
    """
    source = source or Source(scenario.name)
    if problems := _problems(site, scenario, source):
        raise ScenarioError("\n".join(problems))
    furniture = furniture_bodies(site)
    items = tuple(item_body(site, item) for item in scenario.items)
    obstacles = tuple(obstacle_body(site, obstacle) for obstacle in scenario.obstacles)
    robots = tuple(
        placing.Placed(
            where=scenario.path_of(index, "start"),
            words="the robot" if each.name == ALONE else each.name,
            start=each.start,
            robot=registry.robot_named(each.robot),
        )
        for index, each in enumerate(scenario.placed)
    )
    clashes = [
        *placing.clashes(furniture, items, obstacles, robots),
        *path_problems(scenario.people, site.bounds, (*furniture, *items, *obstacles), robots),
    ]
    if told := [f"{source.at(where)}: {reason}" for where, reason in clashes]:
        raise ScenarioError("\n".join(told))
    return (*furniture, *items, *obstacles)


def furniture_bodies(site: Site) -> tuple[SceneBody, ...]:
    """Return each box of the site's furniture, named ``table.0``, ``table.1``, ..."""
    return tuple(
        SceneBody(
            name=f"{piece.name}.{index}",
            shape=BoxShape(size=box.size),
            pose=box_in_map(box).pose,
            mass=0.0,
            friction=FURNITURE_FRICTION,
            colour=piece.colour,
        )
        for piece in site.furniture
        for index, box in enumerate(piece.boxes)
    )


def item_body(site: Site, item: TrueItem) -> SceneBody:
    """Return an item where the scenario puts it.

    Raises:
        KeyError: when the site knows no such item, or nothing is there to stand on.
    """
    known = site.item(item.item)
    if known is None:
        raise KeyError(f"site {site.name} knows no item {item.item}")
    z = support_height(site, item.support, item.x, item.y) + known.size[2] / 2 + GAP
    return SceneBody(
        name=item_name(item.item),
        shape=shape_of(solid(known)),
        pose=Pose(position=(item.x, item.y, z), orientation=about((0, 0, 1), item.yaw)),
        mass=item.mass,
        friction=item.friction,
        colour=ITEM_COLOUR if known.colour is None or known.tag_size is not None else known.colour,
        label=Label(item.item, known.tag_size),
        stiffness=item.stiffness,
    )


def obstacle_body(site: Site, obstacle: Obstacle) -> SceneBody:
    """Return a thing that is no item where the scenario puts it.

    Raises:
        KeyError: when nothing is there to stand on.
    """
    shape = obstacle.shape
    height = extents(shape.solid)[2]
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


def _problems(site: Site, scenario: Scenario, source: Source) -> list[str]:
    """Return a line for each thing in the scenario that the site has no place or no name for."""
    found: list[str] = []
    for index, each in enumerate(scenario.placed):
        found += _robot_problems(site, each, source, partial(scenario.path_of, index))
    taken = {item_name(item.item) for item in scenario.items}
    for index, item in enumerate(scenario.items):
        if site.item(item.item) is None:
            where = source.at(f"items.{index}.item")
            found.append(f"{where}: expected one of {site.item_words()}, found {item.item}")
        found += _support_problem(site, item, f"items.{index}", source)
    for index, obstacle in enumerate(scenario.obstacles):
        if obstacle.name in taken:
            where = source.at(f"obstacles.{index}.name")
            found.append(f"{where}: {obstacle.name} is an item's name")
        found += _support_problem(site, obstacle, f"obstacles.{index}", source)
    for index, surface in enumerate(scenario.surfaces):
        for corner, (x, y) in (("lower", surface.lower), ("upper", surface.upper)):
            try:
                support_height(site, surface.support, x, y)
            except KeyError as error:
                found.append(f"{source.at(f'surfaces.{index}.{corner}')}: {error.args[0]}")
    found += _name_problems(scenario, source)
    found += fault_problems(site, scenario.faults, source, tuple(each.name for each in scenario.placed))
    return found


def _name_problems(scenario: Scenario, source: Source) -> list[str]:
    """Return a line for each person who is called as something else is."""
    things = {
        *(item_name(each.item) for each in scenario.items),
        *(each.name for each in scenario.obstacles),
        *(each.name for each in scenario.placed),
    }
    return [
        f"{source.at(f'people.{index}.name')}: {person.name} is the name of something else"
        for index, person in enumerate(scenario.people)
        if person.name in things
    ]


def _robot_problems(site: Site, each: RobotStart, source: Source, path: Callable[[str], str]) -> list[str]:
    found = []
    if each.robot not in registry.names():
        known = ", ".join(registry.names())
        found.append(f"{source.at(path('robot'))}: expected one of {known}, found {each.robot}")
    x_min, y_min, x_max, y_max = site.bounds
    if not (x_min < each.start.x < x_max and y_min < each.start.y < y_max):
        expected = f"expected a place in the room, {site.bounds} (x, y from; x, y to)"
        found.append(f"{source.at(path('start'))}: {expected}")
    return found


def fault_problems(site: Site, faults: Iterable[Fault], source: Source, robots: tuple[str, ...]) -> list[str]:
    """Return a line for each thing in the faults that the site has no place or no name for.

    Args:
        site: places and items.
        faults: checked one by one.
        source: the file that is named.
        robots: names of those that a fault may be meant for.
    """
    found = []
    for index, fault in enumerate(faults):
        where = f"faults.{index}"
        if fault.robot is not None and fault.robot not in robots:
            expected = f"expected one of {', '.join(robots)}, found {fault.robot}"
            found.append(f"{source.at(f'{where}.robot')}: {expected}")
        item = getattr(fault, "item", None)
        if item is not None and site.item(item) is None:
            found.append(f"{source.at(f'{where}.item')}: expected one of {site.item_words()}, found {item}")
        if isinstance(fault, DepotTaken):
            found += _slot_problem(site, fault, where, source)
        elif isinstance(fault, ObstacleAppears) and fault.x is not None and fault.y is not None:
            place = Place(support=fault.support, x=fault.x, y=fault.y)
            made = Obstacle(**fault.model_dump(include=set(Obstacle.model_fields)))
            found += _support_problem(site, place, where, source) or _furniture_problem(
                site, obstacle_body(site, made), where, source
            )
        elif isinstance(fault, ItemMoves) and fault.to is not None:
            found += _place_problem(site, fault, f"{where}.to", source)
    return found


def _place_problem(site: Site, fault: ItemMoves, where: str, source: Source) -> list[str]:
    assert fault.to is not None
    found = _support_problem(site, fault.to, where, source)
    if found or fault.item is None or site.item(fault.item) is None:
        return found
    return _furniture_problem(
        site, item_body(site, TrueItem(item=fault.item, **fault.to.model_dump())), where, source
    )


def _furniture_problem(site: Site, body: SceneBody, where: str, source: Source) -> list[str]:
    """Return what a fault puts into furniture; what else is there then, the physics tells."""
    other = placing.inside(body, furniture_bodies(site))
    return [f"{source.at(where)}: {body.name} would be in one place with {other}"] if other else []


def _slot_problem(site: Site, fault: DepotTaken, where: str, source: Source) -> list[str]:
    depot = site.depot(fault.depot)
    if depot is None:
        known = ", ".join(each.name for each in site.depots)
        return [f"{source.at(f'{where}.depot')}: expected one of {known}, found {fault.depot}"]
    if fault.slot >= len(depot.slots):
        expected = f"expected 0 to {len(depot.slots) - 1}, found {fault.slot}"
        return [f"{source.at(f'{where}.slot')}: {expected}"]
    return []


def _support_problem(site: Site, thing: TrueItem | Obstacle | Place, where: str, source: Source) -> list[str]:
    try:
        support_height(site, thing.support, thing.x, thing.y)
    except KeyError as error:
        return [f"{source.at(f'{where}.support')}: {error.args[0]}"]
    return []


def as_box(body: SceneBody) -> Box:
    """Return the box around a body, with the body's pose; an item's with its shape.

    What has no tag is told as a box whatever its shape, as perception measures it.
    """
    shape = body.shape.solid
    return Box(size=extents(shape), pose=body.pose, shape="box" if body.label is None else name_of(shape))
