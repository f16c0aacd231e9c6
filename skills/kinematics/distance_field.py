"""One signed distance field: how far each point of a grid is from what stands around.

The value at a cell's centre is the least signed distance to any body there (below zero: inside one), in
metres, cut off at ``reach`` on both sides. Boxes and cylinders are measured exactly; voxels (occupied cells
of an octree) by an exact distance transform, one axis after the other: Felzenszwalb and Huttenlocher,
"Distance Transforms of Sampled Functions" (Theory of Computing 8, 2012, section 3). As nothing beyond
``reach`` is of interest, the minimum along an axis is taken over the few offsets within it instead of by
their lower envelope.

What changes is measured anew where it was and where it is; the rest of the grid stays. See docs/planning.md.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from tandem.skills.kinematics.bodies import BoxShape, CellsShape, Obstacle
from tandem.skills.kinematics.transforms import Array, to_se3

Values = npt.NDArray[np.float32]
Cells = npt.NDArray[np.bool_]
Window = tuple[slice, slice, slice]

CELL = 0.02
"""Metres: half of it is lost at a wall, and a cube of 2 m then takes 4 MB."""
REACH = 0.16
"""Metres: more than the radius of most covering spheres and the margins that planners ask for."""
HALF_DIAGONAL = math.sqrt(3.0) / 2.0
"""Of a cell, in cells: no point of a cell is farther from its centre."""
MANY_GONE = 3
"""Obstacles that left; if there are more, it is quicker to measure all of the grid anew."""
ROUNDING = 1e-6
"""Metres by which bounds are wider than reckoned, as floats of four bytes are rounded."""


class DistanceField:
    """Signed distances on a regular grid, in the frame in which bodies and voxels are told.

    ``distances`` interpolates and errs by at most ``HALF_DIAGONAL`` cells either way (a distance changes by
    no more than the way one goes). ``lower_bounds`` and ``upper_bounds`` never err to the wrong side. None of
    them tells more than ``reach``.

    Args:
        low: the grid's corner of least x, y and z (3,), metres.
        high: the opposite corner (3,); rounded up to whole cells.
        cell: the cells' edge, metres.
        reach: how far from a body distances are told, metres.
        unknown_occupied: whether voxels about which nothing is known count as occupied.

    Raises:
        ValueError: the corners, ``cell`` or ``reach`` make no grid.
    """

    def __init__(
        self,
        low: Sequence[float] | Array,
        high: Sequence[float] | Array,
        *,
        cell: float = CELL,
        reach: float = REACH,
        unknown_occupied: bool = False,
    ) -> None:
        self.low = np.asarray(low, dtype=float)
        size = np.asarray(high, dtype=float) - self.low
        if not (cell > 0.0 and reach > 0.0 and size.shape == (3,) and bool(np.all(size > 0.0))):
            raise ValueError(
                f"no grid from {low} to {high} with cells of {cell} m and a reach of {reach} m: "
                "expected low < high in x, y and z, and both lengths above zero"
            )
        self.cell, self.reach, self.unknown_occupied = cell, reach, unknown_occupied
        x, y, z = (max(2, math.ceil(each / cell - 1e-9)) for each in size)
        self.shape: tuple[int, int, int] = (x, y, z)
        self.samples: Values = np.full(self.shape, reach, dtype=np.float32)
        """Signed distances at the cells' centres, metres."""
        self.least: Values = np.full(self.shape, reach - HALF_DIAGONAL * cell, dtype=np.float32)
        """Metres below which the distance falls nowhere in a cell."""
        self._obstacles: dict[str, tuple[Obstacle, ...]] = {}
        self._cells_told: tuple[Obstacle, ...] = ()
        self._occupied: Cells | None = None
        self._of_voxels: Values | None = None

    @property
    def high(self) -> Array:
        """The grid's corner of greatest x, y and z (3,), metres."""
        return np.asarray(self.low + self.cell * np.array(self.shape))

    def set_obstacles(self, obstacles: Sequence[Obstacle]) -> int:
        """Take what stands around now, and return how many cells were measured anew.

        Obstacles are told apart by name; those that are as they were cost nothing. Cells of occupied space
        among them take the place of the voxels that ``set_voxels`` was told.
        """
        now: dict[str, tuple[Obstacle, ...]] = {}
        cells_now = tuple(each for each in obstacles if isinstance(each.shape, CellsShape))
        for each in obstacles:
            if each not in cells_now:
                now[each.name] = (*now.get(each.name, ()), each)
        changed = [name for name in {**self._obstacles, **now} if self._obstacles.get(name) != now.get(name)]
        gone = [each for name in changed for each in self._obstacles.get(name, ())]
        new = [each for name in changed for each in now.get(name, ())]
        self._obstacles = now
        if len(gone) > MANY_GONE:  # the base has moved: all of it is elsewhere
            return self._measure_again(
                (slice(0, self.shape[0]), slice(0, self.shape[1]), slice(0, self.shape[2]))
            )
        cells = 0
        if cells_now != self._cells_told:
            self._cells_told = cells_now
            cells += self.set_voxels(*_voxels(cells_now, self.cell))
        for each in gone:
            cells += self._measure_again(self._window_of(each))
        for each in new:
            cells += self._stamp(each, self._window_of(each))
        return cells

    def set_voxels(self, occupied: Array, resolution: float, unknown: Array | None = None) -> int:
        """Take the occupied voxels now, and return how many cells were measured anew.

        A cell counts as occupied if a voxel overlaps it: exact if voxels begin and end where cells do, else
        up to a cell too large on each side. Voxels outside the grid are left out.

        Args:
            occupied: centres (n, 3), metres.
            resolution: the voxels' edge, metres.
            unknown: centres (m, 3) of voxels about which nothing is known; they count as configured.
        """
        centres = np.asarray(occupied, dtype=float).reshape(-1, 3)
        if unknown is not None and self.unknown_occupied:
            centres = np.concatenate((centres, np.asarray(unknown, dtype=float).reshape(-1, 3)))
        now = self._covered(centres, resolution)
        before = np.zeros(self.shape, dtype=bool) if self._occupied is None else self._occupied
        if self._of_voxels is None:
            self._of_voxels = np.full(self.shape, self.reach, dtype=np.float32)
        different = before != now
        self._occupied = now
        if not different.any():
            return 0
        margin = self._margin
        window = _window(
            *(
                (int(np.flatnonzero(along)[0]) - margin, int(np.flatnonzero(along)[-1]) + margin + 1)
                for along in (
                    different.any(axis=(1, 2)),
                    different.any(axis=(0, 2)),
                    different.any(axis=(0, 1)),
                )
            ),
            shape=self.shape,
        )
        self._transform(window)
        return self._measure_again(window)

    def inside(self, points: Array) -> npt.NDArray[np.bool_]:
        """Return which of the points (n, 3) lie in the grid (n,)."""
        return np.asarray(np.all((points >= self.low) & (points < self.high), axis=1))

    def distances(self, points: Array) -> Array:
        """Return the signed distances (n,) at points (n, 3), metres, interpolated between the cells' centres.

        A point outside the grid counts as where the grid is nearest to it.
        """
        corners, share = self._corners(points)
        for axis in range(3):
            t = share[:, axis].reshape(-1, *(1,) * (2 - axis))
            corners = corners[:, 0] * (1.0 - t) + corners[:, 1] * t
        return np.asarray(corners)

    def gradients(self, points: Array) -> Array:
        """Return how the distances change with the points (n, 3): metres a metre, away from what is near."""
        corners, share = self._corners(points)
        found = np.empty((len(corners), 3))
        for axis in range(3):
            along = np.diff(np.moveaxis(corners, 1 + axis, 1), axis=1)[:, 0]
            for other in (each for each in range(3) if each != axis):
                t = share[:, other].reshape(-1, *(1,) * (along.ndim - 2))
                along = along[:, 0] * (1.0 - t) + along[:, 1] * t
            found[:, axis] = along
        return found / self.cell

    def lower_bounds(self, points: Array) -> Array:
        """Return metres (n,) that the points (n, 3) are away at least; -inf outside the grid."""
        return np.where(self.inside(points), self.least[self._cells(points)], -np.inf)

    def upper_bounds(self, points: Array) -> Array:
        """Return metres (n,) that the points (n, 3) are away at most; inf outside the grid or ``reach``."""
        values = self.samples[self._cells(points)] + HALF_DIAGONAL * self.cell + ROUNDING
        return np.where(self.inside(points) & (values < self.reach), values, np.inf)

    @property
    def _margin(self) -> int:
        return math.ceil(self.reach / self.cell) + 1

    def _cells(self, points: Array) -> tuple[npt.NDArray[np.int_], ...]:
        at = np.floor((points - self.low) / self.cell)
        at = np.clip(at, 0, np.array(self.shape) - 1).astype(int)
        return at[:, 0], at[:, 1], at[:, 2]

    def _corners(self, points: Array) -> tuple[Array, Array]:
        """Return the eight centres' values about each point (n, 2, 2, 2), and its place in between (n, 3)."""
        at = (np.asarray(points, dtype=float) - self.low) / self.cell - 0.5
        first = np.clip(np.floor(at), 0, np.array(self.shape) - 2).astype(int)
        x, y, z = (
            (first[:, axis, None] + np.arange(2)).reshape(-1, *(2 if k == axis else 1 for k in range(3)))
            for axis in range(3)
        )
        return self.samples[x, y, z].astype(float), np.clip(at - first, 0.0, 1.0)

    def _covered(self, centres: Array, resolution: float) -> Cells:
        """Return which cells are overlapped by cubes about the centres (n, 3)."""
        found = np.zeros(self.shape, dtype=bool)
        first = np.floor((centres - resolution / 2.0 - self.low) / self.cell + 1e-6).astype(int)
        last = np.ceil((centres + resolution / 2.0 - self.low) / self.cell - 1e-6).astype(int)
        limit = np.array(self.shape)
        most = int((last - first).max()) if len(centres) else 0
        steps = np.indices((most,) * 3).reshape(3, -1).T
        for step in steps:
            at = first + step
            good = np.all((step < last - first) & (at >= 0) & (at < limit), axis=1)
            found[tuple(at[good].T)] = True
        return found

    def _transform(self, window: Window) -> None:
        """Measure the distances to voxels in a window anew."""
        assert self._occupied is not None
        assert self._of_voxels is not None
        wide = _window(
            *((each.start - self._margin, each.stop + self._margin) for each in window), shape=self.shape
        )
        inner = tuple(
            slice(one.start - other.start, one.stop - other.start)
            for one, other in zip(window, wide, strict=True)
        )
        occupied = self._occupied[wide]
        outside, within = (self._to_cubes(cells)[inner] for cells in (occupied, ~occupied))
        self._of_voxels[window] = np.where(occupied[inner], -within, outside)

    def _to_cubes(self, cells: Cells) -> Values:
        """Return the distances from all cells' centres to the nearest of the given cells, or ``reach``."""
        squares = np.where(cells, 0.0, self.reach**2).astype(np.float32)
        for axis in range(3):
            before = np.moveaxis(squares, axis, 0)
            after = before.copy()
            for k in range(1, min(self._margin, len(before) - 1) + 1):
                more = np.float32(((k - 0.5) * self.cell) ** 2)
                np.minimum(after[k:], before[:-k] + more, out=after[k:])
                np.minimum(after[:-k], before[k:] + more, out=after[:-k])
            squares = np.moveaxis(after, 0, axis)
        return np.sqrt(squares)

    def _measure_again(self, window: Window) -> int:
        """Measure all that reaches into a window anew."""
        samples, least = self.samples[window], self.least[window]
        slack = np.float32(HALF_DIAGONAL * self.cell + ROUNDING)
        samples[...] = self.reach if self._of_voxels is None else self._of_voxels[window]
        np.subtract(samples, slack, out=least)
        for each in (each for some in self._obstacles.values() for each in some):
            self._stamp(each, _common(window, self._window_of(each)))
        return samples.size

    def _window_of(self, obstacle: Obstacle) -> Window:
        """Return the cells within ``reach`` of the box around an obstacle."""
        placed, half = to_se3(obstacle.pose_in_base), _half(obstacle)
        extent = np.abs(placed.rotation) @ half + self.reach
        low = np.floor((placed.translation - extent - self.low) / self.cell - 0.5)
        high = np.ceil((placed.translation + extent - self.low) / self.cell + 0.5)
        return _window(*((int(a), int(b)) for a, b in zip(low, high, strict=True)), shape=self.shape)

    def _stamp(self, obstacle: Obstacle, window: Window) -> int:
        """Take an obstacle's distances in a window into account."""
        samples = self.samples[window]
        if not samples.size:
            return 0
        placed, half = to_se3(obstacle.pose_in_base), _half(obstacle)
        turn = np.asarray(placed.rotation)
        begin = turn.T @ (self.low + 0.5 * self.cell - np.asarray(placed.translation))
        steps = [
            (self.cell * np.arange(each.start, each.stop, dtype=np.float32)).reshape(
                *(-1 if k == axis else 1 for k in range(3))
            )
            for axis, each in enumerate(window)
        ]
        # Where the cells' centres are in the obstacle's frame: one array for each of its axes.
        local = [
            sum(
                (
                    np.float32(turn[axis, k]) * steps[axis]
                    for axis in range(3)
                    if abs(turn[axis, k]) > ROUNDING
                ),
                start=np.full((1, 1, 1), begin[k], dtype=np.float32),
            )
            for k in range(3)
        ]
        # A cell fits into a box of these half edges in that frame.
        room = 0.5 * self.cell * np.abs(turn).sum(axis=0) + ROUNDING
        if isinstance(obstacle.shape, BoxShape):
            gaps = [np.abs(local[k]) - np.float32(half[k]) for k in range(3)]
            rooms = room
        else:
            gaps = [
                np.hypot(local[0], local[1]) - np.float32(half[0]),
                np.abs(local[2]) - np.float32(half[2]),
            ]
            rooms = np.array([math.hypot(room[0], room[1]), room[2]])
        np.minimum(samples, _outside(gaps), out=samples)
        np.maximum(samples, np.float32(-self.reach), out=samples)
        least = self.least[window]
        np.minimum(
            least, _outside([gap - np.float32(r) for gap, r in zip(gaps, rooms, strict=True)]), out=least
        )
        return samples.size


def _outside(gaps: Sequence[Values]) -> Values:
    """Return the signed distances from products of intervals, of which the gaps are known one by one.

    Beyond the ends of several at once it is the root of their squares, within all the nearest end's.
    """
    squares: Values = sum(
        (np.square(np.maximum(gap, 0.0)) for gap in gaps), start=np.zeros((1, 1, 1), dtype=np.float32)
    )
    deepest = gaps[0]
    for gap in gaps[1:]:
        deepest = np.maximum(deepest, gap)
    return np.asarray(np.sqrt(squares) + np.minimum(deepest, 0.0))


def _voxels(obstacles: Sequence[Obstacle], cell: float) -> tuple[Array, float]:
    """Return the centres (n, 3) of obstacles that are cells, and an edge that holds each as it is turned."""
    centres, edge = [np.zeros((0, 3))], cell
    for each in obstacles:
        assert isinstance(each.shape, CellsShape)
        placed = to_se3(each.pose_in_base)
        turn = np.asarray(placed.rotation)
        centres.append(each.shape.centres @ turn.T + np.asarray(placed.translation))
        edge = max(edge, each.shape.resolution * float(np.abs(turn).sum(axis=1).max()))
    return np.concatenate(centres), edge


def _half(obstacle: Obstacle) -> Array:
    """Return the half edges (3,) of the box around an obstacle, in its own frame, padding included."""
    around, along = obstacle.padding
    shape = obstacle.shape
    if isinstance(shape, BoxShape | CellsShape):
        x, y, z = shape.size
        return np.array([x / 2.0 + around, y / 2.0 + around, z / 2.0 + along])
    return np.array([shape.radius + around, shape.radius + around, shape.length / 2.0 + along])


def _window(*bounds: tuple[int, int], shape: tuple[int, int, int]) -> Window:
    """Return slices within the grid; one that lies outside is empty."""
    x, y, z = (
        slice(min(max(a, 0), n), max(min(max(a, 0), n), min(max(b, 0), n)))
        for (a, b), n in zip(bounds, shape, strict=True)
    )
    return x, y, z


def _common(one: Window, other: Window) -> Window:
    """Return the cells that are in both windows."""
    x, y, z = (
        slice(max(a.start, b.start), max(a.start, b.start, min(a.stop, b.stop)))
        for a, b in zip(one, other, strict=True)
    )
    return x, y, z
