"""Cart: a robot of one's own for the simulation. Two wheels, an arm of five joints, a camera on a mast.

A package declares it in its ``pyproject.toml``, and a scenario names it with ``robot: cart``::

    [project.entry-points."tandem.robots"]
    cart = "my_robot_app.cart:ROBOT"
"""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.api.robots import (
    ROOT,
    CameraSensor,
    DifferentialDrive,
    EndEffector,
    LaserSensor,
    Posture,
    Robot,
    RobotDescription,
    RobotModel,
    Smoothness,
    Wheels,
    bumpers,
    finish,
    fit_gripper,
    frame,
    gripper_of,
    groups,
    hand_of,
    tool_frame,
    wheel,
)

if TYPE_CHECKING:
    from tandem.api.robots import UrdfDocument

NAME: Final = "cart"
FOOTPRINT_RADIUS: Final = 0.34
HEIGHT: Final = 1.40
"""Metres: the mast with the camera."""
ARM: Final = "arm_single"
"""The group of the hand called ``single``."""
JOINTS: Final = ("turn", "shoulder", "elbow", "wrist", "roll")
HOME: Final = (0.0, -1.9, 2.6, 0.6, 0.0)
"""Folded over the deck, the hand level in front of the shoulder (rad)."""
MOUNT: Final = "gripper_mount"
CASTERS: Final = "casters_link"
WHEELS: Final = Wheels(("left_wheel_joint",), ("right_wheel_joint",), radius=0.08, track=0.40, effort=8.0)
DRIVE: Final = DifferentialDrive(
    forward=0.6, backward=0.2, acceleration=0.5, turn=1.0, turn_acceleration=1.0, dead_man=0.3
)
HAND: Final = hand_of("single", "gripper", mount=MOUNT, wrench_joint="gripper_mount_joint")


def compose() -> RobotModel:
    """Put the robot together: its URDF with a gripper on, and what only the simulation needs."""
    from tandem.api.robots import UrdfDocument  # noqa: PLC0415 - loads numpy; its room is known without

    document = UrdfDocument(urdf())
    fit_gripper(document, "gripper", mount=MOUNT)
    physics_urdf, frames = finish(document, (MOUNT, CASTERS))
    return RobotModel(
        description=describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(HAND,),
        wheels=WHEELS,
        floor_frictions={"left_wheel_link": 1.0, "right_wheel_link": 1.0, CASTERS: 0.0},
        bumper_links=(ROOT,),
        touching_links=(HAND.finger_links,),
        anchored_wheels=("left_wheel_link", "right_wheel_link"),
    )


def urdf() -> str:
    """Return the robot's URDF; a file of your own is read as well (``Path.read_text``)."""
    half = math.pi / 2
    down = math.radians(35.0)
    wheels = "".join(
        wheel(side, x=0.0, y=y, radius=WHEELS.radius, width=0.04, mass=1.0)
        for side, y in (("left", WHEELS.track / 2), ("right", -WHEELS.track / 2))
    )
    casters = "".join(shape('<sphere radius="0.03"/>', x, 0.0, 0.0295) for x in (0.16, -0.16))
    arm = (
        link("turn_link", 1.0, shape('<box size="0.10 0.10 0.08"/>', 0.0, 0.0, 0.04))
        + link("upper_link", 1.0, shape('<box size="0.36 0.06 0.06"/>', 0.18, 0.0, 0.0))
        + link("fore_link", 0.8, shape('<box size="0.26 0.05 0.05"/>', 0.17, 0.0, 0.0))
        + link("wrist_link", 0.3, shape('<box size="0.05 0.04 0.04"/>', 0.035, 0.0, 0.0))
        + link(MOUNT, 0.1, shape('<box size="0.02 0.06 0.04"/>', 0.01, 0.0, 0.0))
        + f'<link name="roll_link">{inertial(0.1)}</link>'
        + turning("turn", ROOT, "turn_link", (0.10, 0.0, 0.70), "0 0 1", 3.0)
        + turning("shoulder", "turn_link", "upper_link", (0.0, 0.0, 0.10), "0 1 0", 2.0)
        + turning("elbow", "upper_link", "fore_link", (0.36, 0.0, 0.0), "0 1 0", 2.7)
        + turning("wrist", "fore_link", "wrist_link", (0.30, 0.0, 0.0), "0 1 0", 2.0)
        + turning("roll", "wrist_link", "roll_link", (0.06, 0.0, 0.0), "1 0 0", 3.0)
        + fixed("gripper_mount_joint", "roll_link", MOUNT, (0.005, 0.0, 0.0))
    )
    return f"""<robot name="{NAME}">
      <link name="{ROOT}">
        <inertial><origin xyz="0 0 0.15"/><mass value="25"/>
          <inertia ixx="0.8" ixy="0" ixz="0" iyy="0.8" iyz="0" izz="0.8"/></inertial>
        {shape('<cylinder radius="0.26" length="0.14"/>', 0.0, 0.0, 0.24)}
        {shape('<box size="0.16 0.16 0.39"/>', 0.10, 0.0, 0.505)}
        {shape('<box size="0.05 0.05 1.05"/>', -0.20, 0.0, 0.835)}
      </link>
      <link name="{CASTERS}">{inertial(0.2)}{casters}</link>
      {fixed("casters_joint", ROOT, CASTERS, (0.0, 0.0, 0.0))}
      {wheels}{arm}{frame("laser_frame", 0.27, 0.0, 0.14, 0.0)}
      <link name="mast_optical_frame"/>
      {fixed("mast_joint", ROOT, "mast_optical_frame", (-0.17, 0.0, 1.36), f"{-half - down} 0 {-half}")}
    </robot>"""


def shape(geometry: str, x: float, y: float, z: float) -> str:
    """Return a collision shape; the simulation draws what collides."""
    return f'<collision><origin xyz="{x} {y} {z}"/><geometry>{geometry}</geometry></collision>'


def inertial(mass: float) -> str:
    """Return the inertia of a ball of 5 cm and this mass (kg)."""
    moment = 0.4 * mass * 0.05**2
    return f"""<inertial><mass value="{mass}"/>
      <inertia ixx="{moment}" ixy="0" ixz="0" iyy="{moment}" iyz="0" izz="{moment}"/></inertial>"""


def link(name: str, mass: float, shapes: str) -> str:
    """Return a link."""
    return f'<link name="{name}">{inertial(mass)}{shapes}</link>'


def turning(  # noqa: PLR0917
    name: str, parent: str, child: str, at: tuple[float, float, float], axis: str, most: float
) -> str:
    """Return a joint that turns by ``most`` radians to both sides."""
    x, y, z = at
    return f"""<joint name="{name}" type="revolute"><origin xyz="{x} {y} {z}"/>
      <parent link="{parent}"/><child link="{child}"/><axis xyz="{axis}"/>
      <limit lower="{-most}" upper="{most}" effort="60" velocity="2.0"/></joint>"""


def fixed(name: str, parent: str, child: str, at: tuple[float, float, float], rpy: str = "0 0 0") -> str:
    """Return a rigid joint."""
    x, y, z = at
    return f"""<joint name="{name}" type="fixed"><origin xyz="{x} {y} {z}" rpy="{rpy}"/>
      <parent link="{parent}"/><child link="{child}"/></joint>"""


def describe(document: UrdfDocument) -> RobotDescription:
    """Return what the robot publishes about itself: all that skills know of it."""
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=groups(document, {ARM: (JOINTS, Smoothness(acceleration=4.0, jerk=40.0))}),
        end_effectors=(
            EndEffector(
                side="single",
                group=ARM,
                frame=tool_frame("gripper"),
                touch_links=(*HAND.finger_links, MOUNT),
                gripper=gripper_of(HAND),
                work_point=(0.75, 0.0),
            ),
        ),
        cameras=(
            CameraSensor(
                name="mast",
                frame="mast_optical_frame",
                width=1280,
                height=720,
                horizontal_fov=math.radians(70.0),
            ),
        ),
        lasers=(
            LaserSensor(
                name="front",
                frame="laser_frame",
                angle_min=-math.radians(120.0),
                angle_step=math.radians(0.5),
                beams=481,
                range_min=0.05,
                range_max=10.0,
                period=0.1,
            ),
        ),
        bumpers=bumpers(),
        drive=DRIVE,
        postures=(
            Posture(name="home", group=ARM, positions=HOME),
            Posture(name="carry", group=ARM, positions=HOME),
        ),
        period=0.01,
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, HEIGHT, compose)
