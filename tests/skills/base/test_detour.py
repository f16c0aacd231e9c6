"""Round other robots: along the tangent, on a side that is kept."""

from __future__ import annotations

import math

import pytest

from tandem.skills.base.detour import KEPT_FOR, ROOM, Detour, Other

RADIUS = 0.7
CLEAR = RADIUS + ROOM


@pytest.mark.parametrize(
    ("other", "bearing"),
    [
        pytest.param(Other(0.0, 2.5), 0.0, id="too far off to count"),
        pytest.param(Other(1.2, 1.2), 0.0, id="beside the way"),
        pytest.param(
            Other(-0.1, 1.5), -0.1 + math.asin(CLEAR / 1.5), id="in the way, to the right: past its left"
        ),
        pytest.param(
            Other(0.1, 1.5), 0.1 - math.asin(CLEAR / 1.5), id="in the way, to the left: past its right"
        ),
        pytest.param(Other(-0.1, 0.8), -0.1 + math.pi / 2.0, id="too near already: across"),
    ],
)
def test_who_is_in_the_way_is_passed(other: Other, bearing: float) -> None:
    assert Detour(RADIUS).around(0.0, 3.0, [other], 0.0) == pytest.approx(bearing)


def test_who_stands_behind_the_place_is_not_in_the_way() -> None:
    assert Detour(RADIUS).around(0.0, 1.3, [Other(0.0, 1.5)], 0.0) == 0.0


def test_the_side_is_kept_for_a_while() -> None:
    detour = Detour(RADIUS)
    left = detour.around(0.0, 3.0, [Other(-0.1, 1.5)], 0.0)
    kept = detour.around(0.0, 3.0, [Other(0.1, 1.5)], 1.0)
    after = detour.around(0.0, 3.0, [Other(0.1, 1.5)], 1.1 + KEPT_FOR)
    assert (left > 0.0, kept > 0.0, after < 0.0) == (True, True, True)


def test_it_looks_elsewhere_for_a_moment_only() -> None:
    detour = Detour(RADIUS)
    assert not detour.active(0.0)
    detour.around(0.0, 3.0, [Other(0.0, 1.5)], 0.0)
    assert (detour.active(1.0), detour.active(KEPT_FOR)) == (True, False)
