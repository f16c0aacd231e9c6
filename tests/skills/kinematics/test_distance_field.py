"""The distance field against coal, and against itself when things change."""

from __future__ import annotations

import math

import coal
import numpy as np
import pytest

from tandem.skills.kinematics.bodies import BoxShape, CylinderShape, Obstacle, geometry
from tandem.skills.kinematics.distance_field import HALF_DIAGONAL, DistanceField
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.pose import Pose

LOW, HIGH = (-0.5, -0.5, 0.0), (0.5, 0.5, 0.8)
TURNED = (0.0, 0.0, math.sin(0.35), math.cos(0.35))
TILTED = (math.sin(0.3), 0.0, 0.0, math.cos(0.3))
BOARD = Obstacle("board", BoxShape((0.6, 0.3, 0.03)), Pose(position=(0.1, 0.0, 0.4)), (0.015, 0.003))
CRATE = Obstacle("crate", BoxShape((0.2, 0.3, 0.1)), Pose(position=(-0.2, 0.2, 0.2), orientation=TURNED))
TIN = Obstacle("tin", CylinderShape(0.05, 0.2), Pose(position=(0.3, -0.3, 0.3), orientation=TILTED))


def field(*obstacles: Obstacle, cell: float = 0.02) -> DistanceField:
    made = DistanceField(LOW, HIGH, cell=cell)
    made.set_obstacles(obstacles)
    return made


def points(count: int = 400, seed: int = 0) -> Array:
    return np.random.default_rng(seed).uniform(LOW, np.array(HIGH) - 1e-9, (count, 3))


def by_coal(obstacles: tuple[Obstacle, ...], at: Array) -> Array:
    """Return the distances (n,) of points to the nearest obstacle; below zero: inside."""
    ball, found = coal.Sphere(1e-6), np.full(len(at), np.inf)
    for each in obstacles:
        placed = to_se3(each.pose_in_base)
        there = coal.Transform3s(placed.rotation, placed.translation)
        for k, point in enumerate(at):
            here = coal.Transform3s(np.eye(3), point)
            result = coal.DistanceResult()
            shape = geometry(each.shape, each.padding)
            found[k] = min(found[k], coal.distance(ball, here, shape, there, coal.DistanceRequest(), result))
    return found


def to_cubes(centres: Array, edge: float, at: Array) -> Array:
    """Return the distances (n,) of points to the nearest cube, 0 inside."""
    gaps = np.maximum(np.abs(at[:, None] - centres) - edge / 2.0, 0.0)
    return np.asarray(np.linalg.norm(gaps, axis=2).min(axis=1))


@pytest.mark.parametrize("obstacles", [(BOARD,), (CRATE,), (TIN,), (BOARD, CRATE, TIN)])
def test_bounds_enclose_what_coal_measures(obstacles: tuple[Obstacle, ...]) -> None:
    made, at = field(*obstacles), points()
    true = by_coal(obstacles, at)
    assert np.all(made.lower_bounds(at) <= np.minimum(true, made.reach) + 1e-5)
    assert np.all(made.upper_bounds(at) >= true - 1e-5)


def test_interpolation_errs_by_no_more_than_it_says() -> None:
    made, at = field(BOARD, CRATE, TIN), points()
    true = np.clip(by_coal((BOARD, CRATE, TIN), at), -made.reach, made.reach)
    assert np.max(np.abs(made.distances(at) - true)) <= HALF_DIAGONAL * made.cell


def test_a_wall_costs_half_a_cell() -> None:
    wall = Obstacle("wall", BoxShape((0.1, 2.0, 2.0)), Pose(position=(0.0, 0.0, 0.4)))
    at = points()
    at[:, 0] = np.abs(at[:, 0]) * 0.2 + 0.05
    made = field(wall)
    assert np.all(made.lower_bounds(at) >= at[:, 0] - 0.05 - made.cell - 1e-4)


def test_gradients_are_those_of_the_interpolation() -> None:
    made, at, step = field(BOARD, CRATE), points(), 1e-5
    between = (at - made.low) / made.cell - 0.5
    at = at[np.all(np.abs(between - np.round(between)) > 0.01, axis=1)]
    moved = [
        (made.distances(at + step * axis) - made.distances(at - step * axis)) / (2 * step)
        for axis in np.eye(3)
    ]
    inner = np.all((at > made.low + made.cell) & (at < made.high - made.cell), axis=1)
    assert np.allclose(made.gradients(at)[inner], np.stack(moved, axis=1)[inner], atol=1e-3)


def test_gradients_lead_away_from_a_box() -> None:
    above, beside = field(BOARD).gradients(np.array([[0.1, 0.0, 0.5], [0.48, 0.0, 0.4]]))
    assert np.allclose(above, (0.0, 0.0, 1.0), atol=0.01)
    assert np.allclose(beside, (1.0, 0.0, 0.0), atol=0.01)


def test_what_changes_is_measured_anew_as_if_all_had_been() -> None:
    moved = Obstacle("crate", CRATE.shape, Pose(position=(0.1, 0.1, 0.3)))
    changed, fresh = field(BOARD, CRATE, TIN), field(moved, TIN)
    cells = changed.set_obstacles((moved, TIN))
    assert np.array_equal(changed.samples, fresh.samples)
    assert np.allclose(changed.least, fresh.least)
    assert 0 < cells < changed.samples.size * 2


def test_what_stays_costs_nothing() -> None:
    assert field(BOARD, TIN).set_obstacles((TIN, BOARD)) == 0


def test_voxels_that_fit_the_cells_are_exact_at_the_centres() -> None:
    made = DistanceField(LOW, HIGH, cell=0.025)
    centres = np.array([[0.025, 0.025, 0.425], [0.075, 0.025, 0.425], [-0.325, 0.275, 0.125]])
    made.set_voxels(centres, 0.05)
    at = np.stack(np.meshgrid(*(np.arange(n) for n in made.shape), indexing="ij"), axis=-1).reshape(-1, 3)
    true = np.minimum(to_cubes(centres, 0.05, made.low + (at + 0.5) * made.cell), made.reach)
    outside = true > 0.0
    assert np.allclose(made.samples.reshape(-1)[outside], true[outside], atol=1e-6)
    assert np.all(made.samples.reshape(-1)[~outside] < 0.0)


def test_voxels_anywhere_are_never_nearer_than_the_lower_bound() -> None:
    made, at = DistanceField(LOW, HIGH), points()
    centres = points(30, seed=3)
    made.set_voxels(centres, 0.05)
    assert np.all(made.lower_bounds(at) <= to_cubes(centres, 0.05, at) + 1e-6)


def test_voxels_that_go_leave_nothing_behind() -> None:
    made, fresh = field(BOARD), field(BOARD)
    made.set_voxels(points(30, seed=3), 0.05)
    made.set_voxels(points(2, seed=4), 0.05)
    fresh.set_voxels(points(2, seed=4), 0.05)
    assert np.allclose(made.samples, fresh.samples)
    assert np.allclose(made.least, fresh.least)
    assert made.set_voxels(points(2, seed=4), 0.05) == 0


@pytest.mark.parametrize(("occupied", "distance"), [(True, -0.025), (False, 0.16)])
def test_unknown_voxels_count_as_configured(*, occupied: bool, distance: float) -> None:
    made = DistanceField(LOW, HIGH, cell=0.05, unknown_occupied=occupied)
    made.set_voxels(np.empty((0, 3)), 0.05, unknown=np.array([[0.025, 0.025, 0.425]]))
    assert made.distances(np.array([[0.025, 0.025, 0.425]]))[0] == pytest.approx(distance)


def test_outside_the_grid_nothing_is_proven() -> None:
    made, far = field(BOARD), np.array([[3.0, 0.0, 0.4]])
    assert made.lower_bounds(far)[0] == -np.inf
    assert made.upper_bounds(far)[0] == np.inf
    assert made.distances(far)[0] == pytest.approx(made.distances(np.array([[0.5, 0.0, 0.4]]))[0])


@pytest.mark.parametrize(("high", "cell", "reach"), [(LOW, 0.02, 0.1), (HIGH, 0.0, 0.1), (HIGH, 0.02, -1.0)])
def test_what_makes_no_grid_is_refused(high: tuple[float, float, float], cell: float, reach: float) -> None:
    with pytest.raises(ValueError, match="no grid"):
        DistanceField(LOW, high, cell=cell, reach=reach)
