"""Occupied space as perception would tell it, out of boxes."""

from __future__ import annotations

import numpy as np

from tandem.skills.ports.lattice import Lattice, packed
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.world import Box

LATTICE = Lattice.over((-4.0, -4.0, 6.0, 6.0), 1.7, 0.05)


def occupied(stamp: RobotTime, *boxes: Box, version: int = 1) -> Occupancy:
    """Return the cells whose centres lie in upright boxes that stand along the map's axes."""
    numbers = np.zeros(0, np.int64)
    for box in boxes:
        low = np.array(box.pose.position) - np.array(box.size) / 2.0
        axes = [np.arange(at + 0.001, at + edge, 0.025) for at, edge in zip(low, box.size, strict=True)]
        points = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 3)
        numbers = np.union1d(numbers, LATTICE.numbers(points))
    return Occupancy(
        stamp=stamp,
        version=version,
        origin=LATTICE.origin,
        shape=LATTICE.shape,
        resolution=LATTICE.resolution,
        cells=packed(numbers),
    )
