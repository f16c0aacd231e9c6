"""What a shape comes to: its edges, its sides, and how wide a hand finds it."""

from __future__ import annotations

import math

import pytest

from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import (
    QUARTER,
    RING,
    BoxShape,
    CylinderShape,
    Solid,
    extents,
    name_of,
    seen_from,
    sides,
    solid,
    within_quarter,
)
from tandem.skills.ports.world import Box, ItemFact

BOX = BoxShape((0.06, 0.05, 0.07))
TIN = CylinderShape(0.033, 0.09)


@pytest.mark.parametrize("shape", [BOX, TIN])
def test_a_message_tells_a_shape_by_the_box_about_it_and_its_name(shape: Solid) -> None:
    told = Box(size=extents(shape), pose=Pose(), shape=name_of(shape))
    assert solid(Box.model_validate_json(told.model_dump_json())) == shape


def test_what_was_told_before_there_were_shapes_is_a_box() -> None:
    told = Box.model_validate({"size": (0.06, 0.05, 0.07), "pose": Pose()})
    assert solid(told) == BOX
    assert ItemFact.model_fields["shape"].default == "box"


@pytest.mark.parametrize(
    ("shape", "degrees"), [(BOX, (0, 90, 180, 270)), (TIN, tuple(range(0, 360, 360 // RING)))]
)
def test_a_hand_may_come_against_faces_or_from_all_around(shape: Solid, degrees: tuple[int, ...]) -> None:
    assert tuple(round(math.degrees(side)) for side in sides(shape)) == degrees


@pytest.mark.parametrize(("shape", "degrees"), [(BOX, [0]), (TIN, [0, -30, 30])])
def test_a_quarter_has_the_sides_nearest_to_it_the_face_first(shape: Solid, degrees: list[int]) -> None:
    turns = [round(math.degrees(turn)) for turn in within_quarter(shape)]
    assert turns[0] == 0
    assert sorted(turns) == sorted(degrees)


@pytest.mark.parametrize("shape", [BOX, TIN])
def test_four_quarters_have_each_side_once(shape: Solid) -> None:
    around = [quarter * QUARTER + turn for quarter in range(4) for turn in within_quarter(shape)]
    assert sorted(round(math.degrees(each)) % 360 for each in around) == [
        round(math.degrees(side)) for side in sides(shape)
    ]


@pytest.mark.parametrize(
    ("shape", "side", "edges"),
    [
        (BOX, 0.0, (0.06, 0.05, 0.07)),
        (BOX, QUARTER, (0.05, 0.06, 0.07)),
        (BOX, 2 * QUARTER, (0.06, 0.05, 0.07)),
        (TIN, 0.0, (0.066, 0.066, 0.09)),
        (TIN, QUARTER / 3, (0.066, 0.066, 0.09)),
    ],
)
def test_what_a_hand_meets_from_a_side(shape: Solid, side: float, edges: Vector3) -> None:
    assert seen_from(shape, side) == pytest.approx(edges)
