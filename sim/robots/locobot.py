"""A LoCoBot WX250s: a Kobuki base, an arm of six joints, a laser, and a camera on a tower.

The arm is in ``wx250s``. Joints and masses of the head are those of Interbotix' files, the shapes are
primitives of the size of the parts, and what no file tells is stated here as ours.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, RobotModel, Sector, Wheels
from tandem.sim.robots import wx250s
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import Smoothness, groups
from tandem.sim.robots.primitives import box, fixed, frame, inertial, link, shape, turning, wheel
from tandem.sim.robots.robot import Robot
from tandem.skills.ports.robot_description import DifferentialDrive, Posture, RobotDescription
from tandem.skills.ports.sensors import Bumper, CameraSensor, CliffSensor, LaserSensor

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "locobot"
HAND: Final = "single"
ARM: Final = f"arm_{HAND}"
CASTERS: Final = "casters_link"
LASER: Final = "laser_frame"
CAMERA: Final = "camera_optical_frame"

FOOTPRINT_RADIUS: Final = 0.21
"""Metres. The arm folded at home reaches 0.190 m from the base's axis, the base itself 0.178 m."""
HEIGHT: Final = 0.63
"""Metres: the top of the camera's tower."""
BODY_RADIUS: Final = 0.178
"""Metres: of the base alone."""
DRIVE: Final = DifferentialDrive(
    forward=0.7, backward=0.2, acceleration=0.5, turn=1.5, turn_acceleration=1.5, dead_man=0.3, braking=3.0
)
"""0.7 m/s is Kobuki's; it could turn with 3.1 rad/s. The rest is ours, as are the brakes: 3 m/s2 is
what wheels hold on a floor with a friction of 1 while the caster takes a third of the weight."""
CLIFFS: Final = {
    "cliff_left": (0.0873, 0.1360, 0.0316),
    "cliff_center": (0.156, 0.0, 0.0316),
    "cliff_right": (0.0850, -0.1360, 0.0316),
}
"""Kobuki's three, where its URDF has them."""
CLIFF_LEAD: Final = 0.041
"""Metres from the middle one to the caster in front. The wheels carry on behind that, but a base
that brakes with its caster in the air dives."""
WHEELS: Final = Wheels(("left_wheel_joint",), ("right_wheel_joint",), radius=0.035, track=0.230, effort=3.0)
"""Kobuki's wheels, of 70 mm and 230 mm apart. The effort is in N m."""
FLOOR_FRICTIONS: Final = {"left_wheel_link": 1.0, "right_wheel_link": 1.0, CASTERS: 0.0}
"""Chosen: tyres grip, and the casters roll to all sides."""
SIXTH: Final = math.pi / 6
"""Radians: the bumpers' borders lie on multiples of it."""
BUMPERS: Final = (
    Sector("front_left", SIXTH, 3 * SIXTH),
    Sector("front_center", -SIXTH, SIXTH),
    Sector("front_right", -3 * SIXTH, -SIXTH),
)
"""Kobuki's three. Behind there is none."""

WHEEL_SHAPE: Final = 0.0343
"""Metres: the physics keeps these cylinders 0.7 mm off the floor, so that they roll as wheels of 35 mm."""
CASTER_HEIGHT: Final = 0.0170
"""Metres: 0.5 mm less than the ball's radius, for the same reason. A base whose wheels stand higher than its
casters rocks as the arm moves; one that stands on its casters has no grip."""
PLATE: Final = 0.124
"""Metres: the top of the base, on which all else stands."""
ARM_AT: Final = (0.097277, 0.0, PLATE + 0.0095)
"""Metres in ROOT: where the arm stands, on the plate."""
PAN: Final = (0.002, 0.0, PLATE + 0.44425)
"""On the large tower, which comes with this arm: 6 cm higher than on the small one. It stands on a tongue of
the tower's plate, 64 mm wide, then 34, that ends 18 mm before the pan's axis; the plate itself ends 58 mm
behind the axis (measured on nav-planning's mesh of the small tower). A plate that went on to the axis would
hold up a camera that tilts down by more than 20 degrees."""
LASER_IN_BASE: Final = (-0.10, 0.0, 0.235)
"""Ours. The beams pass the tower's posts, which the simulated laser does not see."""

SMOOTH: Final = Smoothness(acceleration=4.0, jerk=40.0)
"""Ours."""
SEARCH_TILTS: Final = (-0.25,)
"""From 0.59 m up, with 42 degrees of height, one picture spans from the floor 0.8 m ahead to above the
horizon: items on boards of 0.15 m from 0.6 m on, those on boards of 0.45 m however far. At -0.45 these leave
the picture from 1.4 m on."""
HOME: Final = (0.0, -1.25, 1.16, 0.0, 1.39, 0.0)
"""Folded back under the tower's roof, the hand down before the base: found by a random search. In the
maker's own posture to sleep the elbow would be in the deck's box."""
CARRY: Final = (0.0, -1.27, 0.68, 0.0, 1.55, 0.0)
"""The hand before the tower, 0.37 m high and 55 degrees down: an item in it stays within 0.24 m of the axis,
out of the camera's way and above the laser's plane."""


def compose() -> RobotModel:
    """Put the robot together."""
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - loads numpy; the room it takes is known without

    document, hand = UrdfDocument(_urdf()), wx250s.hand(HAND)
    physics_urdf, frames = finish(document, (wx250s.MOUNT, CASTERS))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(hand,),
        wheels=WHEELS,
        floor_frictions=FLOOR_FRICTIONS,
        bumper_links=(ROOT,),
        touching_links=(("lower_forearm_link", "gripper_link"), hand.finger_links),
        bumpers=BUMPERS,
        anchored_wheels=("left_wheel_link", "right_wheel_link"),
    )


def _urdf() -> str:
    return f"""<robot name="{NAME}">
      {_base()}
      {_wheels()}{wx250s.links()}{wx250s.joints(ARM_AT)}{_head()}{_frames()}
    </robot>"""


def _wheels() -> str:
    return "".join(
        wheel(side, x=0.0, y=y, radius=WHEEL_SHAPE, width=0.02, mass=0.2)
        for side, y in (("left", WHEELS.track / 2), ("right", -WHEELS.track / 2))
    )


def _base() -> str:
    """Return Kobuki with the deck, the tower and the laser's drum, and its casters."""
    posts = "".join(box((x, y, 0.385), (0.02, 0.02, 0.35)) for x in (-0.155, -0.085) for y in (0.125, -0.125))
    balls = "".join(shape('<sphere radius="0.0175"/>', (x, 0.0, CASTER_HEIGHT)) for x in (0.115, -0.135))
    body = (
        shape(f'<cylinder radius="{BODY_RADIUS}" length="0.109"/>', (0.0, 0.0, 0.0695))
        + box((-0.06, 0.0, 0.167), (0.13, 0.28, 0.086))
        + posts
        + box((PAN[0] - 0.1195, 0.0, PAN[2] - 0.005), (0.123, 0.29, 0.010))
        + box((PAN[0] - 0.0445, 0.0, PAN[2] - 0.005), (0.027, 0.064, 0.010))
        + box((PAN[0] - 0.0068, 0.0, PAN[2] - 0.005), (0.0485, 0.034, 0.010))
        + shape('<cylinder radius="0.038" length="0.04"/>', (LASER_IN_BASE[0], 0.0, 0.23))
    )
    mass = inertial(6.5, (-0.03, 0.0, 0.14), (0.05, 0.05, 0.07))
    mass_of_casters = inertial(0.05, (-0.01, 0.0, 0.0175), (1e-4, 1e-4, 1e-4))
    return f"""<link name="{ROOT}">{mass}{body}</link>
      <link name="{CASTERS}">{mass_of_casters}{balls}</link>
      {fixed("casters_joint", ROOT, CASTERS, (0.0, 0.0, 0.0))}"""


def _head() -> str:
    """Return the tower's head that pans and tilts, and its camera."""
    degrees, optical = math.radians, f"{-math.pi / 2} 0 {-math.pi / 2}"
    return (
        link("pan_link", 0.099, (0.0, 0.0, 0.018), box((0.0, 0.0, 0.018), (0.041, 0.046, 0.036)))
        + link(
            "tilt_link",
            0.092,
            (0.045, 0.0, 0.0),
            box((0.020, 0.0, 0.0), (0.05, 0.05, 0.024)) + box((0.045, 0.0, 0.0), (0.025, 0.09, 0.025)),
        )
        + turning("pan", ROOT, "pan_link", PAN, "0 0 1", (degrees(-90), degrees(90)), 2)
        # Down is negative, as Tandem's heads have it; the maker's own sign is the other one.
        + turning(
            "tilt",
            "pan_link",
            "tilt_link",
            (0.025034, 0.0, 0.019),
            "0 -1 0",
            (degrees(-75), degrees(90)),
            2,
        )
        + f'<link name="{CAMERA}"/>'
        + fixed("camera_joint", "tilt_link", CAMERA, (0.05318, 0.0175, 0.0), optical)
    )


def _frames() -> str:
    """Return where tool, laser and cliff sensors are."""
    return (
        wx250s.tool()
        + frame(LASER, *LASER_IN_BASE, 0.0)
        + "".join(
            f'<link name="{name}"/>' + fixed(f"{name}_joint", ROOT, name, at, f"0 {math.pi / 2} 0")
            for name, at in CLIFFS.items()
        )
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=groups(document, {ARM: (wx250s.JOINTS, SMOOTH), "head": (("pan", "tilt"), SMOOTH)}),
        end_effectors=(wx250s.end_effector(HAND, ARM, work_point=(0.47, 0.0)),),
        search_tilts=SEARCH_TILTS,
        cameras=(
            CameraSensor(
                name="head", frame=CAMERA, width=1280, height=720, horizontal_fov=math.radians(69.0)
            ),
        ),
        lasers=(
            LaserSensor(
                name="base",
                frame=LASER,
                angle_min=-math.pi,
                angle_step=math.radians(0.9),
                beams=400,
                range_min=0.15,
                range_max=12.0,
                period=0.1,
            ),
        ),
        cliff_sensors=tuple(
            CliffSensor(name=name, frame=name, range_max=0.15, lead=CLIFF_LEAD, period=0.02)
            for name in CLIFFS
        ),
        bumpers=tuple(Bumper(name=each.name) for each in BUMPERS),
        drive=DRIVE,
        postures=(
            Posture(name="home", group=ARM, positions=HOME),
            Posture(name="carry", group=ARM, positions=CARRY),
            Posture(name="home", group="head", positions=(0.0, -0.3)),
            Posture(name="ahead", group="head", positions=(0.0, 0.0)),
            Posture(name="table", group="head", positions=(0.0, -0.55)),
        ),
        period=0.01,
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, HEIGHT, compose)
