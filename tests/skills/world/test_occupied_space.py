"""Occupied space joins the planning scene."""

import pytest

from tandem.skills import site
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.occupancy import OccupancySetting
from tandem.skills.ports.world import OCCUPANCY, SCENE, Clutter
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.keeper import Keeper
from tests.fakes.occupied import occupied
from tests.skills.world.facts import at, cube, sighting, tag

LAB = site.load("lab")


def test_the_keeper_tells_a_new_scene_when_cells_change_and_only_then() -> None:
    bus, clocks = MemoryBus(), SteppedClocks("b")
    clocks.advance(1.0)
    keeper, scenes = Keeper(bus, clocks, LAB, ("left",)), Latest(bus, SCENE)
    keeper.step()
    first = scenes.refresh()
    versions = []
    for second, box in ((1.1, cube(1.0, 0.5)), (1.2, cube(1.0, 0.5)), (1.3, cube(1.2, 0.5))):
        OCCUPANCY.publish(bus, occupied(at(second), box))
        clocks.advance(0.1)
        keeper.step()
        told = scenes.refresh()
        assert told is not None
        assert told.occupied is not None
        versions.append(told.version)
    assert first is not None
    assert first.occupied is None
    assert versions == [first.version + 1, first.version + 1, first.version + 2]


@pytest.mark.parametrize(("replaces", "boxes"), [(True, 0), (False, 1)])
def test_cells_take_the_place_of_clutter_where_the_site_says_so(*, replaces: bool, boxes: int) -> None:
    wanted = LAB.model_copy(update={"occupancy": OccupancySetting(replaces_clutter=replaces)})
    beliefs = Beliefs(wanted)
    beliefs.look(Clutter(stamp=at(1.0), boxes=(cube(1.0, 0.5),)))
    assert sum(each.kind == "clutter" for each in beliefs.scene(at(1.0)).objects) == boxes


def test_an_item_takes_its_cells_out_of_the_scene_as_soon_as_it_is_known() -> None:
    beliefs, thing, other = Beliefs(LAB), cube(0.63, 0.5, 0.75, 0.06), cube(0.63, 0.9, 0.75, 0.06)
    beliefs.occupy(occupied(at(1.0), thing, other))
    before = beliefs.scene(at(1.0)).occupied
    beliefs.see(sighting(29, tag(0.6, 0.5), 1.0))
    after = beliefs.scene(at(1.0)).occupied
    assert before is not None
    assert after is not None
    assert list(after.numbers()) == list(occupied(at(1.0), other).numbers())
    assert len(after.numbers()) < len(before.numbers())


def test_after_a_new_boot_nothing_is_known_to_be_occupied() -> None:
    beliefs = Beliefs(LAB)
    beliefs.wake("b")
    beliefs.occupy(occupied(at(1.0), cube(1.0, 0.5)))
    beliefs.wake("c")
    assert beliefs.scene(at(0.0, "c")).occupied is None
