"""A LoCoBot WX250s: a Kobuki base, an arm of six joints, a laser, and a camera on a tower.

Joints, limits and masses of the arm are those of Interbotix' files (``mobile_wx250s.urdf.xacro``), the
shapes are primitives of the size of its parts, and what no file tells is stated here as ours.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, Hand, RobotModel, Sector, Wheels
from tandem.sim.robots import primitives
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import Smoothness, groups
from tandem.sim.robots.robot import Robot
from tandem.skills.ports.hardware import (
    DifferentialDrive,
    EndEffector,
    Gripper,
    Posture,
    RobotDescription,
)
from tandem.skills.ports.sensors import Bumper, CameraSensor, CliffSensor, LaserSensor

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "locobot"
HAND: Final = "single"
ARM: Final = f"arm_{HAND}"
MOUNT: Final = "gripper_mount"
CASTERS: Final = "casters_link"
LASER: Final = "laser_frame"
CAMERA: Final = "camera_optical_frame"
TOOL: Final = "ee_gripper_link"
FINGERS: Final = ("left_finger", "right_finger")

FOOTPRINT_RADIUS: Final = 0.21
"""Metres. The arm folded at home reaches 0.190 m from the base's axis, the base itself 0.178 m."""
HEIGHT: Final = 0.63
BODY_RADIUS: Final = 0.178
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
FLOOR_FRICTIONS: Final = {"left_wheel_link": 1.0, "right_wheel_link": 1.0, CASTERS: 0.0}
SIXTH: Final = math.pi / 6
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
ARM_X: Final = 0.097277
TOWER: Final = (-0.045, 0.0, PLATE)
PAN: Final = (0.002, 0.0, PLATE + 0.44425)
"""On the large tower, which comes with this arm: 6 cm higher than on the small one. It stands on a tongue of
the tower's plate, 64 mm wide, then 34, that ends 18 mm before the pan's axis; the plate itself ends 58 mm
behind the axis (measured on nav-planning's mesh of the small tower). A plate that went on to the axis would
hold up a camera that tilts down by more than 20 degrees."""
LASER_IN_BASE: Final = (-0.10, 0.0, 0.235)
"""Ours. The beams pass the tower's posts, which the simulated laser does not see."""

FINGER_TRAVEL: Final = (0.015, 0.037)
"""Metres from the middle: 30 to 74 mm between the pads."""
FINGER_FORCE: Final = 5.0
FINGER_SPEED: Final = 0.025
"""Ours, m/s: the maker names none."""
PALM: Final = 0.022
"""Metres from the palm to the middle of the pads."""

SMOOTH: Final = Smoothness(acceleration=4.0, jerk=40.0)
"""Ours."""
JOINTS: Final = ("waist", "shoulder", "elbow", "forearm_roll", "wrist_angle", "wrist_rotate")
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

    document = UrdfDocument(_urdf())
    physics_urdf, frames = finish(document, (MOUNT, CASTERS))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(_hand(),),
        wheels=WHEELS,
        floor_frictions=FLOOR_FRICTIONS,
        bumper_links=(ROOT,),
        touching_links=(("lower_forearm_link", "gripper_link"), _hand().finger_links),
        bumpers=BUMPERS,
        anchored_wheels=("left_wheel_link", "right_wheel_link"),
    )


def _urdf() -> str:
    wheels = "".join(
        primitives.wheel(side, x=0.0, y=y, radius=WHEEL_SHAPE, width=0.02, mass=0.2)
        for side, y in (("left", WHEELS.track / 2), ("right", -WHEELS.track / 2))
    )
    posts = "".join(
        _box((x, y, 0.385), (0.02, 0.02, 0.35)) for x in (-0.155, -0.085) for y in (0.125, -0.125)
    )
    balls = "".join(_shape('<sphere radius="0.0175"/>', (x, 0.0, CASTER_HEIGHT)) for x in (0.115, -0.135))
    optical = f"{-math.pi / 2} 0 {-math.pi / 2}"
    body = (
        _shape(f'<cylinder radius="{BODY_RADIUS}" length="0.109"/>', (0.0, 0.0, 0.0695))
        + _box((-0.06, 0.0, 0.167), (0.13, 0.28, 0.086))
        + posts
        + _box((PAN[0] - 0.1195, 0.0, PAN[2] - 0.005), (0.123, 0.29, 0.010))
        + _box((PAN[0] - 0.0445, 0.0, PAN[2] - 0.005), (0.027, 0.064, 0.010))
        + _box((PAN[0] - 0.0068, 0.0, PAN[2] - 0.005), (0.0485, 0.034, 0.010))
        + _shape('<cylinder radius="0.038" length="0.04"/>', (LASER_IN_BASE[0], 0.0, 0.23))
    )
    arm = (
        _link("arm_base_link", 0.380, (0.0, 0.0, 0.034), _box((0.0, 0.0, 0.0255), (0.103, 0.103, 0.051)))
        + _link("shoulder_link", 0.481, (0.0, 0.0, 0.007), _box((0.0, 0.0, 0.022), (0.072, 0.086, 0.060)))
        + _link(
            "upper_arm_link",
            0.431,
            (0.017, 0.0, 0.191),
            _box((0.0, 0.0, 0.120), (0.045, 0.06, 0.26)) + _box((0.030, 0.0, 0.25), (0.064, 0.06, 0.037)),
        )
        + _link("upper_forearm_link", 0.235, (0.108, 0.0, 0.0), _box((0.080, 0.0, 0.0), (0.19, 0.042, 0.042)))
        + _link("lower_forearm_link", 0.221, (0.037, 0.005, 0.0), _box((0.037, 0.0, 0.0), (0.08, 0.06, 0.05)))
        + _link("wrist_link", 0.085, (0.042, 0.0, 0.0106), _box((0.030, 0.0, 0.007), (0.066, 0.044, 0.055)))
        + _link("gripper_link", 0.073, (0.022, 0.0, 0.011), _box((0.012, 0.0, 0.007), (0.03, 0.04, 0.055)))
        + _link(MOUNT, 0.036, (0.010, 0.0, 0.005), _box((0.014, 0.0, 0.004), (0.028, 0.103, 0.036)))
        + "".join(_finger(name, sign) for name, sign in zip(FINGERS, (1, -1), strict=True))
    )
    pi = math.pi - 0.00001
    degrees = math.radians
    joints = (
        _fixed("arm_mount", ROOT, "arm_base_link", (ARM_X, 0.0, PLATE + 0.0095))
        + _turning("waist", "arm_base_link", "shoulder_link", (0.0, 0.0, 0.066175), "0 0 1", (-pi, pi), 10)
        + _turning(
            "shoulder",
            "shoulder_link",
            "upper_arm_link",
            (0.0, 0.0, 0.03865),
            "0 1 0",
            (degrees(-108), degrees(114)),
            20,
        )
        + _turning(
            "elbow",
            "upper_arm_link",
            "upper_forearm_link",
            (0.04975, 0.0, 0.25),
            "0 1 0",
            (degrees(-123), degrees(92)),
            15,
        )
        + _turning(
            "forearm_roll",
            "upper_forearm_link",
            "lower_forearm_link",
            (0.175, 0.0, 0.0),
            "1 0 0",
            (-pi, pi),
            2,
        )
        + _turning(
            "wrist_angle",
            "lower_forearm_link",
            "wrist_link",
            (0.075, 0.0, 0.0),
            "0 1 0",
            (degrees(-100), degrees(123)),
            5,
        )
        + _turning("wrist_rotate", "wrist_link", "gripper_link", (0.065, 0.0, 0.0), "1 0 0", (-pi, pi), 1)
        + _fixed("gripper_mount_joint", "gripper_link", MOUNT, (0.043, 0.0, 0.0))
        + "".join(_sliding(name, sign) for name, sign in zip(FINGERS, (1, -1), strict=True))
    )
    head = (
        _link("pan_link", 0.099, (0.0, 0.0, 0.018), _box((0.0, 0.0, 0.018), (0.041, 0.046, 0.036)))
        + _link(
            "tilt_link",
            0.092,
            (0.045, 0.0, 0.0),
            _box((0.020, 0.0, 0.0), (0.05, 0.05, 0.024)) + _box((0.045, 0.0, 0.0), (0.025, 0.09, 0.025)),
        )
        + _turning("pan", ROOT, "pan_link", PAN, "0 0 1", (degrees(-90), degrees(90)), 2)
        # Down is negative, as Tandem's heads have it; the maker's own sign is the other one.
        + _turning(
            "tilt",
            "pan_link",
            "tilt_link",
            (0.025034, 0.0, 0.019),
            "0 -1 0",
            (degrees(-75), degrees(90)),
            2,
        )
        + f'<link name="{CAMERA}"/>'
        + _fixed("camera_joint", "tilt_link", CAMERA, (0.05318, 0.0175, 0.0), optical)
    )
    frames = (
        f'<link name="{TOOL}"/>'
        + _fixed("ee_gripper", MOUNT, TOOL, (0.050575, 0.0, 0.0))
        + primitives.frame(LASER, *LASER_IN_BASE, 0.0)
        + "".join(
            f'<link name="{name}"/>' + _fixed(f"{name}_joint", ROOT, name, at, f"0 {math.pi / 2} 0")
            for name, at in CLIFFS.items()
        )
    )
    return f"""<robot name="{NAME}">
      <link name="{ROOT}">{_inertial(6.5, (-0.03, 0.0, 0.14), (0.05, 0.05, 0.07))}{body}</link>
      <link name="{CASTERS}">{_inertial(0.05, (-0.01, 0.0, 0.0175), (1e-4, 1e-4, 1e-4))}{balls}</link>
      {_fixed("casters_joint", ROOT, CASTERS, (0.0, 0.0, 0.0))}
      {wheels}{arm}{joints}{head}{frames}
    </robot>"""


def _shape(geometry: str, at: tuple[float, float, float]) -> str:
    x, y, z = at
    return f'<collision><origin xyz="{x} {y} {z}"/><geometry>{geometry}</geometry></collision>'


def _box(at: tuple[float, float, float], size: tuple[float, float, float]) -> str:
    return _shape(f'<box size="{size[0]} {size[1]} {size[2]}"/>', at)


def _inertial(mass: float, at: tuple[float, float, float], moments: tuple[float, float, float]) -> str:
    x, y, z = at
    xx, yy, zz = moments
    return f"""<inertial><origin xyz="{x} {y} {z}"/><mass value="{mass}"/>
          <inertia ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"/></inertial>"""


def _link(name: str, mass: float, centre: tuple[float, float, float], shapes: str) -> str:
    """Return a link of the arm or the head, with moments of a ball that is as wide as its mass is far out."""
    moment = mass * (0.04**2 + sum(each**2 for each in centre) / 3)
    return f'<link name="{name}">{_inertial(mass, centre, (moment, moment, moment))}{shapes}</link>'


def _finger(name: str, sign: int) -> str:
    """Return a finger: 55 mm long, its pad at the joint's position from the middle.

    It is heavier than the maker's 16 g, so that the physics' contacts are calm.
    """
    return _link(
        f"{name}_link",
        0.04,
        (0.0155, sign * 0.006, 0.0),
        _box((0.0155, sign * 0.006, 0.0), (0.055, 0.012, 0.029)),
    )


def _fixed(name: str, parent: str, child: str, at: tuple[float, float, float], rpy: str = "0 0 0") -> str:
    x, y, z = at
    return f"""<joint name="{name}" type="fixed"><origin xyz="{x} {y} {z}" rpy="{rpy}"/>
        <parent link="{parent}"/><child link="{child}"/></joint>"""


def _turning(  # noqa: PLR0917
    name: str,
    parent: str,
    child: str,
    at: tuple[float, float, float],
    axis: str,
    limits: tuple[float, float],
    effort: float,
) -> str:
    x, y, z = at
    low, high = limits
    return f"""<joint name="{name}" type="revolute"><origin xyz="{x} {y} {z}"/>
        <parent link="{parent}"/><child link="{child}"/><axis xyz="{axis}"/>
        <limit lower="{low}" upper="{high}" effort="{effort}" velocity="{math.pi}"/></joint>"""


def _sliding(name: str, sign: int) -> str:
    low, high = FINGER_TRAVEL
    return f"""<joint name="{name}" type="prismatic"><origin xyz="0.023 0 0"/>
        <parent link="{MOUNT}"/><child link="{name}_link"/><axis xyz="0 {sign} 0"/>
        <limit lower="{low}" upper="{high}" effort="{FINGER_FORCE}" velocity="{FINGER_SPEED}"/></joint>"""


def _hand() -> Hand:
    left, right = FINGERS
    return Hand(
        side=HAND,
        mount_link=MOUNT,
        wrench_joint="gripper_mount_joint",
        inner=left,
        outer=right,
        finger_links=(f"{left}_link", f"{right}_link"),
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    hand = _hand()
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=groups(document, {ARM: (JOINTS, SMOOTH), "head": (("pan", "tilt"), SMOOTH)}),
        end_effectors=(
            EndEffector(
                side=HAND,
                group=ARM,
                frame=TOOL,
                touch_links=(*hand.finger_links, hand.mount_link),
                gripper=Gripper(
                    joints=(hand.inner, hand.outer),
                    min_width=2 * FINGER_TRAVEL[0],
                    max_width=2 * FINGER_TRAVEL[1],
                    palm=PALM,
                    speed=2 * FINGER_SPEED,
                    force=FINGER_FORCE,
                ),
                work_point=(0.47, 0.0),
            ),
        ),
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
