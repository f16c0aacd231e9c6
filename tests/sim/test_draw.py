"""Draws for campaigns: uniform, free of collisions, each rejection told, the same from the same seed."""

from __future__ import annotations

import math

import numpy as np
import pybullet
import pytest

from tandem.sim.draw import FINGER_GAP, FLOOR_MARGIN, Draw, draw_fetch
from tandem.sim.physics import Physics
from tandem.sim.robots.tiago_dual import FOOTPRINT_RADIUS
from tandem.sim.scenario import Scenario, ScenarioError, SpawnSurface, load_scenario
from tandem.sim.things import BoxShape, Obstacle
from tandem.sim.world import spawn
from tandem.skills.site import load

RADIUS = FOOTPRINT_RADIUS


def draws(count: int, seed: int = 1, scenario: Scenario | None = None) -> list[Draw]:
    rng, site = np.random.default_rng(seed), load("lab")
    return [draw_fetch(site, scenario or load_scenario("Demo"), rng, RADIUS) for _ in range(count)]


def test_the_same_seed_draws_the_same() -> None:
    assert draws(5, seed=3) == draws(5, seed=3)
    assert draws(5, seed=3) != draws(5, seed=4)


def test_the_drawn_item_alone_is_moved_and_keeps_what_it_is() -> None:
    demo = load_scenario("Demo")
    for drawn in draws(20):
        item = drawn.scenario.item(drawn.item)
        assert item == drawn.place
        assert item.mass == demo.item(drawn.item).mass
        assert drawn.scenario.start == drawn.start
        assert drawn.scenario.without_item(drawn.item).items == demo.without_item(drawn.item).items
        surface = next(each for each in demo.surfaces if each.name == drawn.surface)
        assert surface.lower[0] <= item.x <= surface.upper[0]
        assert surface.lower[1] <= item.y <= surface.upper[1]
        assert item.support == surface.support


def test_items_surfaces_and_headings_are_drawn_evenly() -> None:
    free = load_scenario("Demo").model_copy(update={"obstacles": ()})
    free = free.model_copy(update={"items": (free.item(29), free.item(11))})
    drawn = draws(400, scenario=free)
    assert sum(each.item == 29 for each in drawn) == pytest.approx(200, abs=50)
    # The table's 1.14 x 0.80 m2; the shelf's 1.04 x 0.28 m2.
    assert sum(each.surface == "shelf" for each in drawn) == pytest.approx(400 * 0.2912 / 1.2032, abs=36)
    assert np.mean([math.cos(each.start.yaw) for each in drawn]) == pytest.approx(0.0, abs=0.15)
    assert np.mean([math.sin(each.place.yaw) for each in drawn]) == pytest.approx(0.0, abs=0.15)


def test_items_are_drawn_over_all_of_each_top() -> None:
    """Once they were drawn in strips of 7 to 9 cm along the edges, where any arm gets at them."""
    site, demo = load("lab"), load_scenario("Demo")
    largest = max(math.hypot(item.size[0], item.size[1]) / 2 for item in site.items)
    for support in ("table", "shelf_board"):
        (top,) = [each for each in site.furniture if each.name == support]
        length, width, _ = top.boxes[0].size
        free = (length - 2 * largest) * (width - 2 * largest)
        strips = [each for each in demo.surfaces if each.support == support]
        drawn_from = sum((each.upper[0] - each.lower[0]) * (each.upper[1] - each.lower[1]) for each in strips)
        assert drawn_from == pytest.approx(free, rel=0.01)


def test_a_place_that_no_arm_gets_at_is_drawn_again_and_told() -> None:
    site, demo, rng = load("lab"), load_scenario("Demo"), np.random.default_rng(2)

    def west_only(scenario: Scenario, tag: int) -> str | None:
        return None if scenario.item(tag).x < 0.8 else "is out of reach"

    drawn = [draw_fetch(site, demo, rng, RADIUS, west_only) for _ in range(12)]
    assert all(each.place.x < 0.8 for each in drawn)
    far = [each for draw in drawn for each in draw.rejected if each.unreachable]
    assert far
    assert all("is out of reach" in each.reason for each in far)
    assert all("needs" in each.reason for draw in drawn for each in draw.rejected if not each.unreachable)


def test_physics_agrees_that_nothing_is_near() -> None:
    """Bullet's own closest points, of another body of the same outlines, are the independent answer."""
    site = load("lab")
    for drawn in draws(4, seed=8):
        physics = Physics()
        world = spawn(physics, site, drawn.scenario)
        item = world.id_of(f"item_{drawn.item}")
        shape = pybullet.createCollisionShape(
            pybullet.GEOM_CYLINDER, radius=RADIUS, height=2.0, physicsClientId=physics.client
        )
        robot = pybullet.createMultiBody(
            0.0, shape, -1, (drawn.start.x, drawn.start.y, 1.1), physicsClientId=physics.client
        )
        for name in world.bodies:
            other = world.id_of(name)
            for body, needed, skip in (
                (item, FINGER_GAP, drawn.place.support),
                (robot, FLOOR_MARGIN, "item"),
            ):
                if other == body or name.startswith(skip):
                    continue
                assert not pybullet.getClosestPoints(
                    body, other, needed - 0.001, physicsClientId=physics.client
                ), name
        physics.close()


def test_each_rejected_draw_is_told_with_its_reason() -> None:
    rejected = [each for drawn in draws(40) for each in drawn.rejected]
    reasons = [each.reason for each in rejected if each.what == "item"]
    assert any("needs 3 cm from" in reason for reason in reasons)
    starts = [each.reason for each in rejected if each.what == "start"]
    assert any("the robot needs 2 cm from table.0 and touches it" in reason for reason in starts)


def test_a_full_surface_is_an_error() -> None:
    surface = SpawnSurface(name="a", support="table", lower=(0.9, 0.4), upper=(1.1, 0.6), facing=0.0)
    block = Obstacle(name="b", shape=BoxShape(size=(0.4, 0.4, 0.1)), support="table", x=1.0, y=0.5)
    full = load_scenario("Defaults").model_copy(update={"surfaces": (surface,), "obstacles": (block,)})
    with pytest.raises(ScenarioError, match="no free place for item 29"):
        draws(1, scenario=full)


def test_without_surfaces_or_items_it_says_so() -> None:
    bare = load_scenario("Defaults").model_copy(update={"surfaces": ()})
    with pytest.raises(ScenarioError, match="Defaults: surfaces"):
        draws(1, scenario=bare)
    with pytest.raises(ScenarioError, match="Defaults: items"):
        draws(1, scenario=bare.model_copy(update={"items": ()}))
