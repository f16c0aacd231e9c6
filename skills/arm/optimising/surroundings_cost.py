"""The cost of what stands around, made of a collision checker's world."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from typing import Final

import numpy as np

from tandem.skills.arm.optimising.obstacle_cost import ObstacleCost
from tandem.skills.kinematics.bodies import BoxShape, CellsShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.distance_field import REACH, DistanceField
from tandem.skills.kinematics.transforms import Array, to_se3

MAKING: Final = 100
"""Units of making the spheres."""
AT_ONCE: Final = 1
"""Obstacles that are measured between two chances to be stopped."""
CELLS_A_UNIT: Final = 2_000
"""Cells that are measured in a unit's time."""


def around(
    checker: CollisionChecker, weights: Array, ends: Array, margin: float
) -> Generator[int, None, ObstacleCost]:
    """Return the cost of the checker's obstacles, of the robot's other parts, and of its own links.

    What the spheres say of the robot itself is left out where they touch at all the ends, which are known
    to be free: there they are larger than what they stand for.

    Args:
        checker: the world.
        weights: of the joints (n,).
        ends: free joint positions (k, n): where paths begin and end.
        margin: metres from which on nearness costs something.

    Yields:
        Units of work.
    """
    spheres = checker.spheres()
    radii = spheres.radii
    low, high = spheres.box
    yield MAKING
    robot = yield from _field(spheres.standing, low, high)
    field = yield from _field(checker.obstacles, low, high)
    at_ends = spheres.centres(ends)
    touch = robot.distances(at_ends.reshape(-1, 3)).reshape(len(ends), -1) < radii
    one, other = spheres.pairs
    apart = np.linalg.norm(at_ends[:, one] - at_ends[:, other], axis=-1)
    meet = np.all(apart < radii[one] + radii[other], axis=0)
    return ObstacleCost(
        field=field,
        robot=robot,
        spheres=spheres,
        weights=weights,
        margin=margin,
        watched=spheres.watched & ~np.all(touch, axis=0),
        pairs=(one[~meet], other[~meet]),
    )


def _field(obstacles: Sequence[Obstacle], low: Array, high: Array) -> Generator[int, None, DistanceField]:
    """Return the distances to obstacles, as far as what moves between the corners can come near them."""
    boxes = [_box(each) for each in obstacles]
    if boxes:
        low = np.maximum(low, np.min([each[0] for each in boxes], axis=0) - REACH)
        high = np.minimum(high, np.max([each[1] for each in boxes], axis=0) + REACH)
    if not boxes or np.any(high <= low):
        return DistanceField(low, low + REACH)
    field = DistanceField(low, high)
    for last in range(AT_ONCE, len(obstacles) + AT_ONCE, AT_ONCE):
        cells = field.set_obstacles(obstacles[:last])  # those that it has already cost nothing
        yield 1 + cells // CELLS_A_UNIT
    return field


def _box(each: Obstacle) -> tuple[Array, Array]:
    """Return the corners of the upright box about an obstacle, padding included."""
    sideways, along = each.padding
    if isinstance(each.shape, BoxShape | CellsShape):
        half = np.array(each.shape.size) / 2.0
    else:
        half = np.array([each.shape.radius, each.shape.radius, each.shape.length / 2.0])
    placed = to_se3(each.pose_in_base)
    extent = np.abs(np.array(placed.rotation)) @ (half + np.array([sideways, sideways, along]))
    centre = np.array(placed.translation)
    return centre - extent, centre + extent
