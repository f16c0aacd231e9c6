"""Spheres of a checker's moving bodies: they cover them, and go where pinocchio puts them."""

from __future__ import annotations

import coal
import numpy as np
import pinocchio as pin
import pytest

from tandem.skills.kinematics.bodies import BoxShape, Carried
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.moving_spheres import MovingSpheres, cover
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.pose import Pose
from tests.fakes.arm_rig import PANDA_HOME, panda

JOINTS = panda().group("arm").joints
HOME = dict(zip(JOINTS, PANDA_HOME, strict=True))
HELD = Carried("tray", BoxShape((0.2, 0.3, 0.02)), "panda_hand_tcp", Pose(position=(0.05, 0.0, 0.0)), ())
SPREAD = np.array(PANDA_HOME) + np.random.default_rng(2).normal(0.0, 0.4, (4, 7))


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    return load_hulls(panda())


@pytest.fixture(scope="module")
def checker(hulls: RobotHulls) -> CollisionChecker:
    return CollisionChecker(hulls, JOINTS, HOME, carried=[HELD])


@pytest.fixture(scope="module")
def spheres(checker: CollisionChecker) -> MovingSpheres:
    return checker.spheres()


@pytest.mark.parametrize("shape", [coal.Box(0.3, 0.2, 0.02), coal.Cylinder(0.05, 0.4), coal.Sphere(0.07)])
def test_all_of_a_body_is_covered(shape: coal.CollisionGeometry) -> None:
    shape.computeLocalAABB()
    placed = pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.2, 0.9), np.array([0.1, 0.2, 0.3]))
    found = cover(pin.GeometryObject("body", 1, placed, shape))
    box = shape.aabb_local
    inside = np.random.default_rng(1).uniform(np.array(box.min_), np.array(box.max_), (500, 3))
    at = inside @ np.array(placed.rotation).T + np.array(placed.translation)
    away = np.linalg.norm(at[:, None] - found.centres, axis=2)
    assert np.all(away.min(axis=1) <= found.radius + 1e-9)


def test_the_hand_and_what_it_holds_are_where_pinocchio_puts_them(
    checker: CollisionChecker, spheres: MovingSpheres
) -> None:
    for q, centres in zip(SPREAD, spheres.centres(SPREAD), strict=True):
        tray = checker.chain.placement(q, "panda_hand_tcp").act(np.array([0.05, 0.0, 0.0]))
        # The tray's spheres are the last ones, and symmetric about its middle.
        count = len(cover_of_tray().centres)
        assert np.allclose(centres[-count:].mean(axis=0), tray, atol=1e-9)


def cover_of_tray() -> object:
    shape = coal.Box(0.2, 0.3, 0.02)
    shape.computeLocalAABB()
    return cover(pin.GeometryObject("tray", 1, pin.SE3.Identity(), shape))


def test_forces_push_the_joints_as_finite_differences_say(spheres: MovingSpheres) -> None:
    forces = np.random.default_rng(3).normal(size=(len(SPREAD), len(spheres.radii), 3))
    found = spheres.pull(SPREAD, forces)
    for k in range(7):
        turn = np.zeros(7)
        turn[k] = 1e-6
        moved: Array = (spheres.centres(SPREAD + turn) - spheres.centres(SPREAD - turn)) / 2e-6
        assert np.allclose(found[:, k], (moved * forces).sum(axis=(1, 2)), atol=1e-6)


def test_no_centre_leaves_the_box(hulls: RobotHulls, spheres: MovingSpheres) -> None:
    limits = hulls.robot.limits(JOINTS)
    q = np.random.default_rng(4).uniform(limits.lower, limits.upper, (300, 7))
    low, high = spheres.box
    centres = spheres.centres(q)
    assert np.all(centres >= low)
    assert np.all(centres <= high)


def test_bodies_that_a_joint_connects_are_no_pair(spheres: MovingSpheres) -> None:
    one, other = spheres.pairs
    at = spheres.centres(np.array([PANDA_HOME]))[0]
    apart = np.linalg.norm(at[one] - at[other], axis=1) - spheres.radii[one] - spheres.radii[other]
    assert len(one) > 0
    assert np.median(apart) > 0.1
