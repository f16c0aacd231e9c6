"""What is seen to stand in furniture stands on it."""

import pytest

from tandem.skills import site
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.resting import on_top
from tests.skills.world.facts import sighting, tag

PICKING = site.load("picking")
ITEM = PICKING.items[0]
HEIGHT = ITEM.size[2]
BOARD = Box(size=(0.4, 0.8, 0.02), pose=Pose(position=(0.0, 0.0, 0.44)))
"""Its top is 0.45 m high."""
TOP = 0.45


@pytest.mark.parametrize(
    ("why", "x", "height", "believed"),
    [
        ("9 mm in the board", 0.0, TOP + HEIGHT / 2 - 0.009, TOP + HEIGHT / 2),
        ("on the board", 0.0, TOP + HEIGHT / 2, TOP + HEIGHT / 2),
        ("above it: something may carry it", 0.0, TOP + HEIGHT / 2 + 0.01, TOP + HEIGHT / 2 + 0.01),
        ("on a board below this one", 0.0, TOP - 0.30, TOP - 0.30),
        ("beside the board", 0.3, TOP + HEIGHT / 2 - 0.009, TOP + HEIGHT / 2 - 0.009),
    ],
)
def test_an_item_stands_on_what_it_is_seen_to_stand_in(
    why: str, x: float, height: float, believed: float
) -> None:
    seen = on_top(sighting(ITEM.item, tag(x, 0.0, z=height), 1.0), ITEM, [BOARD])
    assert seen.tag_in_map.position == pytest.approx((x, 0.0, believed)), why


def test_an_item_on_a_shelf_that_is_seen_too_low_from_afar_is_believed_to_stand_on_its_board() -> None:
    """Item 5 on the upper board, from 2.8 m: fingers at that height would touch the board."""
    beliefs = Beliefs(PICKING)
    beliefs.see(sighting(5, tag(1.8925, 0.6831, z=0.4657), 1.0))
    fact = beliefs.item(5)
    assert fact is not None
    assert fact.tag_in_map.position == pytest.approx((1.8925, 0.6831, 0.475))
