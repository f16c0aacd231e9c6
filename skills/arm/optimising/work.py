"""What an optimiser's work counts for: units of a collision check, as everywhere in planning."""

from __future__ import annotations

from typing import Final

UNITS_A_STATE: Final = 1.5
"""Costing a state of an arm of some 50 spheres took 36 us, half as long again as a unit stands for."""
GRADIENT: Final = 2.0
"""Times as long with the gradient."""


def units(states: int, *, gradients: bool = False) -> int:
    """Return the units of costing so many states."""
    return max(1, round(UNITS_A_STATE * states * (GRADIENT if gradients else 1.0)))
