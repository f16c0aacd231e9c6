"""Which sightings are averaged, and which are of two things or of one that was moved."""

from __future__ import annotations

import math

import pytest

from tandem.skills.perception.merge import SYSTEMATIC, merge
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.world import Sighting
from tests.skills.world.facts import at, tag

SIZE = (0.06, 0.06, 0.06)
SIZES = {29: SIZE, 42: SIZE}


def seen(
    tag_in_map: Pose, seconds: float, *, sigma: float = 0.001, quality: float = 0.8, item: int = 29
) -> Sighting:
    return Sighting(
        item=item,
        stamp=at(seconds),
        tag_in_map=tag_in_map,
        tag_in_base=IDENTITY,
        tag_in_camera=IDENTITY,
        distance=1.0,
        quality=quality,
        position_sigma=sigma,
    )


def xs(merged: tuple[Sighting, ...]) -> list[float]:
    return sorted(each.tag_in_map.position[0] for each in merged)


def test_pictures_of_one_resting_thing_are_averaged() -> None:
    (one,) = merge([seen(tag(0.600, 0.5), 1), seen(tag(0.602, 0.5), 2), seen(tag(0.601, 0.5), 3)], SIZES)
    assert one.tag_in_map.position[0] == pytest.approx(0.601)
    assert one.stamp == at(3)


def test_two_of_one_number_in_each_picture_are_two() -> None:
    """The phantom: halfway between, and more certain than either."""
    pictures = [seen(tag(x, 0.5), seconds) for seconds in (1, 2, 3) for x in (0.5, 0.8)]
    merged = merge(pictures, SIZES)
    assert xs(merged) == pytest.approx([0.5, 0.8])


def test_two_side_by_side_are_two_however_badly_they_are_seen() -> None:
    """Their faces look the same way in one picture: no thing has two such faces."""
    pictures = [seen(tag(0.5, y), seconds, sigma=0.05) for seconds in (1, 2) for y in (0.50, 0.56)]
    merged = merge(pictures, SIZES)
    assert sorted(each.tag_in_map.position[1] for each in merged) == pytest.approx([0.50, 0.56])


def test_two_faces_of_one_thing_are_one() -> None:
    front, side = tag(0.60, 0.5, math.pi), tag(0.63, 0.47, -math.pi / 2)
    (one,) = merge([seen(front, 1, quality=0.9), seen(side, 1, quality=0.4)], SIZES)
    assert one.tag_in_map == front


def test_two_faces_of_two_things_are_two() -> None:
    front, other_side = tag(0.60, 0.5, math.pi), tag(0.83, 0.47, -math.pi / 2)
    assert len(merge([seen(front, 1), seen(other_side, 1)], SIZES)) == 2


@pytest.mark.parametrize("by", [0.03, 0.2])
def test_of_a_thing_that_is_moved_meanwhile_the_last_place_counts(by: float) -> None:
    before = [seen(tag(0.5, 0.5), 1, sigma=0.002), seen(tag(0.5, 0.5), 2, sigma=0.002)]
    (one,) = merge([*before, seen(tag(0.5 + by, 0.5), 3, sigma=0.002)], SIZES)
    assert one.tag_in_map.position[0] == pytest.approx(0.5 + by)
    assert one.position_sigma == pytest.approx(0.002)


def test_of_a_thing_that_is_pushed_all_the_time_the_last_place_counts() -> None:
    (one,) = merge([seen(tag(0.5 + 0.03 * second, 0.5), second) for second in range(5)], SIZES)
    assert one.tag_in_map.position[0] == pytest.approx(0.62)


def test_one_that_is_read_in_some_pictures_only_is_there_all_the_time() -> None:
    """A tag at the edge of what can be read comes and goes; it was not moved to the other one and back."""
    pictures = [seen(tag(0.5, 0.5), 1), seen(tag(0.8, 0.5), 2), seen(tag(0.5, 0.5), 3)]
    assert xs(merge(pictures, SIZES)) == pytest.approx([0.5, 0.8])


@pytest.mark.parametrize(("sigma", "averaged"), [(0.008, True), (0.006, False)])
def test_the_gate_grows_with_the_sigmas(sigma: float, *, averaged: bool) -> None:
    """8 mm each: 4.03 times 8 mm times root (2 / 3) is 26.3 mm for the distance along each axis together."""
    first, second = tag(0.5, 0.5), tag(0.526, 0.5)
    pictures = [seen(first, 1, sigma=sigma), seen(second, 2, sigma=sigma), seen(first, 3, sigma=sigma)]
    (one,) = merge(pictures, SIZES)
    assert one.tag_in_map.position[0] == pytest.approx(0.5087 if averaged else 0.5, abs=1e-4)


def test_where_no_two_have_room_there_is_one() -> None:
    """A campaign saw: two faces of a cube gave middles 26 mm apart, and it was refused as ambiguous."""
    front, side = tag(0.60, 0.5, math.pi), tag(0.656, 0.47, -math.pi / 2)
    (one,) = merge([seen(front, 1, quality=0.9), seen(side, 1, quality=0.3)], SIZES)
    assert one.tag_in_map == front


def test_what_differs_more_than_its_sigmas_say_is_no_better_known_for_it() -> None:
    apart = 0.8 * SYSTEMATIC
    (one,) = merge([seen(tag(0.5, 0.5), 1), seen(tag(0.5 + apart, 0.5), 2)], SIZES)
    assert one.position_sigma > apart / 4


def test_items_are_told_by_number_and_each_number_best_first() -> None:
    pictures = [
        seen(tag(0.5, 0.1), 1, item=42),
        seen(tag(0.5, 0.5), 1, quality=0.3),
        seen(tag(0.8, 0.5), 1, quality=0.9),
    ]
    assert [(each.item, each.quality) for each in merge(pictures, SIZES)] == [(29, 0.9), (29, 0.3), (42, 0.8)]
