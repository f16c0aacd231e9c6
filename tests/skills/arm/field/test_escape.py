"""Which pole a hand pursues, on scenes made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.field.escape import SAFE, Pole, choose, cost, escape_points
from tandem.skills.arm.field.hand_surroundings import Around, Block, Post, split
from tandem.skills.ports.pose import Pose

HAND, GOAL = np.array([0.2, 0.0, 0.8]), np.array([0.8, 0.0, 0.8])
TALL = Post((0.5, 0.0, 0.9), 0.05, 0.3)
LOW = Post((0.5, 0.0, 0.74), 0.05, 0.05)
OFF_LEFT = Post((0.5, 0.03, 0.9), 0.05, 0.3)
BESIDE = Post((0.5, 0.3, 0.9), 0.05, 0.3)
WALL_RIGHT = Block(Pose(position=(0.5, -0.15, 0.8)), (0.1, 0.1, 1.0))


@pytest.mark.parametrize(
    ("posts", "blocks", "taken"),
    [
        ((), (), ""),
        ((BESIDE,), (), ""),
        ((OFF_LEFT,), (), "0/right"),
        ((OFF_LEFT,), (WALL_RIGHT,), "0/left"),
        ((LOW,), (), "0/above"),
    ],
)
def test_the_cheapest_way_is_pursued(posts: tuple[Post, ...], blocks: tuple[Block, ...], taken: str) -> None:
    assert choose(HAND, GOAL, Around(posts, blocks)).label == taken


def test_escape_points_keep_the_safe_distance() -> None:
    around = Around((TALL,), ())
    points = escape_points(HAND, GOAL, around)
    assert [pole.label for pole in points] == ["0/left", "0/right", "0/above"]
    assert (around.gaps(np.array([pole.point for pole in points])) >= SAFE).all()


def test_a_choice_is_kept_while_another_is_hardly_better() -> None:
    around = Around((TALL,), ())
    nudged = HAND + np.array([0.0, 0.002, 0.0])
    assert choose(nudged, GOAL, around, "0/left").label == "0/left"
    assert choose(nudged, GOAL, around, "0/right").label == "0/right"


def test_costs_are_those_of_the_formula() -> None:
    around = Around((Post((8.0 / 15.0, 0.105, 0.8), 0.05, 0.3),), ())  # 5.5 cm beside the way
    assert cost(Pole(GOAL), HAND, GOAL, around) == pytest.approx(-np.log(0.055 / 0.09), abs=1e-9)
    detour = Pole(np.array([0.5, -0.4, 0.8]), "x")
    assert cost(detour, HAND, GOAL, Around((), ())) == pytest.approx(2.0 * np.log(1.0 / 0.6), abs=1e-9)


def test_a_things_r_reaches_to_the_corners_of_its_base_and_the_other_goal_is_a_post() -> None:
    around = split([(Pose(position=(0.5, 0.0, 0.7)), (0.06, 0.08, 0.1))], (0.6, 0.2, 0.75))
    assert [post.radius for post in around.posts] == pytest.approx([0.05, 0.10])
