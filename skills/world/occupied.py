"""Occupied space without the things that are known: an item is recognised after its cells were filled."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import product
from typing import Final

from tandem.skills.ports.occupancy import Occupancy, pack
from tandem.skills.ports.world import Box
from tandem.skills.world.clutter import contains

MARGIN: Final = 0.045
"""Metres about a known thing, besides half a cell, within which cells are its own: the pose of the robot, and
with it that of what it sees, is known no better."""


def without(told: Occupancy, known: Iterable[Box]) -> Occupancy:
    """Return the cells whose centres lie outside of the boxes, grown by the margin."""
    before = set(told.numbers())
    left = set(before)
    for box in known:
        for number, centre in _around(told, box):
            if number in left and contains(box, centre, MARGIN + told.resolution / 2.0):
                left.discard(number)
    return told if len(left) == len(before) else told.model_copy(update={"cells": pack(sorted(left))})


def _around(told: Occupancy, box: Box) -> Iterator[tuple[int, tuple[float, float, float]]]:
    """Give the numbers and centres of all cells near a box."""
    edge, (nx, ny, _) = told.resolution, told.shape
    reach = math.hypot(*box.size) / 2.0 + MARGIN + edge
    ranges = []
    for at, corner, most in zip(box.pose.position, told.origin, told.shape, strict=True):
        first, last = (math.floor((at + side - corner) / edge) for side in (-reach, reach))
        ranges.append(range(max(first, 0), min(last + 1, most)))
    for x, y, z in product(*ranges):
        centre = tuple(
            (index + 0.5) * edge + corner for index, corner in zip((x, y, z), told.origin, strict=True)
        )
        yield x + nx * (y + ny * z), (centre[0], centre[1], centre[2])
