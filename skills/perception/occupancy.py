"""Occupied space out of one depth image: cells are filled by what is measured and freed by looking through.

Within a picture, hits win over carving: on a surface that is seen at a grazing angle the ray of a cell's
centre passes through cells that others hit. What the site's furniture, an item with a tag, the robot or what
it holds explains fills nothing; a cell in which only that is measured is freed, since a table's top lies in
the cells of what stood on it. A cell that no picture shows stays as it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import compose, to_pose
from tandem.skills.perception.blind import Sight, judged
from tandem.skills.perception.clutter import HEIGHTS, LEVEL_MARGIN, UPRIGHT_MARGIN, Known, of_robot
from tandem.skills.perception.depth import back_project
from tandem.skills.perception.jobs import Shot
from tandem.skills.perception.rigid import Matrix, points_from, points_in
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import decode
from tandem.skills.ports.lattice import Lattice, Numbers
from tandem.skills.ports.occupancy import MOST_CELLS
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box

COST: Final = 0.02
"""Robot seconds that a picture is charged in lockstep; ``python -m benchmarks.occupancy`` measures it."""
STRIDE: Final = 4
"""Every how many pixels a point is taken, in both directions: 17 mm apart at 4 m, three in a cell's width."""
NEAREST: Final = 0.3
"""Metres: nearer, a D435 at this resolution measures nothing."""
LEAST: Final = 3
"""Points in a cell that fill it; fewer are noise."""
SPREAD: Final = 2.5
"""Deviations of the depth by which known things are grown, and beyond which a cell is looked through."""
POSE_GROWTH: Final = 0.01
"""Metres a metre: half a degree that the robot's heading may be off."""
UPRIGHT_SHARE: Final = 0.5
"""Of that growth, upwards: tilt is known by joints alone."""
FLOOR_GROWTH: Final = 0.005
"""Metres a metre, by which what counts as floor rises with the distance."""
DIAGONAL: Final = math.sqrt(3.0)
"""Of a cube with edges of 1."""
SHOWN: Final = 0.01
"""Share of the pixels with a depth below which a picture shows nothing."""

Depth = NDArray[np.float64]


@dataclass(frozen=True)
class MapJob:
    """One picture and what is known. ``size``: width and height that the camera has; ``range``: metres.

    ``last``: the picture before this one.
    """

    shot: Shot
    lattice: Lattice
    occupied: Numbers
    known: Known
    size: tuple[int, int]
    range: float = 4.0
    last: Sight | None = None


@dataclass(frozen=True)
class Mapped:
    """The numbers of the occupied cells, rising, and why the picture changed nothing, if so."""

    occupied: Numbers
    problem: str = ""
    sight: Sight | None = None
    """What to remember of the picture; None: it could not be read."""


@dataclass(frozen=True)
class _Hits:
    """Numbers of cells: with known things only, with anything unexplained, and with enough of it."""

    known: Numbers
    touched: Numbers
    filled: Numbers


def read_picture(job: MapJob) -> Mapped:
    """Return what is occupied after a picture."""
    try:
        image = decode(job.shot.payload)
    except ValueError as error:
        return Mapped(job.occupied, str(error))
    camera = compose(to_pose(job.shot.base_in_map), job.shot.camera_in_base)
    sight, wrong = judged(image, camera, job.last)
    if wrong:
        return Mapped(job.occupied, wrong, sight)
    return replace(integrate(job, image.header, image.depth.astype(np.float64) / 1000.0), sight=sight)


def integrate(job: MapJob, header: RgbdHeader, depth: Depth) -> Mapped:
    """Return what is occupied after a depth image (height, width), in metres; 0 or NaN: nothing measured."""
    if problem := unusable(depth, job.size):
        return Mapped(job.occupied, problem)
    base = to_pose(job.shot.base_in_map)
    camera = compose(base, job.shot.camera_in_base)
    hits = _hits(job, header, depth, camera)
    empty, reached = _looked_through(job, header, depth, camera)
    freed = empty & ~np.isin(job.occupied, hits.touched)
    freed |= (reached & np.isin(job.occupied, hits.known)) | _explained_cells(job, job.occupied)
    after = np.union1d(job.occupied[~freed], hits.filled)
    if len(after) > MOST_CELLS:
        after = _nearest(job.lattice, after, camera)
    return Mapped(after)


def unusable(depth: Depth, size: tuple[int, int]) -> str:
    """Return why a depth image (height, width) proves nothing, in words; nothing if it is good.

    Args:
        depth: metres; 0 or NaN where nothing was measured.
        size: width and height that the camera has.
    """
    height, width = depth.shape
    if (width, height) != size:
        return f"expected a depth image of {size[0]} x {size[1]}, found {width} x {height}"
    thin = depth[::STRIDE, ::STRIDE]
    numbers = np.isfinite(thin)
    if not numbers.any():
        return "expected depths in metres, found no number"
    if float(np.mean(np.where(numbers, thin, 0.0) > 0.0)) < SHOWN:
        return "expected a depth image, found zeros"
    return ""


def _hits(job: MapJob, header: RgbdHeader, depth: Depth, camera: Pose) -> _Hits:
    """Return the cells in which something is measured.

    What explains is asked for the mean of the points in each eighth of a cell: a tenth of the points.
    """
    thin = depth[::STRIDE, ::STRIDE]
    rows, columns = np.nonzero((thin > NEAREST) & (thin < job.range))  # NaN is neither
    z = thin[rows, columns]
    points = points_in(camera, back_project(header, columns * STRIDE, rows * STRIDE, z))
    numbers = job.lattice.halved.numbers(points)
    counts = (points[:, 2] > HEIGHTS[0] + FLOOR_GROWTH * z) & (points[:, 2] < HEIGHTS[1]) & (numbers >= 0)
    _, where, many = np.unique(numbers[counts], return_inverse=True, return_counts=True)
    sums = [np.bincount(where.reshape(-1), each[counts], len(many)) for each in (*points.T, z)]
    means = np.stack(sums, axis=1) / many[:, None]
    cells, index = np.unique(job.lattice.numbers(means[:, :3]), return_inverse=True)
    strange = ~_explained(means[:, :3], means[:, 3], job)
    points_of = np.bincount(index.reshape(-1), many, len(cells))
    strange_of = np.bincount(index.reshape(-1), many * strange, len(cells))
    return _Hits(
        known=cells[(strange_of == 0) & (points_of >= LEAST)],
        touched=cells[strange_of > 0],
        filled=cells[strange_of >= LEAST],
    )


def _explained(points: Matrix, z: Depth, job: MapJob) -> NDArray[np.bool_]:
    """Say which points, measured at ``z`` metres, belong to something that is known."""
    found = of_robot(points_from(to_pose(job.shot.base_in_map), points), job.known)
    growth = POSE_GROWTH * z + SPREAD * _sigma(z)
    level, upright = LEVEL_MARGIN + growth, UPRIGHT_MARGIN + UPRIGHT_SHARE * growth
    for box in (*job.known.furniture, *job.known.items):
        near = _near(points, box, float(level.max(initial=0.0)))
        if len(near):
            found[near] |= _inside(points[near], box, level[near], upright[near])
    return found


def _explained_cells(job: MapJob, numbers: Numbers) -> NDArray[np.bool_]:
    """Say which occupied cells an item explains that was recognised since, or the robot that stands there."""
    centres = job.lattice.centres(numbers)
    in_base = points_from(to_pose(job.shot.base_in_map), centres)
    half = job.lattice.resolution / 2.0
    found = np.hypot(in_base[:, 0], in_base[:, 1]) < job.known.body_radius - half
    level = np.full(len(numbers), LEVEL_MARGIN + half)
    for box in job.known.items:
        near = _near(centres, box, LEVEL_MARGIN + half)
        found[near] |= _inside(centres[near], box, level[near], level[near])
    return found


def _looked_through(
    job: MapJob, header: RgbdHeader, depth: Depth, camera: Pose
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Say which occupied cells the picture shows to be empty, and into which at least it looks.

    Of an empty one, the middle and four sides are looked through.
    """
    numbers, half = job.occupied, job.lattice.resolution / 2.0
    empty, reached = np.zeros(len(numbers), np.bool_), np.zeros(len(numbers), np.bool_)
    centres = points_from(camera, job.lattice.centres(numbers))
    ahead = np.flatnonzero((centres[:, 2] > NEAREST) & (centres[:, 2] < job.range))
    x, y, z = centres[ahead].T
    beyond = z + DIAGONAL * half + SPREAD * _sigma(z)
    measured = [
        _at(header, depth, x + right, y + down, z)
        for right, down in ((0.0, 0.0), (half, 0.0), (-half, 0.0), (0.0, half), (0.0, -half))
    ]
    empty[ahead] = np.all(np.array(measured) > beyond, axis=0)
    reached[ahead] = measured[0] > z - half
    return empty, reached


def _at(header: RgbdHeader, depth: Depth, x: Depth, y: Depth, z: Depth) -> Depth:
    """Return the depths measured towards points of the camera's frame; 0 or NaN where there are none."""
    columns = np.rint(header.fx * x / z + header.cx).astype(np.int64)
    rows = np.rint(header.fy * y / z + header.cy).astype(np.int64)
    shown = (columns >= 0) & (columns < header.width) & (rows >= 0) & (rows < header.height)
    return np.where(shown, depth[np.where(shown, rows, 0), np.where(shown, columns, 0)], 0.0)


def _nearest(lattice: Lattice, numbers: Numbers, camera: Pose) -> Numbers:
    """Return as many cells as a message holds: those nearest to the camera."""
    away = np.linalg.norm(lattice.centres(numbers) - np.array(camera.position), axis=1)
    return np.sort(numbers[np.argsort(away, kind="stable")[:MOST_CELLS]])


def _near(points: Matrix, box: Box, margin: float) -> NDArray[np.int64]:
    reach = float(np.linalg.norm(box.size)) / 2.0 + margin
    away = np.abs(points - np.array(box.pose.position))
    return np.flatnonzero((away[:, 0] < reach) & (away[:, 1] < reach) & (away[:, 2] < reach))


def _inside(points: Matrix, box: Box, level: Depth, upright: Depth) -> NDArray[np.bool_]:
    away = np.abs(points_from(box.pose, points)) - np.array(box.size) / 2.0
    return np.asarray((away[:, 0] <= level) & (away[:, 1] <= level) & (away[:, 2] <= upright), np.bool_)


def _sigma(z: Depth) -> Depth:
    """Return the deviations (m) of depths at ``z`` metres: ``depth.sigma`` for many."""
    return np.asarray(0.0012 + 0.0019 * (z - 0.4) ** 2, np.float64)
