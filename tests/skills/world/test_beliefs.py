"""What changes what is believed."""

import math

import pytest

from tandem.skills import site
from tandem.skills.geometry.poses import about, multiply, rotate
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box, Clutter, Placed
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.item_facts import item_box
from tests.skills.world.facts import at, cube, sighting, tag

LAB = site.load("lab")


@pytest.mark.parametrize(
    ("why", "moved", "seconds", "quality", "replaces"),
    [
        ("a little worse, and newer", 0.004, 2.0, 0.6, True),
        ("much worse, where it was, and soon", 0.004, 2.0, 0.2, False),
        ("much worse, but elsewhere", 0.05, 2.0, 0.2, True),
        ("much worse, but the old one has aged", 0.004, 20.0, 0.2, True),
        ("older", 0.05, 0.5, 0.9, False),
    ],
)
def test_which_sighting_replaces_which(
    *, why: str, moved: float, seconds: float, quality: float, replaces: bool
) -> None:
    beliefs = Beliefs(LAB)
    assert beliefs.see(sighting(29, tag(0.6, 0.5), 1.0, 0.8))
    changed = beliefs.see(sighting(29, tag(0.6 + moved, 0.5), seconds, quality))
    assert changed is replaces, why


def test_another_face_of_the_item_at_the_same_place_takes_over_its_tag() -> None:
    beliefs = Beliefs(LAB)
    beliefs.see(sighting(29, tag(0.60, 0.5, math.pi), 1.0))
    beliefs.see(sighting(29, tag(0.63, 0.47, -math.pi / 2), 2.0))
    fact = beliefs.item(29)
    assert fact is not None
    assert rotate(fact.tag_in_map.orientation, (0, 0, 1)) == pytest.approx((0, -1, 0), abs=1e-9)


def test_an_item_stands_as_an_obstacle_behind_its_tag() -> None:
    beliefs = Beliefs(LAB)
    beliefs.see(sighting(29, tag(0.6, 0.5), 1.0))
    (thing,) = [each for each in beliefs.scene(at(1)).objects if each.kind == "item"]
    assert thing.box.pose.position == pytest.approx((0.63, 0.5, 0.74))


def test_a_removed_item_is_no_obstacle_until_it_is_seen_again() -> None:
    beliefs = Beliefs(LAB)
    beliefs.see(sighting(29, tag(0.6, 0.5), 1.0))
    beliefs.remove(29)
    assert [each for each in beliefs.scene(at(1)).objects if each.kind == "item"] == []
    beliefs.see(sighting(29, tag(0.6, 0.5), 2.0))
    assert [each.item for each in beliefs.scene(at(2)).objects if each.kind == "item"] == [29]


def test_an_item_in_a_hand_is_told_in_the_tool_and_not_seen() -> None:
    beliefs = Beliefs(LAB)
    beliefs.see(sighting(29, tag(0.6, 0.5), 1.0))
    beliefs.attach(29, "left", Pose(position=(0.01, 0, 0)), at(2))
    assert not beliefs.see(sighting(29, tag(0.2, 0.1), 3.0))
    (thing,) = [each for each in beliefs.scene(at(3)).objects if each.kind == "item"]
    assert (thing.attached_to, thing.box.pose.position) == ("left", (0.01, 0, 0))


def test_putting_down_tells_where_and_losing_tells_nothing() -> None:
    beliefs = Beliefs(LAB)
    for down in (Pose(position=(-2.6, -1.1, 0.74)), None):
        beliefs.attach(29, "left", Pose(), at(2))
        beliefs.detach(29, down, None, at(3))
        assert beliefs.in_hand("left") is None
        fact = beliefs.item(29)
        assert (fact is None) is (down is None)
    beliefs.attach(29, "left", Pose(), at(2))
    beliefs.detach(29, Pose(position=(-2.6, -1.1, 0.74)), Placed(item=29, depot="depot", slot=0), at(3))
    assert [placed.item for placed in beliefs.state(at(4)).placed] == [29]


CUBE = Box(size=(0.06, 0.06, 0.06), pose=Pose())


def test_what_arms_must_not_hit_has_the_shape_of_the_item_on_the_table_and_in_the_hand() -> None:
    beliefs = Beliefs(site.load("pantry"))
    beliefs.see(sighting(20, tag(0.9, 0.0), 1.0))
    (standing,) = (each for each in beliefs.scene(at(1)).objects if each.item == 20)
    assert (standing.box.shape, standing.box.size) == ("cylinder", (0.066, 0.066, 0.09))
    beliefs.attach(20, "single", Pose(), at(2))
    (held,) = (each for each in beliefs.scene(at(3)).objects if each.item == 20)
    assert (held.attached_to, held.box.shape) == ("single", "cylinder")
    assert beliefs.state(at(3)).items[0].shape == "cylinder"


def test_a_cylinder_that_has_fallen_over_is_in_a_cube_that_holds_it() -> None:
    upright = tag(0.9, 0.0)
    rolled = Pose(
        position=upright.position, orientation=multiply(upright.orientation, about((0, 0, 1), math.pi / 2))
    )
    item = site.load("pantry").item(20)
    assert item is not None
    box = item_box(rolled, item)
    assert (box.shape, box.size) == ("box", (0.09, 0.09, 0.09))


def test_the_tag_of_an_item_is_on_its_x_side() -> None:
    item = item_box(tag(0.6, 0.5, 0.3), CUBE).pose
    back = tag_of_item(item, 0.06)
    assert back.position == pytest.approx(tag(0.6, 0.5, 0.3).position)
    assert rotate(back.orientation, (1, 2, 3)) == pytest.approx(
        rotate(tag(0.6, 0.5, 0.3).orientation, (1, 2, 3))
    )


@pytest.mark.parametrize(("x", "lies"), [(-2.58, True), (-2.2, False)])
def test_a_placed_item_that_is_seen_far_from_its_slot_is_placed_no_more(*, x: float, lies: bool) -> None:
    beliefs = Beliefs(LAB)
    beliefs.attach(29, "left", Pose(), at(1))
    beliefs.detach(29, Pose(position=(-2.61, -1.1, 0.74)), Placed(item=29, depot="depot", slot=0), at(2))
    beliefs.see(sighting(29, tag(x, -1.1, 0.0), 3.0, 0.9))
    assert (beliefs.slot_of(29) is not None) is lies


def clutter_places(beliefs: Beliefs) -> list[tuple[float, ...]]:
    return [each.box.pose.position[:2] for each in beliefs.scene(at(1)).objects if each.kind == "clutter"]


def test_clutter_is_forgotten_only_where_a_look_showed_its_place() -> None:
    beliefs = Beliefs(LAB)
    beliefs.look(Clutter(stamp=at(1), boxes=(cube(0.6, 0.5), cube(1.2, 0.5))))
    assert beliefs.look(Clutter(stamp=at(2), boxes=(), view=(cube(0.6, 0.5, edge=0.3),)))
    assert clutter_places(beliefs) == [(1.2, 0.5)]


def test_clutter_seen_again_is_not_doubled() -> None:
    beliefs = Beliefs(LAB)
    beliefs.look(Clutter(stamp=at(1), boxes=(cube(0.6, 0.5),)))
    assert not beliefs.look(Clutter(stamp=at(2), boxes=(cube(0.605, 0.5, edge=0.08),)))
    beliefs.look(Clutter(stamp=at(3), boxes=(cube(0.6, 0.5, edge=0.2),)))
    assert clutter_places(beliefs) == [(0.6, 0.5)]


def test_clutter_that_turns_out_to_be_an_item_goes() -> None:
    beliefs = Beliefs(LAB)
    beliefs.look(Clutter(stamp=at(1), boxes=(cube(0.63, 0.5, 0.74, 0.06),)))
    beliefs.see(sighting(29, tag(0.6, 0.5), 2.0))
    assert clutter_places(beliefs) == []
    beliefs.look(Clutter(stamp=at(3), boxes=(cube(0.63, 0.5, 0.74, 0.06),)))
    assert clutter_places(beliefs) == []


def test_an_item_that_is_proven_gone_is_forgotten_but_not_one_in_a_hand() -> None:
    beliefs = Beliefs(LAB)
    beliefs.see(sighting(29, tag(0.6, 0.5), 1.0))
    beliefs.see(sighting(42, tag(0.8, 0.5), 1.0))
    beliefs.attach(42, "left", Pose(), at(1.5))
    assert not beliefs.miss(29, at(0.5)), "an older picture proves nothing"
    assert beliefs.miss(29, at(2.0))
    assert not beliefs.miss(42, at(2.0))
    assert [fact.item for fact in beliefs.state(at(2)).items] == [42]
