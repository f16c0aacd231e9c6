"""Plans and the gaps between them."""

from __future__ import annotations

import math

import pytest

from tandem.sim.floor_plan import Plan, gap

SQUARE = Plan(((1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)))


def moved(plan: Plan, x: float, y: float, yaw: float = 0.0) -> Plan:
    c, s = math.cos(yaw), math.sin(yaw)
    corners = tuple((x + c * px - s * py, y + s * px + c * py) for px, py in plan.corners)
    return Plan(corners, plan.radius)


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (SQUARE, moved(SQUARE, 3.0, 0.5), 1.0),
        (SQUARE, moved(SQUARE, 3.0, 3.0), math.sqrt(2.0)),
        (SQUARE, moved(SQUARE, 3.0, 0.0, math.pi / 4), 2.0 - math.sqrt(2.0)),
        (SQUARE, moved(SQUARE, 1.5, 0.5), 0.0),
        (SQUARE, moved(SQUARE, 0.1, 0.0), 0.0),
        (SQUARE, SQUARE, 0.0),
        (moved(Plan(((2.0, 0.1), (-2.0, 0.1), (-2.0, -0.1), (2.0, -0.1))), 0.0, 0.0, 1.57), SQUARE, 0.0),
        (SQUARE, Plan(((0.0, 0.0),), 0.2), 0.0),
        (SQUARE, Plan(((2.0, 0.0),), 0.2), 0.8),
        (SQUARE, Plan(((2.0, 2.0),), 0.2), math.sqrt(2.0) - 0.2),
        (Plan(((0.0, 0.0),), 0.5), Plan(((3.0, 4.0),), 1.0), 3.5),
        (Plan(((0.0, 0.0),), 0.5), Plan(((0.0, 1.0),), 1.0), 0.0),
    ],
)
def test_gap(first: Plan, second: Plan, expected: float) -> None:
    assert gap(first, second) == pytest.approx(expected)
    assert gap(second, first) == pytest.approx(expected)
