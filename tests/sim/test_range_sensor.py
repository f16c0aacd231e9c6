"""Sonars measure as geometry says: walls, posts beside their axis, the floor that they don't see."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import pytest

from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.range_sensor import RangeFinder
from tandem.sim.robots.registry import robot_model

AHEAD = 0.365
"""Metres before the base's axis: the middle range sensor of the SUMMIT-XL."""


class Floor:
    """A SUMMIT-XL at the origin, which heads along x, on an endless floor."""

    def __init__(self) -> None:
        self.physics = Physics()
        self.physics.add_floor()
        self.robot = RobotBody(self.physics, robot_model("summit_xl"))
        self.physics.step(60)

    def measure(self, name: str = "range_middle") -> float:
        return self.finder(name).measure()

    def finder(self, name: str = "range_middle", *, sigma: float = 0.0, seed: int = 0) -> RangeFinder:
        (sensor,) = (each for each in self.robot.model.description.range_sensors if each.name == name)
        return RangeFinder(self.robot, sensor, sigma=sigma, rng=np.random.default_rng(seed))

    def wall(self, x: float) -> None:
        """Put a wall whose near face is at x."""
        self.physics.add_box((0.2, 8.0, 2.0), 0.0, (x + 0.1, 0.0, 1.0))

    def post(self, x: float, y: float, edge: float = 0.1) -> None:
        self.physics.add_box((edge, edge, 1.0), 0.0, (x, y, 0.5))


@pytest.fixture
def floor() -> Iterator[Floor]:
    made = Floor()
    yield made
    made.physics.close()


@pytest.mark.parametrize("distance", [0.4, 1.0, 3.0])
def test_a_wall_ahead_is_as_far_as_it_is(floor: Floor, distance: float) -> None:
    floor.wall(AHEAD + distance)
    assert floor.measure() == pytest.approx(distance, abs=2e-3)


@pytest.mark.parametrize(("name", "distance"), [("range_left", 1.0), ("range_right", 1.0)])
def test_a_wall_that_is_met_aslant_counts_at_the_cones_nearest_ray(
    floor: Floor, name: str, distance: float
) -> None:
    """The axis is turned by 30 degrees, and the cone reaches from 15 to 45: the shortest way is at 15."""
    floor.wall(AHEAD + distance)
    assert floor.measure(name) == pytest.approx(distance / math.cos(math.radians(15.0)), abs=5e-3)


def test_nothing_in_range_reads_as_the_range(floor: Floor) -> None:
    """Nor does the floor, which the lower rays graze."""
    assert floor.measure() == 5.0
    floor.wall(AHEAD + 5.1)
    assert floor.measure() == 5.0


@pytest.mark.parametrize(("degrees", "seen"), [(0.0, True), (12.0, True), (-12.0, True), (25.0, False)])
def test_a_post_beside_the_axis_is_seen_when_the_cone_has_it(
    floor: Floor, degrees: float, *, seen: bool
) -> None:
    bearing = math.radians(degrees)
    floor.post(AHEAD + 1.5 * math.cos(bearing), 1.5 * math.sin(bearing))
    measured = floor.measure()
    assert (measured < 5.0) is seen
    if seen:
        assert measured == pytest.approx(1.45, abs=0.03)


def test_the_nearest_of_two_counts(floor: Floor) -> None:
    floor.wall(AHEAD + 3.0)
    floor.post(AHEAD + 1.05, 0.2)
    assert floor.measure() == pytest.approx(1.0, abs=0.03)


def test_a_thing_that_is_too_near_reads_as_the_least_range(floor: Floor) -> None:
    floor.wall(AHEAD + 0.05)
    assert floor.measure() == 0.15


def test_a_low_box_and_an_overhang_are_seen_above_and_below_the_axis(floor: Floor) -> None:
    floor.physics.add_box((0.2, 2.0, 0.12), 0.0, (AHEAD + 1.1, 0.0, 0.06))
    assert floor.measure() < 1.3
    floor.physics.add_box((0.2, 2.0, 0.1), 0.0, (AHEAD + 0.9, 0.0, 0.33))
    assert floor.measure() == pytest.approx(0.8 / math.cos(math.radians(7.5)), abs=0.02)


def test_noise_is_seeded_and_of_the_stated_size(floor: Floor) -> None:
    floor.wall(AHEAD + 2.0)
    noisy, again = (floor.finder(sigma=0.02, seed=3) for _ in range(2))
    measured = [noisy.measure() for _ in range(400)]
    assert measured == [again.measure() for _ in range(400)]
    assert np.mean(measured) == pytest.approx(2.0, abs=0.005)
    assert np.std(measured) == pytest.approx(0.02, rel=0.1)


def test_the_pioneer_does_not_see_itself() -> None:
    physics = Physics()
    physics.add_floor()
    robot = RobotBody(physics, robot_model("p3dx"))
    physics.step(60)
    rng = np.random.default_rng(0)
    sensors = robot.model.description.range_sensors
    assert len(sensors) == 16
    assert {RangeFinder(robot, each, sigma=0.0, rng=rng).measure() for each in sensors} == {5.0}
    physics.close()
