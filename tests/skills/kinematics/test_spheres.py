"""Balls that cover a body hold all of it; balls within it stay within."""

from __future__ import annotations

import coal
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.spheres import ENOUGH, MOST, SphereModel, Spheres, model, outer
from tandem.skills.kinematics.transforms import Array

LENGTH = st.floats(0.01, 0.4)


def inside(shape: coal.CollisionGeometry, count: int = 3000) -> Array:
    """Return points of the body, most of them on its surface: mixtures of two and three of its corners."""
    rng = np.random.default_rng(0)
    if isinstance(shape, coal.Sphere):
        rays = rng.normal(size=(count, 3))
        return shape.radius * rays / np.linalg.norm(rays, axis=1, keepdims=True)
    if isinstance(shape, coal.Cylinder):
        angle, height = rng.uniform(0, 2 * np.pi, count), rng.uniform(-1, 1, count) * shape.halfLength
        height[::2] = np.sign(height[::2]) * shape.halfLength
        radius = np.where(np.arange(count) % 2, 1.0, np.sqrt(rng.uniform(size=count))) * shape.radius
        return np.column_stack((radius * np.cos(angle), radius * np.sin(angle), height))
    corners = outer(shape).corners
    mixed = rng.dirichlet(np.full(3, 0.7), count)
    chosen = corners[rng.integers(len(corners), size=(count, 3))]
    return np.concatenate((corners, np.einsum("ij,ijk->ik", mixed, chosen)))


def covers(spheres: Spheres, points: Array) -> bool:
    apart = np.linalg.norm(points[:, None] - spheres.centres, axis=2)
    return bool(np.all((apart <= spheres.radii + 1e-9).any(axis=1)))


def stays_within(spheres: Spheres, shape: coal.CollisionGeometry) -> bool:
    """Say whether no point of the balls is outside of the body."""
    if isinstance(shape, coal.Sphere):
        return bool(np.all(np.linalg.norm(spheres.centres, axis=1) + spheres.radii <= shape.radius + 1e-9))
    if isinstance(shape, coal.Cylinder):
        side = np.hypot(spheres.centres[:, 0], spheres.centres[:, 1]) + spheres.radii <= shape.radius + 1e-9
        ends = np.abs(spheres.centres[:, 2]) + spheres.radii <= shape.halfLength + 1e-9
        return bool(np.all(side & ends))
    return bool(np.all(outer(shape).depth(spheres.centres) >= spheres.radii - 1e-9))


def holds(found: SphereModel, shape: coal.CollisionGeometry) -> None:
    points = inside(shape)
    for spheres in (found.one, found.few, found.covering):
        assert covers(spheres, points)
    assert stays_within(found.within, shape)
    assert len(found.within.radii) > 0


@pytest.mark.parametrize("name", ["panda", "tiago_dual", "locobot"])
def test_each_link_is_covered_and_its_inner_balls_are_within(name: str) -> None:
    hulls = load_hulls(robot_model(name).description)
    for k, body in enumerate(hulls.geometry.geometryObjects):
        holds(hulls.balls(k), body.geometry)


@settings(max_examples=25, deadline=None)
@given(LENGTH, LENGTH, LENGTH)
def test_each_box_is_covered(x: float, y: float, z: float) -> None:
    holds(model(coal.Box(x, y, z)), coal.Box(x, y, z))


@settings(max_examples=15, deadline=None)
@given(LENGTH, LENGTH)
def test_each_cylinder_is_covered(radius: float, length: float) -> None:
    holds(model(coal.Cylinder(radius, length)), coal.Cylinder(radius, length))


def test_balls_end_where_it_is_enough_or_there_are_many() -> None:
    small, large = coal.Box(0.012, 0.012, 0.012), coal.Box(0.3, 0.3, 0.3)
    body = outer(small)
    found = model(small).covering
    assert np.all(found.radii - body.depth(found.centres) <= ENOUGH + 1e-5)
    assert len(found.radii) < len(model(large).covering.radii) == MOST


def test_bodies_of_one_form_share_their_balls() -> None:
    hulls: RobotHulls = load_hulls(robot_model("panda").description)
    fingers = [k for k, link in enumerate(hulls.links) if link.endswith("finger_link")]
    assert hulls.balls(fingers[0]) is hulls.balls(fingers[1])
