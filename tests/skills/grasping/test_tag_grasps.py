"""The arithmetic of a pick and a place, against numbers worked out by hand and the order-picking paper's."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.geometry.poses import (
    about,
    angle_between,
    compose,
    from_axes,
    invert,
    multiply,
    rotate,
    transform,
    yaw_of,
)
from tandem.skills.grasping.item_frames import (
    face,
    face_towards,
    item_in_map,
    outward,
    standing_in_map,
    turned_like,
    upright_in_map,
)
from tandem.skills.grasping.tag_grasps import PALM_ROOM, grasp, held_back, place, proximity_poses
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box

FACES_SOUTH = from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0))
TAG = Pose(position=(1.0, 2.0, 0.74), orientation=FACES_SOUTH)
DEPTH = 0.06


def homogeneous(pose: Pose) -> np.ndarray:
    columns = [rotate(pose.orientation, axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(columns).T
    matrix[:3, 3] = pose.position
    return matrix


@pytest.mark.parametrize(
    ("pitch", "palm", "back"),
    [
        (0.0, None, 0.0),
        (0.0, 0.04, 0.0),
        (0.0, 0.022, 0.03 + PALM_ROOM - 0.022),
        (math.pi / 4, 0.022, 0.04 * math.sqrt(2.0) + PALM_ROOM - 0.022),
    ],
)
def test_a_palm_stays_clear_of_an_item(pitch: float, palm: float | None, back: float) -> None:
    """An item of 6 x 6 x 10 cm; from 45 degrees above it reaches 5.7 cm from its middle towards the palm."""
    found = held_back((0.06, 0.06, 0.10), pitch, palm)
    assert found == pytest.approx(back)
    away = grasp(TAG, DEPTH, pitch, back=found)
    at_middle = grasp(TAG, DEPTH, pitch).grasp
    assert math.dist(away.grasp.position, at_middle.position) == pytest.approx(back)
    held = compose(away.grasp, away.item_in_tool).position
    assert held == pytest.approx(at_middle.position)


def test_equation_1_the_pre_grasp_lies_10_cm_along_the_tags_z() -> None:
    expected = homogeneous(TAG) @ np.array([0.0, 0.0, 0.1, 1.0])
    assert grasp(TAG, DEPTH, 0.5).pre_grasp.position == pytest.approx(tuple(expected[:3]))


def test_the_grasp_is_at_the_items_centre() -> None:
    assert grasp(TAG, DEPTH, 0.5).grasp.position == pytest.approx((1.0, 2.03, 0.74))


def test_equation_2_the_retraction_is_10_cm_out_of_the_face_and_10_cm_up() -> None:
    picked = grasp(TAG, DEPTH, 0.5)
    moved = np.subtract(picked.retraction.position, picked.grasp.position)
    assert moved == pytest.approx((0.0, -0.1, 0.1))


def test_equation_3_after_placing_the_hand_goes_10_cm_back() -> None:
    put = place((0.0, 0.0, 0.71), math.pi / 2, grasp(TAG, DEPTH, 0.5).item_in_tool, 0.06)
    assert np.subtract(put.retraction.position, put.place.position) == pytest.approx((0.0, 0.1, 0.0))


@pytest.mark.parametrize(
    ("quarter_turns", "back"), [(1, (-0.1, 0.0, 0.0)), (-1, (0.1, 0.0, 0.0)), (2, (0.0, -0.1, 0.0))]
)
def test_a_hand_that_holds_another_face_goes_back_from_that_face(
    quarter_turns: int, back: tuple[float, float, float]
) -> None:
    """To the side of the face that was seen, a finger would take the item along."""
    held = grasp(TAG, DEPTH, 0.5).item_in_tool
    other = compose(held, Pose(orientation=about((0, 0, 1), -quarter_turns * math.pi / 2)))
    put = place((0.0, 0.0, 0.71), math.pi / 2, other, 0.06)
    assert np.subtract(put.retraction.position, put.place.position) == pytest.approx(back, abs=1e-9)


def test_a_hand_that_looks_straight_down_goes_back_to_where_the_slot_is_served_from() -> None:
    down = Pose(orientation=from_axes((0, 0, -1), (0, 1, 0), (1, 0, 0)))
    put = place((0.0, 0.0, 0.71), math.pi / 2, invert(down), 0.06)
    assert np.subtract(put.retraction.position, put.place.position) == pytest.approx((0.0, 0.1, 0.0))


@pytest.mark.parametrize("pitch", [0.0, 0.4, 1.2])
def test_the_hand_points_at_the_face_and_down_by_its_pitch(pitch: float) -> None:
    out_of_the_hand = rotate(grasp(TAG, DEPTH, pitch).grasp.orientation, (1.0, 0.0, 0.0))
    assert out_of_the_hand == pytest.approx((0.0, math.cos(pitch), -math.sin(pitch)))


@pytest.mark.parametrize("pitch", [0.0, 0.4, 1.2])
def test_the_fingers_close_along_the_tags_x(pitch: float) -> None:
    closing = rotate(grasp(TAG, DEPTH, pitch).grasp.orientation, (0.0, 1.0, 0.0))
    assert abs(np.dot(closing, (1.0, 0.0, 0.0))) == pytest.approx(1.0)


def test_a_tag_stuck_on_askew_leaves_the_hand_level() -> None:
    askew = Pose(position=TAG.position, orientation=multiply(FACES_SOUTH, about((0, 0, 1), 0.3)))
    closing = rotate(grasp(askew, DEPTH, 0.7).grasp.orientation, (0.0, 1.0, 0.0))
    assert closing[2] == pytest.approx(0.0, abs=1e-9)


def test_a_tag_that_lies_flat_is_refused() -> None:
    with pytest.raises(ValueError, match="upright"):
        outward(Pose())


def test_what_is_put_down_stands_upright_in_its_slot() -> None:
    held = grasp(TAG, DEPTH, 0.7).item_in_tool
    put = place((3.0, 1.0, 0.71), 0.4, held, 0.06, clearance=0.0)
    item = compose(put.place, held)
    assert item.position == pytest.approx((3.0, 1.0, 0.74))
    assert rotate(item.orientation, (0.0, 0.0, 1.0)) == pytest.approx((0.0, 0.0, 1.0))


CUBE = Box(size=(DEPTH, DEPTH, DEPTH), pose=Pose())
HALF = DEPTH / 2.0


@pytest.mark.parametrize("angle", [0.0, 0.4, math.pi / 2, math.pi, -math.pi / 2])
def test_a_cube_that_was_rolled_about_its_tags_normal_stands_where_it_is(angle: float) -> None:
    rolled = Pose(position=TAG.position, orientation=multiply(TAG.orientation, about((0, 0, 1), angle)))
    stands = standing_in_map(rolled, CUBE)
    assert stands is not None
    assert stands.position == pytest.approx((1.0, 2.03, 0.74))
    assert rotate(stands.orientation, (0.0, 0.0, 1.0)) == pytest.approx((0.0, 0.0, 1.0))


@pytest.mark.parametrize("yaw", [0.0, 0.7, -2.0])
def test_a_cube_with_its_tag_on_top_stands_below_it_with_its_sides_along_the_tag(yaw: float) -> None:
    stands = standing_in_map(Pose(position=(1.0, 2.0, 0.78), orientation=about((0, 0, 1), yaw)), CUBE)
    assert stands is not None
    assert stands.position == pytest.approx((1.0, 2.0, 0.78 - HALF))
    assert math.remainder(yaw_of(stands.orientation) - yaw, math.pi / 2) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("angle", [math.pi / 2, math.pi, -math.pi / 2])
def test_what_is_no_cube_and_was_rolled_has_fallen_over(angle: float) -> None:
    rolled = Pose(position=TAG.position, orientation=multiply(TAG.orientation, about((0, 0, 1), angle)))
    assert standing_in_map(rolled, Box(size=(DEPTH, DEPTH, 0.2), pose=Pose())) is None
    assert upright_in_map(rolled, DEPTH) is None


def test_a_cylinder_as_high_as_wide_that_was_rolled_has_fallen_over() -> None:
    rolled = Pose(position=TAG.position, orientation=multiply(TAG.orientation, about((0, 0, 1), math.pi / 2)))
    assert standing_in_map(rolled, CUBE.model_copy(update={"shape": "cylinder"})) is None


@pytest.mark.parametrize(
    ("turns", "position"),
    [(0, (1.0, 2.0, 0.74)), (1, (1.03, 2.03, 0.74)), (2, (1.0, 2.06, 0.74)), (-1, (0.97, 2.03, 0.74))],
)
def test_the_tag_stands_on_all_four_sides(turns: int, position: tuple[float, float, float]) -> None:
    other = face(TAG, DEPTH, turns)
    assert other.position == pytest.approx(position)
    assert item_in_map(other, DEPTH).position == pytest.approx(item_in_map(TAG, DEPTH).position)


@pytest.mark.parametrize("heading", [-2.0, -1.0, 0.3, 1.5, 3.0])
def test_the_face_towards_a_heading_is_within_45_degrees_of_it(heading: float) -> None:
    out = outward(face_towards(TAG, DEPTH, heading))
    assert math.cos(heading) * out[0] + math.sin(heading) * out[1] >= math.cos(math.pi / 4) - 1e-9


def test_from_every_stand_the_target_is_where_the_hand_works() -> None:
    stands = proximity_poses((1.0, 2.0, 0.7), -math.pi / 2, (0.6, 0.2), -0.8)
    first = stands[0]
    base = Pose(position=(first.x, first.y, 0.0), orientation=about((0, 0, 1), first.yaw))
    assert transform(base, (0.6, 0.2, 0.7)) == pytest.approx((1.0, 2.0, 0.7))
    pointing = first.yaw - 0.8
    assert math.remainder(pointing - math.pi / 2, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("quarters", range(4))
def test_whichever_face_is_seen_the_frame_is_like_the_known_one(quarters: int) -> None:
    known = item_in_map(TAG, DEPTH)
    seen = item_in_map(face(TAG, DEPTH, quarters), DEPTH)
    assert angle_between(turned_like(seen, known).orientation, known.orientation) < 1e-6
    assert turned_like(seen, known).position == pytest.approx(known.position)
