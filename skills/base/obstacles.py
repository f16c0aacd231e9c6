"""What stands on the floor and on no map: cells that the laser hit, until it looks through them or forgets.

The cells lie on the nodes of the plan's field, so that a plan can take them in without a new raster.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.base.cliffs import Cliffs
from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import BoolArray, FloatArray, IntArray, compose, invert, points_in
from tandem.skills.base.localiser import Localiser, PlacedScan
from tandem.skills.base.map import SiteMap
from tandem.skills.base.occupied import OccupiedFloor
from tandem.skills.base.people.tracker import Tracker
from tandem.skills.base.scan import ScanGeometry
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.sensors import LaserSensor

FARTHEST: Final = 4.0
"""Metres: hits farther away are not marked."""
TRUSTED_FIT: Final = 0.5
"""Share of beams explained below which a scan marks and clears nothing."""
CONFIRMED: Final = 2
"""Scans that must have hit a cell before it counts."""
KEPT_FOR: Final = 45.0
"""Robot seconds after which a cell that was not seen again is forgotten."""
SEEN_THROUGH: Final = 0.12
"""Metres that a beam must pass beyond a cell to clear it."""
MOST: Final = 1500
"""Cells kept at the most; the oldest go."""
STAMPS: Final = 100
"""Cells taken into a plan's field in a slice."""
REACH: Final = 0.9
"""Metres around a cell in which it lowers the clearance."""


class Obstacles:
    """The monitor of unmapped obstacles; a ``Node`` that follows the localiser's scans.

    Args:
        clocks: robot time.
        sensor: the laser.
        site_map: what explains a hit.
        localiser: scans with the pose at which they were taken.
        occupied: what depth shows besides.
        people: who walks about; what hits them marks nothing.
        cliffs: where the floor ends, which no laser sees.
    """

    def __init__(
        self,
        clocks: Clocks,
        sensor: LaserSensor,
        site_map: SiteMap,
        localiser: Localiser,
        occupied: OccupiedFloor | None = None,
        *,
        people: Tracker | None = None,
        cliffs: Cliffs | None = None,
    ) -> None:
        self._occupied, self._people, self._cliffs = occupied, people, cliffs
        self._clocks, self._map, self._localiser = clocks, site_map, localiser
        self._geometry = ScanGeometry(sensor, site_map.laser_in_base)
        self._cells: IntArray = np.empty(0, dtype=np.int64)
        self._seen: FloatArray = np.empty(0)
        self._hits: IntArray = np.empty(0, dtype=np.int64)
        self._number = 0

    @property
    def name(self) -> str:
        """The node's name."""
        return "base/obstacles"

    @property
    def points(self) -> FloatArray:
        """The confirmed cells' centres in the map, shape (n, 2), and what depth and cliff sensors show."""
        seen = self._centres(self._cells[self._hits >= CONFIRMED])
        if self._cliffs is not None:
            seen = np.concatenate((seen, self._cliffs.edges()))
        if self._occupied is None:
            return seen
        shown = self._occupied.points()
        if self._people is not None:
            shown = shown[~self._people.hides(shown)]
        return np.concatenate((seen, shown))

    def step(self) -> bool:
        """Take the localiser's newest scan, if it is new."""
        placed = self._localiser.placed
        if placed is None or placed.number == self._number:
            return False
        self._number = placed.number
        if self._localiser.localised and placed.fit >= TRUSTED_FIT:
            now = robot_seconds(self._clocks)
            self._clear(placed, now)
            self._mark(placed, now)
        return False

    def close(self) -> None:
        """End the subscription."""
        if self._occupied is not None:
            self._occupied.close()

    def _mark(self, placed: PlacedScan, now: float) -> None:
        points = placed.points_in_map
        strange = placed.unmapped(self._map.bounds, FARTHEST)
        if self._people is not None:
            strange &= ~self._people.hides(points)
        hit = np.unique(self._map.plan.cells(points[strange]))
        known = np.isin(self._cells, hit)
        self._seen[known] = now
        self._hits[known] += 1
        new = hit[~np.isin(hit, self._cells)]
        near_known = self._next_to_known(new)
        self._cells = np.concatenate((self._cells, new))
        self._seen = np.concatenate((self._seen, np.full(len(new), now)))
        self._hits = np.concatenate((self._hits, np.where(near_known, CONFIRMED, 1)))

    def _next_to_known(self, cells: IntArray) -> BoolArray:
        """Say which cells touch one that was hit before: noise moves hits between neighbours."""
        columns = self._map.plan.values.shape[1]
        around = np.array([-columns - 1, -columns, -columns + 1, -1, 1, columns - 1, columns, columns + 1])
        touched: BoolArray = np.any(np.isin(cells[:, None] + around, self._cells), axis=1)
        return touched

    def _clear(self, placed: PlacedScan, now: float) -> None:
        if not len(self._cells):
            return
        kept = now - self._seen < KEPT_FOR
        laser = compose(placed.base_in_map, self._map.laser_in_base)
        in_laser = points_in(invert(laser), self._centres(self._cells))
        beam = np.rint(self._geometry.beam_of(in_laser)).astype(np.int64)
        looked = (beam >= 1) & (beam < len(placed.points.all_ranges) - 1)
        ranges = placed.points.all_ranges
        index = np.where(looked, beam, 1)
        # A beam that missed a thin thing by a hair must not clear it: all three neighbours pass.
        passed = np.min(np.stack([ranges[index - 1], ranges[index], ranges[index + 1]]), axis=0)
        distance = np.hypot(in_laser[:, 0], in_laser[:, 1])
        with np.errstate(invalid="ignore"):
            kept &= ~(looked & (passed > distance + SEEN_THROUGH))
        if self._people is not None:
            kept &= ~self._people.hides(self._centres(self._cells))
        if len(kept) > MOST:
            kept &= self._seen >= np.sort(self._seen)[-MOST]
        self._cells, self._seen, self._hits = self._cells[kept], self._seen[kept], self._hits[kept]

    def _centres(self, cells: IntArray) -> FloatArray:
        field = self._map.plan
        columns = field.values.shape[1]
        return np.stack(
            (field.x0 + field.step * (cells % columns), field.y0 + field.step * (cells // columns)), axis=1
        )


def with_obstacles(field: DistanceField, points: FloatArray) -> Generator[None, None, DistanceField]:
    """Work out the clearance to what is mapped and to the points, shape (n, 2), up to ``REACH`` from them.

    Yields between slices; returns the field.
    """
    if not len(points):
        return field
    reach = round(REACH / field.step)
    offsets = np.arange(-reach, reach + 1) * field.step
    around = np.maximum(np.hypot(offsets[:, None], offsets[None, :]) - field.step / 2, 0.0)
    values = np.pad(field.values, reach, constant_values=np.inf)
    rows, columns = field.values.shape
    for done, cell in enumerate(np.unique(field.cells(points)).tolist()):
        row, column = divmod(cell, columns)
        window = values[row : row + 2 * reach + 1, column : column + 2 * reach + 1]
        np.minimum(window, around, out=window)
        if done % STAMPS == STAMPS - 1:
            yield
    inner = np.ascontiguousarray(values[reach : reach + rows, reach : reach + columns])
    return DistanceField(field.x0, field.y0, field.step, inner)
