"""The LoCoBot stands firm, weighs what it should, and has three bumpers and a hand that does not close."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET

import pytest

from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.skills.geometry.chain import Chain
from tandem.skills.kinematics.described import home_positions

ROBOT = "locobot"
STRETCHED = {"shoulder": 0.7, "elbow": -0.2, "wrist_angle": -0.5}
LEVEL = 2.5e-3
"""Half of the sine of the tilt: 5 mrad, 2.5 mm where the hand is."""


def standing() -> tuple[Physics, RobotBody, dict[str, float]]:
    """Return a LoCoBot at rest on a floor, and where its joints are."""
    physics = Physics()
    physics.add_floor()
    model = robot_model(ROBOT)
    home = dict(home_positions(model.description))
    return physics, RobotBody(physics, model, positions=home), home


def drive(body: RobotBody, physics: Physics, wanted: dict[str, float], *, steps: int) -> None:
    """Drive the joints towards positions (rad) for so many steps."""
    for _ in range(steps):
        speeds = [4.0 * (wanted[each] - body.read((each,))[0].position) for each in wanted]
        body.drive_velocities(list(wanted), speeds, [20.0] * len(wanted))
        physics.step(1)


def test_the_hand_is_where_the_makers_file_has_it() -> None:
    """All joints at zero: the arm stretches 0.255 m up and then ahead."""
    description = robot_model(ROBOT).description
    hand, zero = description.end_effectors[0], dict.fromkeys(description.joints, 0.0)
    pose = Chain.from_urdf(description.urdf, description.base_frame, hand.frame).pose(zero)
    x = 0.097277 + 0.04975 + 0.175 + 0.075 + 0.065 + 0.043 + 0.023 + 0.027575
    assert pose.position == pytest.approx((x, 0.0, 0.1335 + 0.066175 + 0.03865 + 0.25), abs=1e-5)
    assert (hand.gripper.min_width, hand.gripper.max_width) == (0.030, 0.074)


def test_it_stands_level_whatever_the_arm_does() -> None:
    physics, body, home = standing()
    for wanted in (home, home | STRETCHED, home):
        drive(body, physics, wanted, steps=300)
        _, orientation = body.base_pose()
        assert orientation[:2] == pytest.approx((0.0, 0.0), abs=LEVEL)


def test_the_camera_tilts_down_over_the_front_of_its_tower() -> None:
    """A plate that was drawn too long held it up at 20 degrees: what stood on a low board was never seen."""
    physics, body, home = standing()
    (low,) = (
        limit.lower
        for group in robot_model(ROBOT).description.groups
        for limit in group.limits
        if limit.joint == "tilt"
    )
    wanted = home | {"tilt": low + 0.05}
    drive(body, physics, wanted, steps=600)
    assert body.read(("tilt",))[0].position == pytest.approx(low + 0.05, abs=0.02)


@pytest.mark.parametrize("board", [0.15, 0.45])
def test_a_search_sees_both_boards_from_near_and_far(board: float) -> None:
    description = robot_model(ROBOT).description
    camera = description.camera
    half = math.atan(math.tan(camera.horizontal_fov / 2) * camera.height / camera.width)
    (tilt,) = description.search_tilts
    for distance in (0.7, 1.0, 2.0, 3.0):
        down = math.atan2(board + 0.03 - 0.59, distance)
        assert tilt - half < down < tilt + half


def test_it_weighs_what_its_parts_do() -> None:
    root = ET.fromstring(robot_model(ROBOT).physics_urdf)  # noqa: S314
    assert sum(float(each.get("value", "0")) for each in root.iter("mass")) == pytest.approx(9.2, abs=0.3)
    assert all(link.find("inertial") is not None for link in root.findall("link")), "pybullet takes 1 kg then"


@pytest.mark.parametrize(
    ("bearing", "pressed"),
    [
        (0.0, ("front_center",)),
        (60.0, ("front_left",)),
        (-60.0, ("front_right",)),
        (180.0, ()),
        (-120.0, ()),
    ],
)
def test_three_bumpers_are_in_front(bearing: float, pressed: tuple[str, ...]) -> None:
    felt = math.radians(bearing)
    assert tuple(each.name for each in robot_model(ROBOT).bumpers if each.feels(felt)) == pressed


def test_its_wheels_roll_as_wide_as_they_are_said_to_be() -> None:
    """2 s at 0.5 m/s, its arm held still: within 1 %."""
    physics, body, home = standing()
    model = robot_model(ROBOT)
    assert model.wheels is not None
    body.drive_velocities(list(home), [0.0] * len(home), [20.0] * len(home))
    physics.step(150)
    wheels = model.wheels.joints
    before, angles = body.base_pose()[0], [each.position for each in body.read(wheels)]
    for step in range(600):
        speed = min(0.5, 0.5 * step / 300)
        body.drive_velocities(wheels, [speed / model.wheels.radius] * 2, [model.wheels.effort] * 2)
        physics.step(1)
    after = body.base_pose()[0]
    rolled = [each.position - angle for each, angle in zip(body.read(wheels), angles, strict=True)]
    assert math.dist(before[:2], after[:2]) == pytest.approx(sum(rolled) / 2 * model.wheels.radius, rel=0.01)
