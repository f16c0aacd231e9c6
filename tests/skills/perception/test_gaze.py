"""The gaze: which of some views of a table is worth turning to."""

from __future__ import annotations

import math

import pytest

from tandem.skills import site
from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.perception.gaze import AGAIN, GAIN, HIDDEN, LITTLE, Gaze, View
from tandem.skills.ports.pose import Pose
from tests.skills.perception.stage import DESCRIPTION, URDF
from tests.skills.world.facts import tag

TABLE = [box_in_map(box) for each in site.load("bimanual").furniture for box in each.boxes]
CHAIN = Chain.from_urdf(URDF, "base", "optical")
SIZE = 0.056


def view(pan: float, tilt: float = -0.7) -> View:
    return (pan, tilt), CHAIN.pose({"pan": pan, "tilt": tilt})


AHEAD = view(0.0)
VIEWS = [view(0.1 * step, tilt) for step in range(-9, 10) for tilt in (-0.5, -0.7, -0.9)]


def watching(*tags: Pose, at: float = 0.0) -> Gaze:
    gaze = Gaze(DESCRIPTION.camera, TABLE)
    for item, each in enumerate(tags):
        gaze.see(item, each, SIZE, at)
    gaze.look(AHEAD[1], (), at)
    return gaze


def test_what_is_well_in_view_needs_no_other_view() -> None:
    assert not watching(tag(0.75, 0.1), tag(0.75, -0.1)).lacks(AHEAD[1], 0.0)


def test_an_item_that_is_seen_at_the_edge_is_turned_to_with_the_other_one_kept_in_view() -> None:
    gaze = watching(tag(0.75, 0.0), tag(0.75, -0.42))
    assert gaze.lacks(AHEAD[1], 0.0)
    gain, head = gaze.best(VIEWS, AHEAD, 0.0)
    assert gain > GAIN
    assert head[0] < 0.0
    assert not gaze.lacks(view(*head)[1], 0.0)


def test_items_that_no_view_shows_together_are_looked_at_by_turns() -> None:
    gaze, here, turns = watching(tag(0.6, 0.5), tag(0.6, -0.5)), view(0.7), []
    for step in range(40):
        now = 0.2 * step
        gaze.look(here[1], (), now)
        gain, head = gaze.best(VIEWS, here, now)
        if gain > GAIN:
            turns.append(math.copysign(1.0, head[0]))
            here = view(*head)
    assert turns[:4] in ([-1.0, 1.0, -1.0, 1.0], [1.0, -1.0, 1.0, -1.0])
    assert len(turns) <= 12


def test_an_item_that_is_gone_is_looked_for_where_the_picture_does_not_reach() -> None:
    gaze = watching(tag(0.75, -0.35))
    gaze.look(AHEAD[1], (0,), 0.2)
    gain, head = gaze.best(VIEWS, AHEAD, 0.2)
    assert gain > GAIN
    assert head[0] < -0.1


def test_a_view_that_is_worth_nothing_is_left_for_little() -> None:
    gaze = watching(tag(0.75, 0.0))
    assert gaze.clearly(AHEAD[1], 0.2) == GAIN, "it shows the item"
    gaze.look(AHEAD[1], (0,), 0.2)
    assert gaze.clearly(AHEAD[1], 0.2) == pytest.approx(LITTLE, abs=0.02), (
        "it has just been looked at in vain"
    )


def test_where_it_was_just_looked_for_in_vain_is_not_looked_at_again_for_a_while() -> None:
    gaze = watching(tag(0.75, 0.0))
    for each in VIEWS:
        gaze.look(each[1], (0,), 0.2)
    aside = view(0.9)[1]
    assert not gaze.lacks(aside, 0.3)
    assert gaze.lacks(aside, 0.2 + AGAIN)


@pytest.mark.parametrize(("seconds", "looks"), [(HIDDEN, False), (HIDDEN + 4.0, True)])
def test_a_hidden_item_is_looked_for_elsewhere_only_after_long(seconds: float, *, looks: bool) -> None:
    gaze = watching(tag(0.75, 0.0))
    gaze.look(AHEAD[1], (), seconds)
    assert gaze.lacks(AHEAD[1], seconds) is looks


def test_an_item_in_a_hand_is_followed_no_more() -> None:
    gaze = watching(tag(0.75, 0.0), tag(0.75, -0.6))
    gaze.keep((0,))
    assert not gaze.lacks(AHEAD[1], 9.0)
