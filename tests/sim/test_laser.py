"""The laser sees the room as its plan says, and not the robot."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.sim.laser import Laser
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import LaserSensor
from tests.sim.rooms import MakeRoom


def scan_at(
    make_room: MakeRoom, x: float, y: float, yaw: float, *, sigma: float = 0.0, seed: int = 0
) -> tuple[LaserSensor, Laser]:
    room = make_room("Defaults", FloorPose(x=x, y=y, yaw=yaw))
    sensor = room.model.description.laser
    return sensor, Laser(room.robot, sensor, sigma=sigma, rng=np.random.default_rng(seed))


def beam(sensor: LaserSensor, angle: float) -> int:
    return round((angle - sensor.angle_min) / sensor.angle_step)


def test_ranges_are_those_of_the_plan(make_room: MakeRoom) -> None:
    # Facing north, south of the shelf: the crate is far, the west and east walls are 3 m from the map's axis.
    sensor, laser = scan_at(make_room, 0.1, 1.6, math.pi / 2)
    ranges = laser.scan()
    assert len(ranges) == sensor.beams == 541
    ahead = 0.202  # the laser's place before the base's axis
    assert ranges[beam(sensor, 0.0)] == pytest.approx(3.0 - 1.6 - ahead, abs=0.01)
    assert ranges[beam(sensor, math.pi / 2)] == pytest.approx(3.1, abs=0.01)
    assert ranges[beam(sensor, -math.pi / 2)] == pytest.approx(2.9, abs=0.01)


def test_the_robot_is_not_seen(make_room: MakeRoom) -> None:
    _, laser = scan_at(make_room, 0.1, 1.6, math.pi / 2)
    ranges = laser.scan()
    assert min(ranges) > 0.6
    # Straight through the robot, behind it: the wall stands nearer than 5 m in every direction.
    assert max(ranges[:20]) < 5.0


def test_noise_is_seeded_and_of_the_stated_size(make_room: MakeRoom) -> None:
    _, true = scan_at(make_room, 0.1, 1.6, math.pi / 2)
    _, noisy = scan_at(make_room, 0.1, 1.6, math.pi / 2, sigma=0.01, seed=3)
    _, again = scan_at(make_room, 0.1, 1.6, math.pi / 2, sigma=0.01, seed=3)
    ranges = np.array(noisy.scan())
    assert np.array_equal(ranges, again.scan())
    assert np.std(ranges - np.array(true.scan())) == pytest.approx(0.01, rel=0.2)
