"""Where two hands go when they let go."""

from __future__ import annotations

import math

import pytest

from tandem.skills.bimanual.object_frame import span
from tandem.skills.bimanual.ready import pointing, swing, ways_back
from tandem.skills.geometry.poses import about, angle_between, multiply, rotate
from tandem.skills.ports.pose import Pose

LEFT = Pose(position=(0.5, 0.2, 0.9), orientation=about((0.0, 0.0, 1.0), -math.pi / 2))
RIGHT = Pose(position=(0.5, -0.2, 0.9), orientation=about((0.0, 0.0, 1.0), math.pi / 2))


def leaning(tool: Pose, radians: float) -> Pose:
    return Pose(
        position=tool.position, orientation=multiply(about((0.0, 0.0, 1.0), radians), tool.orientation)
    )


def test_hands_turn_again_to_how_they_came() -> None:
    came = leaning(LEFT, 0.5), leaning(RIGHT, -0.3)
    held = span(LEFT, RIGHT)
    turns = swing(came, (LEFT, RIGHT))
    (left, right), *_ = ways_back(held, held.middle_in_base, (0.0, 0.0), turns, 0.1)
    assert angle_between(left.orientation, came[0].orientation) < 1e-9
    assert angle_between(right.orientation, came[1].orientation) < 1e-9


def test_hands_are_drawn_back_along_the_line_between_them_by_what_is_asked_or_less() -> None:
    held = span(LEFT, RIGHT)
    turns = swing((leaning(LEFT, 0.5), RIGHT), (LEFT, RIGHT))
    ends = ways_back(held, held.middle_in_base, (0.01, 0.01), turns, 0.1)
    assert ends[0][0].position == pytest.approx((0.5, 0.29, 0.9))
    assert ends[0][1].position == pytest.approx((0.5, -0.29, 0.9))
    farther = [left.position[1] for left, _ in ends]
    assert farther == sorted(farther, reverse=True)


def test_they_turn_with_what_is_held() -> None:
    """A thing that was turned meanwhile: the hands lean as before, seen from it."""
    held, quarter = span(LEFT, RIGHT), about((0.0, 0.0, 1.0), math.pi / 2)
    turns = swing((leaning(LEFT, 0.5), RIGHT), (LEFT, RIGHT))
    middle = held.middle_in_base
    turned = Pose(position=middle.position, orientation=multiply(quarter, middle.orientation))
    ((straight, _), *_) = ways_back(held, middle, (0.0, 0.0), turns, 0.1)
    ((now, _), *_) = ways_back(held, turned, (0.0, 0.0), turns, 0.1)
    expected = rotate(multiply(quarter, straight.orientation), (1.0, 0.0, 0.0))
    assert rotate(now.orientation, (1.0, 0.0, 0.0)) == pytest.approx(expected)


@pytest.mark.parametrize(("lean", "kept"), [(0.0, 0.0), (0.2, 0.2), (0.6, 0.6), (0.8, 0.6)])
def test_a_hand_may_go_on_leaning_up_to_an_angle(lean: float, kept: float) -> None:
    swung = pointing(leaning(LEFT, 0.6).orientation, (0.0, -1.0, 0.0), lean)
    assert angle_between(swung, LEFT.orientation) == pytest.approx(kept, abs=1e-9)
