"""When a computation of an arm is interrupted: for what it costs, and for who may stop it."""

from __future__ import annotations

import pytest

from tandem.skills.arm.slices import BREATH, BREATH_UNITS, SLICE_UNITS, UNIT_COST, due
from tandem.skills.ports.skill import Slice


@pytest.mark.parametrize(
    ("units", "step", "expected"),
    [
        (1, 1, None),
        (SLICE_UNITS - 1, 1, None),
        (BREATH_UNITS, BREATH_UNITS, BREATH),
        (SLICE_UNITS - 1, BREATH_UNITS, BREATH),
        (SLICE_UNITS, 1, Slice(SLICE_UNITS * UNIT_COST)),
        (SLICE_UNITS + BREATH_UNITS, BREATH_UNITS, Slice((SLICE_UNITS + BREATH_UNITS) * UNIT_COST)),
    ],
)
def test_a_slice_ends_when_it_has_cost_enough_and_a_long_step_is_followed_by_a_breath(
    units: int, step: int, expected: Slice | None
) -> None:
    assert due(units, step) == expected


def test_what_is_charged_does_not_depend_on_breaths() -> None:
    charged, units = 0.0, 0
    for step in (60, 60, 1, 1, 60, 30):
        units += step
        slice_ = due(units, step)
        if slice_ is not None:
            charged += slice_.cost
            units = units if slice_ is BREATH else 0
    assert charged + units * UNIT_COST == pytest.approx(212 * UNIT_COST)
