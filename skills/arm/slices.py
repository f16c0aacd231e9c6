"""What the computations of an arm are cut into, so that whoever stops them is heard."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.skill import Slice

UNIT_COST: Final = 25e-6
"""Robot seconds that lockstep charges for a unit of work: about a collision check or an iteration."""
SLICE_UNITS: Final = 80
"""Units of work that are charged together: about 2 ms as a rule."""
BREATH_UNITS: Final = 20
"""Units of one step of a computation after which a command is heard, though the slice goes on.

Steps of so many (making a checker, the first check of a motion) take several times what they are charged, and
two or three of them fell into one slice.
"""
BREATH: Final = Slice(0.0)
"""Costs no robot time: its work is charged with the slice that it is a part of. Lockstep runs as without."""


def due(units: int, step: int) -> Slice | None:
    """Return what is to be yielded after a step of a computation; None: go on.

    Args:
        units: done since the last slice that was charged, with this step.
        step: of this step alone.
    """
    if units >= SLICE_UNITS:
        return Slice(units * UNIT_COST)
    return BREATH if step >= BREATH_UNITS else None
