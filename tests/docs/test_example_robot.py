"""The example of a robot of one's own: made from the public surface alone, it stands in the simulation."""

from __future__ import annotations

import ast
import math
from types import ModuleType

import pytest

from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.robots.robot import Robot
from tests.fakes.examples import CART, example_cart


@pytest.fixture(scope="module")
def cart() -> ModuleType:
    return example_cart()


def test_it_imports_nothing_of_tandem_but_the_api() -> None:
    imported = [
        each.module
        for each in ast.walk(ast.parse(CART.read_text("utf-8")))
        if isinstance(each, ast.ImportFrom)
    ]
    assert {each for each in imported if each and each.startswith("tandem")} == {"tandem.api.robots"}


def test_it_takes_the_room_that_it_declares(cart: ModuleType) -> None:
    assert isinstance(cart.ROBOT, Robot)
    description = cart.ROBOT.compose().description
    assert (description.footprint_radius, description.height) == (
        cart.ROBOT.footprint_radius,
        cart.ROBOT.height,
    )
    assert description.hands == ("single",)


def test_its_wrist_feels_the_weight_of_the_hand(cart: ModuleType) -> None:
    physics = Physics()
    try:
        physics.add_floor()
        home = dict(zip(cart.JOINTS, cart.HOME, strict=True))
        body = RobotBody(physics, cart.ROBOT.compose(), positions=home)
        physics.step(3)
        force, torque = body.reaction("gripper_mount_joint")
        assert all(math.isfinite(each) for each in (*force, *torque))
        assert math.hypot(*force) > 0.5
    finally:
        physics.close()
