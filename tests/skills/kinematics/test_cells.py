"""Cells of occupied space as one body: an octree says what a box of each cell would."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.geometry.poses import compose, transform
from tandem.skills.kinematics.bodies import BoxShape, CellsShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.distance_field import DistanceField
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.proximity import Proximity
from tandem.skills.ports.pose import Pose
from tests.fakes.arm_rig import PANDA_HOME, panda

JOINTS = panda().group("arm").joints
EDGE = 0.05
MAP_IN_BASE = Pose(position=(0.4, -0.1, 0.02), orientation=(0.0, 0.0, math.sin(0.2), math.cos(0.2)))


def cells(count: int, seed: int) -> np.ndarray:
    """Return centres in the map, on a lattice whose corner is nothing special."""
    index = np.unique(np.random.default_rng(seed).integers(-8, 9, (count, 3)), axis=0)
    return np.array([0.013, -0.021, 0.42]) + (index + 0.5) * EDGE


def as_octree(centres: np.ndarray) -> Obstacle:
    shape, frame = CellsShape.of(centres, EDGE)
    return Obstacle("occupied", shape, compose(MAP_IN_BASE, Pose(position=frame)))


def as_boxes(centres: np.ndarray) -> tuple[Obstacle, ...]:
    turned = MAP_IN_BASE.orientation
    return tuple(
        Obstacle(
            f"box_{k}", BoxShape((EDGE,) * 3), Pose(position=transform(MAP_IN_BASE, at), orientation=turned)
        )
        for k, at in enumerate(centres)
    )


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    return load_hulls(panda())


@pytest.mark.parametrize("count", [1, 3, 25])
def test_an_octree_is_hit_where_a_box_of_each_cell_is(hulls: RobotHulls, count: int) -> None:
    rng, centres = np.random.default_rng(5), cells(count, 2)
    tree = CollisionChecker(hulls, JOINTS, {}, (as_octree(centres),))
    boxes = CollisionChecker(hulls, JOINTS, {}, as_boxes(centres))
    states = [np.array(PANDA_HOME) + rng.normal(scale=0.7, size=7) for _ in range(80)]
    free = [tree.free(q) for q in states]
    assert free == [boxes.free(q) for q in states]
    assert count < 25 or 0 < sum(free) < len(free)


def test_what_is_near_an_octree_is_as_near_as_to_its_cells(hulls: RobotHulls) -> None:
    centres, q = cells(12, 3), hulls.robot.configuration(dict(zip(JOINTS, PANDA_HOME, strict=True)))
    tree = Proximity(hulls, JOINTS, (), (as_octree(centres),))
    boxes = Proximity(hulls, JOINTS, (), as_boxes(centres))
    near = [each.look(q, np.full(each.pairs, 0.6)) for each in (tree, boxes)]
    assert near[0].distance.min() == pytest.approx(near[1].distance.min(), abs=1e-4)


def test_the_field_takes_cells_for_voxels_and_lets_them_go() -> None:
    centres, field = cells(12, 4), DistanceField((0.0, -0.6, 0.0), (1.0, 0.6, 1.0))
    field.set_obstacles((as_octree(centres),))
    inside = np.array([transform(MAP_IN_BASE, at) for at in centres])
    inside = inside[field.inside(inside)]
    assert len(inside) > 3
    assert np.all(field.distances(inside) < 0.0)
    assert field.set_obstacles((as_octree(centres),)) == 0
    field.set_obstacles(())
    assert np.all(field.distances(inside) == pytest.approx(field.reach))
