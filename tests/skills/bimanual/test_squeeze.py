"""Two hands on a spring: what they feel, and where they end."""

from __future__ import annotations

import pytest

from tandem.skills.bimanual.squeeze import ADVANCE, Grasp, agree

STIFF = 20_000.0
"""N/m of each side of the thing."""


def press(gaps: tuple[float, float], wanted: float, seconds: float) -> tuple[Grasp, tuple[float, float]]:
    """Close in on a thing whose sides are ``gaps`` metres away; return the grasp and both forces."""
    grasp, forces = Grasp(), (0.0, 0.0)
    for _ in range(round(seconds / 0.01)):
        grasp = grasp.pressed(forces, wanted, 0.01)
        left, right = (max(0.0, STIFF * (way - gap)) for way, gap in zip(grasp.inwards, gaps, strict=True))
        forces = (left, right)
    return grasp, forces


def test_both_press_as_wanted() -> None:
    grasp, forces = press((0.03, 0.03), 40.0, 3.0)
    assert grasp.holds
    assert forces == pytest.approx((40.0, 40.0), rel=0.02)
    assert agree(forces, 40.0)


def test_the_hand_that_is_there_first_waits_for_the_other() -> None:
    grasp, forces = press((0.01, 0.05), 40.0, 1.0)
    assert grasp.felt == (True, False)
    assert forces[1] == 0.0
    assert forces[0] <= 3.0 + STIFF * ADVANCE * 0.02


def test_a_hand_that_feels_nothing_never_holds() -> None:
    grasp, _ = press((0.01, 1.0), 40.0, 3.0)
    assert not grasp.holds


def test_forces_that_differ_do_not_agree() -> None:
    assert not agree((40.0, 20.0), 40.0)
