"""A checker's moving bodies as spheres: where they are in many configurations at once, and what pushes them.

Each body is covered by equal spheres about the cells of a grid over its bounding box. So a sphere that is
free proves nothing wrong, but one that touches may be a corner in which nothing is: what optimises by
spheres has its result checked by the exact bodies.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.bodies import BoxShape, Obstacle
from tandem.skills.kinematics.transforms import Array, to_pose

Numbers = npt.NDArray[np.int_]
MOST: Final = 6
"""Spheres of a body: twice as many cost twice as much, and paths are checked by the exact bodies anyway."""
SMALLEST_CELL: Final = 0.03
"""Metres: a body's cells are as long as its least edge, but no shorter."""


@dataclass(frozen=True)
class Cover:
    """Spheres in a joint's frame: centres (s, 3), one radius (m)."""

    centres: Array
    radius: float


def cover(body: pin.GeometryObject) -> Cover:
    """Return spheres about all of a body, in the frame of the joint that carries it."""
    box = body.geometry.aabb_local
    low, high = np.array(box.min_), np.array(box.max_)
    edges = high - low
    cell = max(float(np.min(edges)), SMALLEST_CELL)
    counts = _cells(edges, cell)
    while counts.prod() > MOST:
        cell *= 1.05
        counts = _cells(edges, cell)
    steps = edges / counts
    axes = [low[k] + (np.arange(counts[k]) + 0.5) * steps[k] for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    placed = body.placement
    return Cover(
        grid @ np.array(placed.rotation).T + np.array(placed.translation), 0.5 * float(np.linalg.norm(steps))
    )


def _cells(edges: Array, cell: float) -> Numbers:
    return np.maximum(np.ceil(edges / cell - 1e-9), 1.0).astype(int)


class MovingSpheres:
    """Spheres of the bodies that the joints of one reduced model move.

    Args:
        model: the joints that move, each of one number.
        geometry: the bodies, and the pairs of them that must not meet.
        columns: for each joint of the model, its place in the arrays of positions (m, n).
        world: number of the first body that stands around: these have no spheres.
    """

    def __init__(self, model: pin.Model, geometry: pin.GeometryModel, columns: Numbers, world: int) -> None:
        self._columns = columns
        self._parents = [int(model.parents[j]) - 1 for j in range(1, model.njoints)]
        placed = [model.jointPlacements[j].homogeneous for j in range(1, model.njoints)]
        self._turning, self._axes = _axes(model)
        first, second = np.zeros((len(placed), 4, 4)), np.zeros((len(placed), 4, 4))
        for k, axis in enumerate(self._axes):
            if self._turning[k]:
                first[k, :3, :3] = pin.skew(axis)
                second[k, :3, :3] = pin.skew(axis) @ pin.skew(axis)
            else:
                first[k, :3, 3] = axis
        self._a = np.array(placed)
        self._b, self._c = self._a @ first, self._a @ second
        self._gather(geometry, world)
        carries = np.zeros((len(placed), len(placed)), dtype=bool)
        for k, parent in enumerate(self._parents):
            carries[k, k] = True
            if parent >= 0:
                carries[:, k] |= carries[:, parent]
        self._carries: npt.NDArray[np.float64] = carries[:, self._joint].astype(float)

        self.box: tuple[Array, Array] = self._reached(model)
        """Corners (3,) and (3,) of a box that the centres can't leave."""

    def _reached(self, model: pin.Model) -> tuple[Array, Array]:
        """Return the box about balls as large as all links to each sphere are long."""
        roots, reach = np.zeros((len(self._parents), 3)), np.zeros(len(self._parents))
        for k, parent in enumerate(self._parents):
            index = model.joints[k + 1].idx_q
            ends = model.lowerPositionLimit[index], model.upperPositionLimit[index]
            along = 0.0 if self._turning[k] else float(np.max(np.abs(ends)))
            roots[k] = self._a[k, :3, 3] if parent < 0 else roots[parent]
            way = 0.0 if parent < 0 else reach[parent] + float(np.linalg.norm(self._a[k, :3, 3]))
            reach[k] = way + along
        far = (reach[self._joint] + np.linalg.norm(self._local, axis=1))[:, None]
        return np.min(roots[self._joint] - far, axis=0), np.max(roots[self._joint] + far, axis=0)

    def _gather(self, geometry: pin.GeometryModel, world: int) -> None:
        bodies = list(geometry.geometryObjects)[:world]
        moving = [k for k, body in enumerate(bodies) if int(body.parentJoint) > 0]
        covers = {k: cover(bodies[k]) for k in moving}
        numbers, begin = {}, 0
        for k in moving:
            numbers[k] = np.arange(begin, begin + len(covers[k].centres))
            begin += len(covers[k].centres)
        self._local = np.concatenate([covers[k].centres for k in moving])
        self._joint = np.concatenate(
            [np.full(len(covers[k].centres), int(bodies[k].parentJoint) - 1) for k in moving]
        )
        self.radii: Array = np.concatenate(
            [np.full(len(covers[k].centres), covers[k].radius) for k in moving]
        )
        """Metres, (s,)."""
        ones, others = [np.zeros(0, dtype=np.int_)], [np.zeros(0, dtype=np.int_)]
        self.watched: npt.NDArray[np.bool_] = np.zeros(len(self.radii), dtype=bool)
        """Which spheres must not meet what of the robot stands still, (s,)."""
        still: set[int] = set()
        for pair in geometry.collisionPairs:
            one, other = sorted((int(pair.first), int(pair.second)), key=lambda k: k not in covers)
            if max(one, other) >= world:
                continue
            if other in covers:
                grid = np.meshgrid(numbers[one], numbers[other], indexing="ij")
                ones.append(grid[0].ravel())
                others.append(grid[1].ravel())
            else:
                self.watched[numbers[one]] = True
                still.add(other)
        self.pairs: tuple[Numbers, Numbers] = np.concatenate(ones), np.concatenate(others)
        """Numbers of the spheres (k,) and (k,) that must not meet each other."""
        self.standing: tuple[Obstacle, ...] = tuple(_boxed(bodies[k]) for k in sorted(still))
        """Boxes about what of the robot stands still and may be met."""

    def _frames(self, q: Array) -> Array:
        """Return the joints' frames (m, n, 4, 4) in the base."""
        at = q[:, self._columns]
        one = np.where(self._turning, np.sin(at), at)[:, :, None, None]
        two = np.where(self._turning, 1.0 - np.cos(at), 0.0)[:, :, None, None]
        steps = self._a + one * self._b + two * self._c
        for k, parent in enumerate(self._parents):
            if parent >= 0:
                steps[:, k] = steps[:, parent] @ steps[:, k]
        return np.asarray(steps)

    def centres(self, q: Array) -> Array:
        """Return the centres (m, s, 3) in the base at joint positions (m, n)."""
        return self._centres(self._frames(q))

    def _centres(self, frames: Array) -> Array:
        mine = frames[:, self._joint]
        turned = np.matmul(mine[..., :3, :3], self._local[:, :, None])[..., 0]
        return np.asarray(turned + mine[..., :3, 3])

    def pull(self, q: Array, forces: Array) -> Array:
        """Return J^T f: what forces (m, s, 3) at the centres do to the joints, (m, n)."""
        frames = self._frames(q)
        force = self._carries @ forces
        moment = self._carries @ _cross(self._centres(frames), forces)
        axes = np.einsum("mkij,kj->mki", frames[..., :3, :3], self._axes)
        about = moment - _cross(frames[..., :3, 3], force)
        along = np.where(self._turning, np.sum(axes * about, axis=-1), np.sum(axes * force, axis=-1))
        pulled = np.zeros((len(q), q.shape[1]))
        pulled[:, self._columns] = along
        return pulled


def _boxed(body: pin.GeometryObject) -> Obstacle:
    """Return the box about a body that stands still."""
    box = body.geometry.aabb_local
    low, high = np.array(box.min_), np.array(box.max_)
    placed = body.placement * pin.SE3(np.eye(3), 0.5 * (low + high))
    x, y, z = map(float, high - low)
    return Obstacle(body.name, BoxShape((x, y, z)), to_pose(placed))


def _axes(model: pin.Model) -> tuple[npt.NDArray[np.bool_], Array]:
    """Return which joints turn, and the joints' unit axes (n, 3) in their own frames."""
    turning, axes = [], []
    for j in range(1, model.njoints):
        data = model.joints[j].createData()
        model.joints[j].calc(data, np.zeros(1))
        column = np.array(data.S).reshape(6)
        turns = bool(np.linalg.norm(column[3:]) > 0.5)  # noqa: PLR2004 - one of the two is of length one
        turning.append(turns)
        axes.append(column[3:] if turns else column[:3])
    return np.array(turning), np.array(axes)


def _cross(a: Array, b: Array) -> Array:
    """Return a x b over the last axis (numpy's own is slow for small arrays)."""
    product = np.empty(np.broadcast_shapes(a.shape, b.shape))
    product[..., 0] = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    product[..., 1] = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    product[..., 2] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return product
