"""Two hands as one: two-arm thesis, eq. 4.2."""

from __future__ import annotations

import math

import pytest

from tandem.skills.bimanual.object_frame import HandsApartError, span, tilt
from tandem.skills.bimanual.ready import between, pointing, ready_tools
from tandem.skills.geometry.poses import about, angle_between, compose, distance, from_rpy, invert, rotate
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

LEFT = Pose(position=(0.6, 0.25, 0.9), orientation=from_rpy(0.4, 0.0, -math.pi / 2))
RIGHT = Pose(position=(0.6, -0.25, 0.9), orientation=from_rpy(-0.2, 0.0, math.pi / 2))
BOX = Pose(position=(0.62, 0.0, 0.91), orientation=about((0, 0, 1), math.pi))


def test_the_middle_lies_between_and_its_y_points_to_the_left_hand() -> None:
    middle = span(LEFT, RIGHT).middle_in_base
    assert middle.position == pytest.approx((0.6, 0.0, 0.9))
    assert rotate(middle.orientation, (0.0, 1.0, 0.0)) == pytest.approx((0.0, 1.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("turn", [0.0, 0.3, -1.0])
def test_distance_and_attitude_between_the_hands_are_kept(turn: float) -> None:
    both = span(LEFT, RIGHT)
    moved = Pose(position=(0.5, 0.1, 1.1), orientation=from_rpy(0.1, -0.2, turn))
    left, right = both.tools(moved, (0.0, 0.0))
    assert distance(left, right) == pytest.approx(0.5)
    before, after = compose(invert(LEFT), RIGHT), compose(invert(left), right)
    assert after.position == pytest.approx(before.position)
    assert angle_between(after.orientation, before.orientation) == pytest.approx(0.0, abs=1e-7)
    assert both.middle(left, right).position == pytest.approx(moved.position)


def test_a_shift_moves_both_hands_by_the_same_vector() -> None:
    """Eq. 4.2 to the letter."""
    both = span(LEFT, RIGHT)
    shifted = both.middle_in_base.model_copy(update={"position": (0.63, -0.02, 1.0)})
    left, right = both.tools(shifted, (0.0, 0.0))
    for now, was in ((left, LEFT), (right, RIGHT)):
        assert [a - b for a, b in zip(now.position, was.position, strict=True)] == pytest.approx(
            [0.03, -0.02, 0.1]
        )


def test_inwards_brings_the_hands_nearer_each_other() -> None:
    both = span(LEFT, RIGHT)
    left, right = both.tools(both.middle_in_base, (0.05, 0.02))
    assert (left.position[1], right.position[1]) == pytest.approx((0.20, -0.23))


def test_hands_that_do_not_face_each_other_hold_nothing() -> None:
    with pytest.raises(HandsApartError, match="point at each other"):
        span(LEFT, Pose(position=RIGHT.position, orientation=LEFT.orientation))


def test_tilt_is_of_the_upright_only() -> None:
    level = Pose(orientation=from_rpy(0.0, 0.0, 0.3))
    assert tilt(level, Pose(orientation=from_rpy(0.0, 0.0, 1.3))) == pytest.approx(0.0, abs=1e-7)
    assert tilt(level, Pose(orientation=from_rpy(0.05, 0.0, 1.3))) == pytest.approx(0.05)


def test_hands_begin_before_their_points_and_point_inwards() -> None:
    item = load("bimanual").item(0)
    assert item is not None
    left, right = ready_tools(BOX, item, (LEFT, RIGHT), 0.03)
    assert left.position[1] == pytest.approx(0.23)
    assert right.position[1] == pytest.approx(-0.23)
    assert rotate(left.orientation, (1.0, 0.0, 0.0)) == pytest.approx((0.0, -1.0, 0.0), abs=1e-9)
    assert rotate(right.orientation, (1.0, 0.0, 0.0)) == pytest.approx((0.0, 1.0, 0.0), abs=1e-9)


def test_a_hand_is_swung_no_more_than_it_must() -> None:
    skew = from_rpy(0.7, 0.2, -math.pi / 2 + 0.3)
    along = (0.0, -1.0, 0.0)
    x = rotate(skew, (1.0, 0.0, 0.0))
    least = math.acos(sum(a * b for a, b in zip(x, along, strict=True)))
    assert angle_between(skew, pointing(skew, along)) == pytest.approx(least)


def test_what_both_hands_touch_is_in_their_middle() -> None:
    off = BOX.model_copy(update={"position": (0.62, 0.01, 0.91)})
    assert between(off, span(LEFT, RIGHT).middle_in_base).position == pytest.approx((0.02, 0.0, 0.01))
