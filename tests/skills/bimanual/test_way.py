"""The eager mode's criterion: could the follower go its way beside the leader?"""

from __future__ import annotations

import math
from collections.abc import Generator

import numpy as np
import pytest

from tandem.skills.bimanual.way import APART, AT_ONCE, MARGIN, STRIDE, clear, joined, straight, thinned
from tandem.skills.geometry.poses import add
from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.hand_following import PoseFollower
from tandem.skills.kinematics.transforms import Array
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, positions, robot


@pytest.fixture(scope="module")
def bodies() -> ArmsClearance:
    description, hulls = robot()
    return ArmsClearance(hulls, description, positions())


def verdict(sweep: Generator[None, None, bool]) -> tuple[bool, int]:
    """Return what a sweep says, and in how many slices."""
    slices = 1
    while True:
        try:
            next(sweep)
        except StopIteration as stop:
            return bool(stop.value), slices
        slices += 1


def test_a_way_is_clear_when_no_pair_on_it_is_nearer_than_the_margin(bodies: ArmsClearance) -> None:
    near, aside = np.array(IN_FRONT), np.array(ASIDE)
    assert bodies.at(np.concatenate((near, near))).distance < MARGIN < bodies.at(np.r_[aside, aside]).distance
    assert verdict(clear(bodies, [aside], [aside]))[0]
    assert not verdict(clear(bodies, [aside, near], [near, aside]))[0]


def test_who_goes_when_is_not_known_so_each_is_paired_with_each(bodies: ArmsClearance) -> None:
    """Both are near in the middle of their ways only, at different moments if they set out together."""
    near, aside = np.array(IN_FRONT), np.array(ASIDE)
    assert not verdict(clear(bodies, [near, aside, aside], [aside, aside, near]))[0]


def test_a_sweep_is_done_in_slices(bodies: ArmsClearance) -> None:
    aside = np.array(ASIDE)
    assert verdict(clear(bodies, [aside] * 5, [aside] * 7)) == (True, 1 + 5 * 7 // AT_ONCE)


@pytest.mark.parametrize(
    ("record", "kept"),
    [
        ([], []),
        ([0.0], [0.0]),
        ([0.0, 0.4 * APART, 0.8 * APART], [0.0, 0.8 * APART]),
        ([0.0, 1.1 * APART, 1.2 * APART, 2.3 * APART], [0.0, 1.1 * APART, 2.3 * APART]),
    ],
)
def test_of_a_record_those_are_looked_at_that_differ_and_the_last(
    record: list[float], kept: list[float]
) -> None:
    thin = thinned([np.array([0.0, each]) for each in record])
    assert [float(each[1]) for each in thin] == kept


def test_the_way_of_the_joints_ends_at_its_end() -> None:
    way = joined(np.zeros(2), np.array([1.0, -2.0]))
    assert np.allclose(way, [[0.25, -0.5], [0.5, -1.0], [0.75, -1.5], [1.0, -2.0]])


@pytest.fixture(scope="module")
def follower() -> PoseFollower:
    description, hulls = robot()
    group = description.group("arm_left")
    limits = hulls.robot.limits(group.joints)
    frame = description.end_effector("left").frame
    return PoseFollower(hulls.robot, group.joints, positions(), frame=frame, limits=limits)


START: Array = np.array(ASIDE)


def test_the_hand_goes_straight_and_stops_before_the_goal_with_its_attitude_kept(
    follower: PoseFollower,
) -> None:
    start = follower.pose(START)
    goal = add(start.position, (0.0, 0.0, -0.25))
    poses = [start, *(follower.pose(q) for q in straight(follower, START, goal, short=0.10))]
    depths = [start.position[2] - pose.position[2] for pose in poses]
    assert depths[-1] == pytest.approx(0.15, abs=2e-3)
    assert max(np.diff(depths)) <= STRIDE + 2e-3
    assert all(math.dist(pose.position[:2], start.position[:2]) < 3e-3 for pose in poses)
    assert all(abs(np.dot(pose.orientation, start.orientation)) > math.cos(0.01) for pose in poses)


def test_a_goal_that_is_near_enough_needs_no_way(follower: PoseFollower) -> None:
    goal = add(follower.pose(START).position, (0.05, 0.0, 0.0))
    assert straight(follower, START, goal, short=0.10) == []
