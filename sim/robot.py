"""The robot that the sim stands in for: TIAGo++ with a parallel gripper on each wrist.

The arms, torso, head and base are those of the URDF that ``example-robot-data`` installs; the hands are cut
off and grippers with the figures of PAL's are put in their place. What the URDF leaves open
(accelerations, jerks, the grippers, the laser's mount) is stated here and nowhere else.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping
from typing import Final, Literal

import numpy as np

from tandem.sim.camera import camera_sensor
from tandem.sim.footprint import FOOTPRINT_RADIUS, HEIGHT
from tandem.sim.laser import laser_sensor
from tandem.sim.model import ROOT, Hand, RobotModel, Wheels
from tandem.sim.postures import POSTURES
from tandem.sim.urdf import UrdfDocument, end_of
from tandem.skills.ports.hardware import (
    ArmsCrossing,
    Drive,
    EndEffector,
    Gripper,
    JointGroup,
    JointLimit,
    RobotDescription,
)
from tandem.skills.ports.packages import resolve

SOURCE: Final = "package://example-robot-data/robots/tiago_description/robots/tiago_dual.urdf"
Side = Literal["left", "right"]
SIDES: Final[tuple[Side, Side]] = ("left", "right")
PERIOD: Final = 0.01
"""Seconds between two messages of the clock and of the joints' state."""
CAMERA_FRAME: Final = "xtion_rgb_optical_frame"
LASER_FRAME: Final = "base_laser_link"

ACCELERATION: Final = {"arm": 5.0, "head": 5.0, "torso": 0.35}
"""rad/s2 (torso: m/s2). Ours: the URDF names none."""
JERK: Final = {"arm": 50.0, "head": 50.0, "torso": 3.5}
"""rad/s3 (torso: m/s3). Ours."""

DRIVE: Final = Drive(
    forward=1.0, backward=0.2, acceleration=0.5, turn=1.05, turn_acceleration=1.05, dead_man=0.3
)
"""PAL's configuration of the PMB2 base, and our dead-man."""
WHEELS: Final = Wheels("wheel_left_joint", "wheel_right_joint", radius=0.0985, track=0.4044, effort=6.0)

ARMS_CROSSING: Final = ArmsCrossing(k=0.21, gamma=0.0, mu=0.0, clearance=0.03)
"""Found with ``python -m benchmarks.crossing_tuning``; see docs/decisions/005-arms-crossing.md."""

FINGER_TRAVEL: Final = 0.045
FINGER_FORCE: Final = 16.0
FINGER_SPEED: Final = 0.05
PALM_LENGTH: Final = 0.06
FINGER_LENGTH: Final = 0.085
FINGER_THICKNESS: Final = 0.012
FINGER_HEIGHT: Final = 0.024
TIP_BEYOND_GRASP: Final = 0.015
"""How far the fingertips reach past the tool frame's origin: short, so that they clear the table."""

LASER_IN_BASE: Final = (0.202, 0.0, 0.0945)
CASTERS_XY: Final = ((0.1535, 0.102), (0.1535, -0.102), (-0.1895, 0.102), (-0.1895, -0.102))
CASTER_RADIUS: Final = 0.025
DARK: Final = ("finger", "wheel", "caster", "_2_link")
"""Links with one of these in their name are drawn dark."""


def compose_robot() -> RobotModel:
    """Build the robot from the installed description.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    document = UrdfDocument(resolve(SOURCE).read_text(encoding="utf-8"))
    _fit_base(document)
    for side in SIDES:
        _fit_gripper(document, side)
    hands = tuple(_hand(side) for side in SIDES)
    document.weld([*(hand.mount_link for hand in hands), "casters_link"])
    frames = {link: (link, np.eye(4)) for link in document.links()} | document.welded
    _draw_collision_shapes(document)
    document.check()
    physics_urdf = document.text()
    for name, (link, at) in sorted(document.welded.items()):
        document.add_frame(name, link, at)
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=hands,
        wheels=WHEELS,
        floor_frictions={"wheel_left_link": 1.0, "wheel_right_link": 1.0, "casters_link": 0.0},
        bumper_links=(ROOT, "torso_lift_link"),
        touching_links=(
            *((f"arm_{side}_5_link", f"arm_{side}_7_link") for side in SIDES),
            *(hand.finger_links for hand in hands),
        ),
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    limits = {str(joint.get("name")): joint.find("limit") for joint in document.joints()}
    return RobotDescription(
        name="tiago_dual",
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=tuple(_groups(limits)),
        end_effectors=tuple(_end_effector(side) for side in SIDES),
        camera=camera_sensor(CAMERA_FRAME),
        laser=laser_sensor(LASER_FRAME),
        drive=DRIVE,
        postures=POSTURES,
        period=PERIOD,
        arms_crossing=ARMS_CROSSING,
    )


def _groups(limits: Mapping[str, ET.Element | None]) -> Iterable[JointGroup]:
    names = {
        "arm_left": [f"arm_left_{i}_joint" for i in range(1, 8)],
        "arm_right": [f"arm_right_{i}_joint" for i in range(1, 8)],
        "torso": ["torso_lift_joint"],
        "head": ["head_1_joint", "head_2_joint"],
    }
    for group, joints in names.items():
        kind = group.split("_", maxsplit=1)[0]
        yield JointGroup(name=group, limits=tuple(_limit(kind, joint, limits[joint]) for joint in joints))


def _limit(kind: str, joint: str, limit: ET.Element | None) -> JointLimit:
    assert limit is not None
    return JointLimit(
        joint=joint,
        lower=float(limit.attrib["lower"]),
        upper=float(limit.attrib["upper"]),
        velocity=float(limit.attrib["velocity"]),
        acceleration=ACCELERATION[kind],
        jerk=JERK[kind],
        effort=float(limit.attrib["effort"]),
    )


def _hand(side: Side) -> Hand:
    inner, outer = (f"gripper_{side}_{which}_finger" for which in ("inner", "outer"))
    return Hand(
        side=side,
        mount_link=f"wrist_{side}_ft_tool_link",
        wrench_joint=f"wrist_{side}_tool_joint",
        inner=f"{inner}_joint",
        outer=f"{outer}_joint",
        finger_links=(f"{inner}_link", f"{outer}_link"),
    )


def _end_effector(side: Side) -> EndEffector:
    hand = _hand(side)
    return EndEffector(
        side=side,
        group=f"arm_{side}",
        frame=f"gripper_{side}_grasping_frame",
        touch_links=(*hand.finger_links, hand.mount_link),
        gripper=Gripper(
            joints=(hand.inner, hand.outer),
            max_width=2.0 * FINGER_TRAVEL,
            speed=2.0 * FINGER_SPEED,
            force=FINGER_FORCE,
        ),
        # With the torso at 0.3 m these leave most pitches and places open: a hand that points inwards has its
        # elbow out, and not in the torso.
        work_point=(0.58, 0.20 if side == "left" else -0.20),
        work_heading=math.radians(-45.0 if side == "left" else 45.0),
        safe_point=(0.38, 0.50 if side == "left" else -0.50, 1.00),
    )


def _fit_base(document: UrdfDocument) -> None:
    """Rigid suspension; four frictionless balls for the casters; a laser; no virtual sensors."""
    document.cut("rgbd_laser_link")
    for side in SIDES:
        document.cut(f"base_antenna_{side}_link")
        document.fix(f"suspension_{side}_joint")
        for end in ("front", "back"):
            document.cut(f"caster_{end}_{side}_1_link")
    balls = "".join(
        f'<collision><origin xyz="{x} {y} {CASTER_RADIUS}"/>'
        f'<geometry><sphere radius="{CASTER_RADIUS}"/></geometry></collision>'
        for x, y in CASTERS_XY
    )
    document.add(f"""
      <link name="casters_link">
        <inertial><origin xyz="-0.016 0 {CASTER_RADIUS}"/><mass value="0.56"/>
          <inertia ixx="0.006" ixy="0" ixz="0" iyy="0.016" iyz="0" izz="0.022"/></inertial>
        {balls}
      </link>
      <joint name="casters_joint" type="fixed"><origin xyz="0 0 0"/>
        <parent link="{ROOT}"/><child link="casters_link"/></joint>
      <link name="base_laser_link"/>
      <joint name="base_laser_joint" type="fixed">
        <origin xyz="{LASER_IN_BASE[0]} {LASER_IN_BASE[1]} {LASER_IN_BASE[2]}"/>
        <parent link="{ROOT}"/><child link="base_laser_link"/></joint>""")


def _fit_gripper(document: UrdfDocument, side: Side) -> None:
    """Cut the hand; mount a palm and two prismatic fingers along the tool link's x, closing along y."""
    mount = f"wrist_{side}_ft_tool_link"
    hand = [joint for joint in document.joints() if end_of(joint, "parent") == mount]
    for link in [end_of(joint, "child") for joint in hand]:
        document.cut(link)
    tool = PALM_LENGTH + FINGER_LENGTH - TIP_BEYOND_GRASP
    document.add(f"""
      <link name="gripper_{side}_palm_link">
        <inertial><origin xyz="{PALM_LENGTH / 2} 0 0"/><mass value="0.5"/>
          <inertia ixx="0.0007" ixy="0" ixz="0" iyy="0.0003" iyz="0" izz="0.0007"/></inertial>
        <collision><origin xyz="{PALM_LENGTH / 2} 0 0"/>
          <geometry><box size="{PALM_LENGTH} 0.12 0.05"/></geometry></collision>
      </link>
      <joint name="gripper_{side}_palm_joint" type="fixed"><origin xyz="0 0 0"/>
        <parent link="{mount}"/><child link="gripper_{side}_palm_link"/></joint>
      {_finger(side, "inner", 1)}{_finger(side, "outer", -1)}
      <link name="gripper_{side}_grasping_frame"/>
      <joint name="gripper_{side}_grasping_joint" type="fixed"><origin xyz="{tool} 0 0"/>
        <parent link="{mount}"/><child link="gripper_{side}_grasping_frame"/></joint>""")


def _finger(side: str, which: str, sign: int) -> str:
    name = f"gripper_{side}_{which}_finger"
    centre = f"{FINGER_LENGTH / 2} {sign * FINGER_THICKNESS / 2} 0"
    size = f"{FINGER_LENGTH} {FINGER_THICKNESS} {FINGER_HEIGHT}"
    return f"""
      <link name="{name}_link">
        <inertial><origin xyz="{centre}"/><mass value="0.1"/>
          <inertia ixx="0.00001" ixy="0" ixz="0" iyy="0.00007" iyz="0" izz="0.00007"/></inertial>
        <collision><origin xyz="{centre}"/><geometry><box size="{size}"/></geometry></collision>
      </link>
      <joint name="{name}_joint" type="prismatic"><origin xyz="{PALM_LENGTH} 0 0"/>
        <parent link="gripper_{side}_palm_link"/><child link="{name}_link"/>
        <axis xyz="0 {sign} 0"/>
        <limit lower="0" upper="{FINGER_TRAVEL}" effort="{FINGER_FORCE}" velocity="{FINGER_SPEED}"/>
      </joint>"""


def _draw_collision_shapes(document: UrdfDocument) -> None:
    """Show the collision shapes: they draw fast, and what is seen is what collides."""
    for name in document.links():
        link = document.link(name)
        for visual in link.findall("visual"):
            link.remove(visual)
        colour = "DarkGrey" if any(word in name for word in DARK) else "White"
        for collision in link.findall("collision"):
            visual = ET.SubElement(link, "visual")
            for part in collision:
                if part.tag in ("origin", "geometry"):
                    visual.append(part)
            ET.SubElement(visual, "material", name=colour)
