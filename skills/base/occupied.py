"""What depth shows to be occupied, as the base needs it: points of the floor that it can't stand on."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import FloatArray
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.lattice import centres_of
from tandem.skills.ports.world import OCCUPANCY

CLEARANCE: Final = 0.03
"""Metres above the floor below which a base passes over things; perception measures nothing that low."""
NOTHING: Final = np.zeros((0, 2))


class OccupiedFloor:
    """Projects occupied cells between the floor clearance and the robot's height onto the floor.

    Cells over the plan of furniture are left out: the base does not get there anyway.

    Args:
        bus: where perception tells what is occupied.
        height: the robot's (m).
        plan: distance to what is mapped.
    """

    def __init__(self, bus: Bus, height: float, plan: DistanceField) -> None:
        self._told = Latest(bus, OCCUPANCY, depth=4)
        self._height, self._plan = height, plan
        self._cells = ""
        self._points: FloatArray = NOTHING

    def points(self) -> FloatArray:
        """Return points in the map, (n, 2) metres, no farther apart than the nodes of the plan."""
        told = self._told.refresh()
        if told is None or told.cells == self._cells:
            return self._points
        self._cells = told.cells
        centres, half = centres_of(told), told.resolution / 2.0
        low = (centres[:, 2] + half > CLEARANCE) & (centres[:, 2] - half < self._height)
        columns = np.unique(np.round(centres[low, :2], 6), axis=0)
        many = max(1, math.ceil(told.resolution / self._plan.step - 1e-9))
        steps = (np.arange(many) + 0.5) / many * told.resolution - half
        spread = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
        points = (columns[:, None, :] + spread[None, :, :]).reshape(-1, 2)
        self._points = points[self._plan.at(points) > 0.0] if len(points) else NOTHING
        return self._points

    def close(self) -> None:
        """End the subscription."""
        self._told.close()
