"""The robots of wheels alone drive as they are told, by their motors: against the truth and the odometry."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest

from tandem.sim.base import BaseController, Odometer
from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import Noise
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.pose import FloorPose

PERIOD = 0.01
ROBOTS = ("p3dx", "summit_xl")


@dataclass(frozen=True)
class Driven:
    """Where a robot came to (m, rad), the turn in all, and what its odometry says of each."""

    x: float
    y: float
    turn: float
    odometry: FloorPose
    odometry_turn: float


class Track:
    """A robot on an endless floor, and its controller."""

    def __init__(self, name: str) -> None:
        self.physics = Physics()
        self.physics.add_floor()
        self.model = robot_model(name)
        wheels = self.model.wheels
        assert wheels is not None
        self.wheels = wheels
        self.robot = RobotBody(self.physics, self.model)
        self.physics.step(150)
        self.controller = BaseController(self.model.description.driven, self.wheels, self.angles())
        self.odometer = Odometer(self.wheels, self.angles(), Noise(), np.random.default_rng(0))

    def angles(self) -> tuple[float, ...]:
        return tuple(reading.position for reading in self.robot.read(self.wheels.joints))

    def yaw(self) -> float:
        _, orientation = self.robot.base_pose()
        return 2.0 * math.atan2(orientation[2], orientation[3])

    def drive(self, linear: float, angular: float, seconds: float) -> Driven:
        """Drive from rest for so long, and stand."""
        efforts = [self.wheels.effort] * len(self.wheels.joints)
        turn, odometry_turn, before = 0.0, 0.0, self.yaw()
        for step in range(round((seconds + 2.0) / PERIOD)):
            if step < round(seconds / PERIOD):
                self.controller.command(BaseVelocity(linear=linear, angular=angular))
            else:
                self.controller.command(BaseVelocity(linear=0.0, angular=0.0))
            speeds = self.controller.advance(PERIOD, self.angles())
            self.robot.drive_velocities(self.wheels.joints, speeds, efforts)
            self.physics.step(3)
            self.odometer.update(PERIOD, self.angles())
            turn, before = turn + wrap(self.yaw() - before), self.yaw()
            odometry_turn += self.odometer.angular * PERIOD
        (x, y, _), _ = self.robot.base_pose()
        return Driven(x, y, turn, self.odometer.pose, odometry_turn)


@pytest.fixture(params=ROBOTS)
def track(request: pytest.FixtureRequest) -> Iterator[Track]:
    made = Track(request.param)
    yield made
    made.physics.close()


def test_it_goes_two_metres_straight_on(track: Track) -> None:
    """Within 1 %: the physics keeps surfaces 0.4 mm apart, which makes the wheels that much larger."""
    driven = track.drive(0.5, 0.0, 4.0)
    assert driven.odometry.x == pytest.approx(2.0, abs=1e-3)
    assert driven.x == pytest.approx(2.0, rel=0.01)
    assert (driven.y, driven.turn) == pytest.approx((0.0, 0.0), abs=5e-3)


@pytest.mark.parametrize("way", [1.0, -1.0], ids=["left", "right"])
def test_it_turns_once_around_in_place(track: Track, way: float) -> None:
    """A differential drive within 1.5 %; wheels that skid within 6 %: how they slip depends on the speed."""
    most = {"p3dx": 0.015, "summit_xl": 0.06}[track.model.description.name]
    driven = track.drive(0.0, way, 2.0 * math.pi)
    assert driven.odometry_turn == pytest.approx(way * 2.0 * math.pi, rel=2e-3)
    assert driven.turn == pytest.approx(way * 2.0 * math.pi, rel=most)
    assert math.hypot(driven.x, driven.y) < 0.05


def test_an_arc_turns_by_what_it_was_told(track: Track) -> None:
    """Skidding wheels turn less well in an arc, whose tracks they slip across: within 10 %."""
    most = {"p3dx": 0.03, "summit_xl": 0.10}[track.model.description.name]
    driven = track.drive(0.4, 0.5, 4.0)
    assert driven.turn == pytest.approx(2.0, rel=most)


def test_it_stands_level_and_where_it_was_put(track: Track) -> None:
    before, _ = track.robot.base_pose()
    track.drive(0.0, 0.0, 2.0)
    (x, y, z), orientation = track.robot.base_pose()
    assert (x, y) == pytest.approx(before[:2], abs=1e-3)
    assert abs(z) < 2e-3
    assert orientation[:2] == pytest.approx((0.0, 0.0), abs=5e-3)


@pytest.mark.parametrize(("name", "mass"), [("p3dx", 9.0), ("summit_xl", 65.0)])
def test_it_weighs_what_the_maker_says(name: str, mass: float) -> None:
    import xml.etree.ElementTree as ET  # noqa: PLC0415

    root = ET.fromstring(robot_model(name).physics_urdf)  # noqa: S314
    masses = [float(each.get("value", "0")) for each in root.iter("mass")]
    assert sum(masses) == pytest.approx(mass)
