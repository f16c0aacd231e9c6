"""Two things of one number: believed as two, told as two, kept clear of, and one of them selected."""

from __future__ import annotations

import pytest

from tandem.skills import site
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Clutter, ItemFact
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.doubles import A_LOOK, MOST, matched
from tandem.skills.world.item_facts import item_box
from tests.skills.world.facts import at, sighting, tag

LAB = site.load("lab")


def xs(facts: tuple[ItemFact, ...]) -> list[float]:
    return [round(fact.tag_in_map.position[0], 3) for fact in facts]


def two(*places: float) -> Beliefs:
    beliefs = Beliefs(LAB)
    assert beliefs.see_together([sighting(29, tag(x, 0.5), 1.0) for x in places])
    return beliefs


def test_two_of_a_number_are_told_as_two() -> None:
    state = two(0.6, 0.9).state(at(1))
    assert xs(state.those(29)) == [0.6, 0.9]
    assert [fact.item for fact in state.items] == [29]
    assert xs(state.doubles) == [0.9]


def test_arms_keep_clear_of_the_double_and_none_takes_it_for_the_item() -> None:
    scene = two(0.6, 0.9).scene(at(1)).objects
    (item,) = [each for each in scene if each.item == 29]
    (double,) = [each for each in scene if each.name == "item_29_double_1"]
    assert item.box.pose.position[0] == pytest.approx(0.63)
    assert (double.kind, double.item) == ("clutter", None)
    assert double.box.pose.position[0] == pytest.approx(0.93)


def test_each_is_followed_by_the_nearest_sighting() -> None:
    beliefs = two(0.6, 0.9)
    beliefs.see_together([sighting(29, tag(0.91, 0.5), 2.0), sighting(29, tag(0.61, 0.5), 2.0)])
    assert xs(beliefs.those(29)) == [0.61, 0.91]


def test_one_alone_in_view_moves_nothing_else() -> None:
    beliefs = two(0.6, 0.9)
    beliefs.see_together([sighting(29, tag(0.91, 0.5), 2.0)])
    assert xs(beliefs.those(29)) == [0.6, 0.91]


def test_one_thing_that_is_elsewhere_has_moved() -> None:
    beliefs = two(0.6)
    beliefs.see_together([sighting(29, tag(0.9, 0.5), 2.0)])
    assert xs(beliefs.those(29)) == [0.9]


def test_the_one_nearest_to_a_point_is_selected_and_stays_it() -> None:
    beliefs = two(0.6, 0.9)
    beliefs.select(29, (1.0, 0.5))
    assert xs(beliefs.those(29)) == [0.9, 0.6]
    beliefs.see_together([sighting(29, tag(0.6, 0.5), 2.0), sighting(29, tag(0.9, 0.5), 2.0)])
    assert xs(beliefs.those(29)) == [0.9, 0.6]


def test_when_the_item_is_gone_its_double_is_the_item() -> None:
    beliefs = two(0.6, 0.9)
    assert beliefs.miss(29, at(2))
    assert xs(beliefs.those(29)) == [0.9]
    assert beliefs.state(at(2)).doubles == ()


def test_what_is_forgotten_is_forgotten_with_its_doubles() -> None:
    beliefs = two(0.6, 0.9)
    assert beliefs.forget(29)
    assert beliefs.those(29) == ()


def test_in_a_hand_its_double_stays_where_it_is() -> None:
    beliefs = two(0.6, 0.9)
    beliefs.attach(29, "left", Pose(), at(2))
    assert not beliefs.see_together([sighting(29, tag(0.7, 0.5), 3.0)])
    assert xs(beliefs.state(at(3)).doubles) == [0.9]


@pytest.mark.parametrize(("after", "left"), [(A_LOOK - 1.0, [0.9]), (A_LOOK + 2.0, [])])
def test_a_double_that_a_look_shows_gone_is_forgotten(after: float, left: list[float]) -> None:
    """Not at once: the views of one look are told together, and each shows a part."""
    beliefs = two(0.6, 0.9)
    (double,) = beliefs.state(at(1)).doubles
    beliefs.look(Clutter(stamp=at(1.0 + after), boxes=(), view=(item_box(double.tag_in_map, double),)))
    assert xs(beliefs.state(at(1)).doubles) == left


def test_doubles_are_remembered_and_undone_with_an_edit() -> None:
    beliefs = two(0.6, 0.9)
    assert xs(Beliefs(LAB, beliefs.remembered(0.0)).those(29)) == [0.6, 0.9]
    before = beliefs.saved()
    beliefs.forget(29)
    beliefs.restore(before)
    assert xs(beliefs.those(29)) == [0.6, 0.9]


def test_there_are_not_more_than_can_be_checked() -> None:
    beliefs = two(*(0.4 + 0.1 * number for number in range(MOST + 3)))
    assert len(beliefs.state(at(1)).doubles) == MOST


def test_nearest_pairs_first_and_one_each() -> None:
    known, seen = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)], [(0.9, 0.0, 0.0), (0.6, 0.0, 0.0), (5.0, 0.0, 0.0)]
    assert matched(known, seen) == {0: 1, 1: 0}
