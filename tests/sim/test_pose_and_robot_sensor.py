"""Motion capture has the errors that its maker states; a robot sensor sees who is there and nothing hides."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import pytest

from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.pose_sensor import PoseFinder
from tandem.sim.robot_sensor import RobotFinder
from tandem.sim.robots.registry import robot_model
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import SeenRobot

AT = FloorPose(x=1.0, y=2.0, yaw=math.pi / 2)
"""Of the SUMMIT-XL: it heads north."""


@pytest.fixture
def robot() -> Iterator[RobotBody]:
    physics = Physics()
    physics.add_floor()
    made = RobotBody(physics, robot_model("summit_xl"), x=AT.x, y=AT.y, yaw=AT.yaw)
    physics.step(60)
    yield made
    physics.close()


def captured(robot: RobotBody, seed: int, count: int) -> list[FloorPose]:
    (sensor,) = robot.model.description.pose_sensors
    finder = PoseFinder(robot, sensor, rng=np.random.default_rng(seed))
    return [finder.measure() for _ in range(count)]


def test_the_place_is_true_on_average_and_errs_by_10_mm_and_half_a_degree(robot: RobotBody) -> None:
    told = captured(robot, 1, 2000)
    errors = np.array([(each.x - AT.x, each.y - AT.y, wrap(each.yaw - AT.yaw)) for each in told])
    assert np.mean(errors, axis=0) == pytest.approx([0.0] * 3, abs=1.5e-3)
    assert np.std(errors, axis=0) == pytest.approx([0.010, 0.010, math.radians(0.5)], rel=0.07)


def test_the_errors_are_those_of_the_seed(robot: RobotBody) -> None:
    assert captured(robot, 1, 5) == captured(robot, 1, 5)
    assert captured(robot, 1, 5) != captured(robot, 2, 5)


def seen(robot: RobotBody, *others: tuple[str, float, float]) -> tuple[SeenRobot, ...]:
    (sensor,) = robot.model.description.robot_sensors
    there = {name: FloorPose(x=x, y=y, yaw=0.3) for name, x, y in others}
    return RobotFinder(robot, sensor, others=lambda: there).measure()


def test_nobody_is_seen_where_nobody_is(robot: RobotBody) -> None:
    assert seen(robot) == ()


def test_others_are_told_by_name_in_the_base(robot: RobotBody) -> None:
    """Two metres north is two ahead; half a metre west of that is half to the left."""
    first, second = seen(robot, ("r2", 1.0, 4.0), ("r1", 0.5, 4.0))
    assert (first.name, second.name) == ("r1", "r2")
    assert (first.x, first.y) == pytest.approx((2.0, 0.5), abs=2e-3)
    assert (second.x, second.y) == pytest.approx((2.0, 0.0), abs=2e-3)


@pytest.mark.parametrize(
    ("x", "y"),
    [(1.0, 0.0), (3.0, 2.0), (1.0, 7.5)],
    ids=["behind", "at its right, beyond 60 degrees", "out of range"],
)
def test_who_is_outside_of_field_or_range_is_not_seen(robot: RobotBody, x: float, y: float) -> None:
    assert seen(robot, ("r1", x, y)) == ()


def test_who_stands_behind_a_thing_is_not_seen_and_beside_it_is(robot: RobotBody) -> None:
    robot.physics.add_box((0.4, 0.1, 1.0), 0.0, (1.0, 3.2, 0.5))
    assert [each.name for each in seen(robot, ("behind", 1.0, 4.0), ("beside", 2.0, 4.0))] == ["beside"]


def test_a_thing_lower_than_the_sensor_hides_nobody(robot: RobotBody) -> None:
    robot.physics.add_box((0.4, 0.1, 0.2), 0.0, (1.0, 3.2, 0.1))
    assert [each.name for each in seen(robot, ("behind", 1.0, 4.0))] == ["behind"]


def test_a_robot_hides_who_is_behind_it(robot: RobotBody) -> None:
    assert [each.name for each in seen(robot, ("r1", 1.05, 3.2), ("r2", 1.0, 4.0))] == ["r1"]
    assert [each.name for each in seen(robot, ("r1", 1.4, 3.2), ("r2", 1.0, 4.0))] == ["r1", "r2"]
