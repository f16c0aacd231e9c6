"""Distances, their gradients, and that none is missed."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.kinematics.bodies import BoxShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.proximity import Proximity
from tandem.skills.ports.pose import Pose
from tests.fakes.arm_rig import PANDA_HOME, panda

JOINTS = panda().group("arm").joints
BOXES = tuple(
    Obstacle(
        f"box_{k}", BoxShape((0.07, 0.07, 0.2)), Pose(position=(0.3 + 0.1 * (k % 3), -0.4 + 0.2 * k, 0.3))
    )
    for k in range(5)
)


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    return load_hulls(panda())


def full(hulls: RobotHulls, q: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
    return hulls.robot.configuration(dict(zip(JOINTS, map(float, q), strict=True)))


def test_gradients_are_those_of_the_distances(hulls: RobotHulls) -> None:
    near = Proximity(hulls, JOINTS, (), BOXES)
    within, step = np.full(near.pairs, 0.15), 2e-4
    q = np.array(PANDA_HOME) + np.array([0.2, 0.3, -0.1, 0.1, 0.2, 0.0, 0.0])
    here = near.look(full(hulls, q), within)
    assert len(here.distance) > 3
    for k in range(len(JOINTS)):
        ahead = q.copy()
        ahead[k] += step
        there = near.look(full(hulls, ahead), within)
        moved = dict(zip(there.pair.tolist(), there.distance.tolist(), strict=True))
        for row, pair in enumerate(here.pair.tolist()):
            if pair in moved:
                slope = (moved[pair] - here.distance[row]) / step
                assert here.gradient[row, k] == pytest.approx(slope, abs=0.02)


def test_no_look_misses_what_is_near(hulls: RobotHulls) -> None:
    near, rng = Proximity(hulls, JOINTS, (), BOXES), np.random.default_rng(3)
    within, q = np.full(near.pairs, 0.1), np.array(PANDA_HOME)
    for _ in range(60):
        q = q + rng.normal(scale=0.05, size=len(q))
        kept = near.look(full(hulls, q), within)
        fresh = Proximity(hulls, JOINTS, (), BOXES).look(full(hulls, q), within)
        assert kept.pair.tolist() == fresh.pair.tolist()
        assert np.allclose(kept.distance, fresh.distance, atol=1e-5)


def test_it_agrees_with_the_collision_checker(hulls: RobotHulls) -> None:
    near, rng = Proximity(hulls, JOINTS, (), BOXES), np.random.default_rng(4)
    checker = CollisionChecker(hulls, JOINTS, {}, BOXES)
    for _ in range(40):
        q = np.array(PANDA_HOME) + rng.normal(scale=0.6, size=len(JOINTS))
        free = near.hits(full(hulls, q), np.zeros(near.pairs)) is None
        assert free is checker.free(q)


def test_an_obstacle_that_moves_is_found_where_it_is(hulls: RobotHulls) -> None:
    near, q = Proximity(hulls, JOINTS, (), BOXES[:1]), full(hulls, np.array(PANDA_HOME))
    within = np.full(near.pairs, 0.05)
    before = near.look(q, within)
    tool = hulls.robot.pose("panda_hand_tcp", dict(zip(JOINTS, PANDA_HOME, strict=True)))
    near.stand((Obstacle("box_0", BOXES[0].shape, tool),), ())
    after = near.look(q, within)
    assert near.built == 1
    assert len(after.distance) > len(before.distance)
    assert after.distance.min() < 0.0
