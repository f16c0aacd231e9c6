"""Drawing the starts of a campaign: another item, another place of it, another start of the robot.

Everything is uniform: the item among the scenario's, its place over the area of the declared surfaces, its
yaw, the robot's place over the free floor, its heading. A place is drawn again only for a collision, or where
no arm gets at it, and each such draw is told with its reason. The same generator gives the same draws.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

from tandem.sim.floor_plan import Plan, gap, plan_of
from tandem.sim.scenario import Scenario, ScenarioError, SpawnSurface
from tandem.sim.scene import SceneBody, build_scene, furniture_bodies, item_body, item_name
from tandem.sim.things import FLOOR, TrueItem
from tandem.skills.ports.pose import FloorPose

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from tandem.skills.ports.site import Site

FINGER_GAP: Final = 0.03
"""Metres left free on all sides of the drawn item: a finger with its pad is 2 cm thick."""

FLOOR_MARGIN: Final = 0.02
"""Metres between the robot's footprint at the start and what stands around."""

MOST_DRAWS: Final = 1000
"""After which there is taken to be no free place."""

NEIGHBOURHOOD: Final = 0.005
"""Metres by which a body must overlap the item in height to be in its way: what it stands on is not."""


@dataclass(frozen=True)
class Rejected:
    """A place that was drawn and not taken: which thing, where in map (m, rad), and why."""

    what: Literal["item", "start"]
    x: float
    y: float
    yaw: float
    reason: str
    unreachable: bool = False
    """Whether it was thrown away because no arm gets at the item there."""


OutOfReach = Callable[[Scenario, int], str | None]
"""Says in words why no arm gets at an item where a scenario has it; None when one does."""


def _anywhere(_: Scenario, __: int) -> str | None:
    """Take every place for reachable."""


@dataclass(frozen=True)
class Draw:
    """One start of a run: the changed ``scenario``, the item to be asked for, and the surface it is on.

    ``place`` and ``start`` are in the scenario too; ``rejected`` holds the draws before them, in order.
    """

    scenario: Scenario
    item: int
    surface: str
    place: TrueItem
    start: FloorPose
    rejected: tuple[Rejected, ...] = ()


def draw_fetch(
    site: Site,
    scenario: Scenario,
    rng: np.random.Generator,
    robot_radius: float,
    out_of_reach: OutOfReach = _anywhere,
) -> Draw:
    """Draw an item, its place and yaw, and the robot's start pose.

    Args:
        site: the furniture and the items' sizes.
        scenario: all else; the other items and the obstacles stay where it has them.
        rng: where the chance comes from; nothing else influences the draw.
        robot_radius: of the robot's footprint, metres.
        out_of_reach: judges places that are free.

    Raises:
        ScenarioError: when the scenario doesn't fit the site, has no items or no surface with an area, or no
            free place was found.
    """
    build_scene(site, scenario)
    if not scenario.items:
        raise ScenarioError(f"{scenario.name}: items: expected at least one to draw from")
    item = scenario.items[int(rng.integers(len(scenario.items)))]
    rejected: list[Rejected] = []
    surface, place = _draw_place(site, scenario, item, rng, rejected, out_of_reach=out_of_reach)
    start = _draw_start(site, scenario.with_item(place), rng, robot_radius, rejected)
    drawn = scenario.with_item(place).starting_at(start)
    return Draw(drawn, item.item, surface, place, start, tuple(rejected))


def _draw_place(
    site: Site,
    scenario: Scenario,
    item: TrueItem,
    rng: np.random.Generator,
    rejected: list[Rejected],
    *,
    out_of_reach: OutOfReach,
) -> tuple[str, TrueItem]:
    others = build_scene(site, scenario.without_item(item.item))
    areas = [_area(surface) for surface in scenario.surfaces]
    if not sum(areas) > 0.0:
        raise ScenarioError(f"{scenario.name}: surfaces: expected one with an area to put items on")
    shares = [area / sum(areas) for area in areas]
    for _ in range(MOST_DRAWS):
        surface = scenario.surfaces[int(rng.choice(len(shares), p=shares))]
        place = item.model_copy(
            update={
                "support": surface.support,
                "x": float(rng.uniform(surface.lower[0], surface.upper[0])),
                "y": float(rng.uniform(surface.lower[1], surface.upper[1])),
                "yaw": float(rng.uniform(-math.pi, math.pi)),
            }
        )
        reason, far = _why_not(site, place, others), None
        if reason is None:
            reason = far = out_of_reach(scenario.with_item(place), item.item)
        if reason is None:
            return surface.name, place
        words = f"item {item.item} {reason}"
        rejected.append(Rejected("item", place.x, place.y, place.yaw, words, unreachable=far is not None))
    raise ScenarioError(f"{scenario.name}: surfaces: no free place for item {item.item}")


def why_not(site: Site, scenario: Scenario, place: TrueItem) -> str | None:
    """Return why an item can't be drawn at a place of the scenario's surfaces, or None when it can."""
    inside = any(
        surface.support == place.support
        and surface.lower[0] <= place.x <= surface.upper[0]
        and surface.lower[1] <= place.y <= surface.upper[1]
        for surface in scenario.surfaces
    )
    if not inside:
        return "lies on no surface from which items are drawn"
    return _why_not(site, place, build_scene(site, scenario.without_item(place.item)))


def _why_not(site: Site, place: TrueItem, others: Sequence[SceneBody]) -> str | None:
    try:
        return _in_the_way(item_body(site, place), others)
    except KeyError as error:  # a surface may reach over a gap between two boxes of its support
        return str(error.args[0])


def _draw_start(
    site: Site, scenario: Scenario, rng: np.random.Generator, radius: float, rejected: list[Rejected]
) -> FloorPose:
    around = [(body.name, plan_of(body)) for body in _on_floor(site, scenario)]
    x_min, y_min, x_max, y_max = site.bounds
    for _ in range(MOST_DRAWS):
        x, y = float(rng.uniform(x_min, x_max)), float(rng.uniform(y_min, y_max))
        yaw = float(rng.uniform(-math.pi, math.pi))
        here = Plan(((x, y),), radius)
        near, free = min(((name, gap(here, plan)) for name, plan in around), key=lambda each: each[1])
        if free >= FLOOR_MARGIN:
            return FloorPose(x=x, y=y, yaw=yaw)
        rejected.append(Rejected("start", x, y, yaw, f"the robot {_too_near(near, free, FLOOR_MARGIN)}"))
    raise ScenarioError(f"{scenario.name}: no free place on the floor of {site.name} for the robot's start")


def _on_floor(site: Site, scenario: Scenario) -> list[SceneBody]:
    """Return the furniture, and what the scenario puts on the floor."""
    low = {obstacle.name for obstacle in scenario.obstacles if obstacle.support == FLOOR}
    low |= {item_name(item.item) for item in scenario.items if item.support == FLOOR}
    furniture = furniture_bodies(site)
    fixed = {body.name for body in furniture}
    return [body for body in build_scene(site, scenario) if body.name in fixed or body.name in low]


def _in_the_way(item: SceneBody, others: Sequence[SceneBody]) -> str | None:
    """Return what is too near to an item, or None."""
    plan, (bottom, top) = plan_of(item), _heights(item)
    for other in others:
        low, high = _heights(other)
        if min(top, high) - max(bottom, low) < NEIGHBOURHOOD:
            continue
        free = gap(plan, plan_of(other))
        if free < FINGER_GAP:
            return _too_near(other.name, free, FINGER_GAP)
    return None


def _too_near(name: str, free: float, needed: float) -> str:
    found = "touches it" if free <= 0.0 else f"is {free * 100:.1f} cm away"
    return f"needs {needed * 100:.0f} cm from {name} and {found}"


def _heights(body: SceneBody) -> tuple[float, float]:
    z = body.pose.position[2]
    height = body.shape.size[2] if body.shape.kind == "box" else body.shape.height
    return z - height / 2, z + height / 2


def _area(surface: SpawnSurface) -> float:
    return (surface.upper[0] - surface.lower[0]) * (surface.upper[1] - surface.lower[1])
