"""The object recorder: two-arm thesis, 4.3, Algorithm 1.

    for all o in O: R.update(o) or R.push(o); O_f.push(o)
    for all r in R: if r not in O and r not in P: O_f.push(r)

O is what is detected now, P what has been picked, R what was detected so far; O_f is the scene. What an arm
hides is missing from O; it stays in the scene where it was last seen. What is picked leaves it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TypeVar

Thing = TypeVar("Thing")


def update(recorded: Mapping[int, Thing], detected: Mapping[int, Thing]) -> dict[int, Thing]:
    """Return R after a detection, by item: new where it is new, updated where it was recorded."""
    return {**recorded, **detected}


def scene(
    recorded: Mapping[int, Thing], picked: Collection[int], detected: Mapping[int, Thing] | None = None
) -> dict[int, Thing]:
    """Return O_f, by item in rising order: all that is detected, and what is recorded and not picked."""
    now = detected or {}
    shown = update({item: thing for item, thing in recorded.items() if item not in picked}, now)
    return {item: shown[item] for item in sorted(shown)}
