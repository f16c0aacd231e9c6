"""Bodies in the physics stand where the scenario puts them, and stay there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from tandem.sim.physics import Physics
from tandem.sim.scenario import load_scenario
from tandem.sim.world import World, spawn
from tandem.skills.site import load


@pytest.fixture
def world() -> Iterator[World]:
    physics = Physics()
    yield spawn(physics, load("lab"), load_scenario("Demo"))
    physics.close()


def test_items_stay_where_they_were_put(world: World) -> None:
    before = {name: world.pose(name).position for name in world.movable()}
    world.settle(least=250)
    for name in world.movable():
        assert world.pose(name).position == pytest.approx(before[name], abs=0.002)


def test_a_body_that_is_put_again_is_moved(world: World) -> None:
    body = world.bodies["mug"]
    moved = body.pose.model_copy(update={"position": (0.7, 0.3, 0.77)})
    revision = world.revision
    world.put(replace(body, pose=moved))
    assert world.pose("mug").position == pytest.approx((0.7, 0.3, 0.77))
    assert world.revision > revision


def test_a_removed_body_is_gone(world: World) -> None:
    world.remove("mug")
    assert "mug" not in world.movable()
    with pytest.raises(KeyError):
        world.pose("mug")


def test_furniture_does_not_move(world: World) -> None:
    assert not [name for name in world.movable() if "." in name]


def test_what_rests_falls_when_its_support_is_taken_away(world: World) -> None:
    tin = world.bodies["tin"]
    x, y, z = tin.pose.position
    world.put(replace(world.bodies["mug"], pose=tin.pose.model_copy(update={"position": (x, y, z + 0.121)})))
    world.settle(least=900, most=900)
    resting = world.pose("mug").position
    assert resting[2] == pytest.approx(z + 0.12, abs=0.002)
    world.physics.step(300)
    assert world.pose("mug").position == pytest.approx(resting, abs=1e-4)
    world.remove("tin")
    world.physics.step(150)
    assert world.pose("mug").position[2] == pytest.approx(z - 0.02, abs=0.002)
