"""Franka Emika's Panda on a pedestal, with a parallel gripper, and a camera on a post beside it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, Hand, RobotModel
from tandem.sim.robots import parallel_gripper
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import Smoothness, group
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import camera_sensor
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.robot_description import EndEffector, Posture, RobotDescription

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument as Document

NAME: Final = "panda"
SOURCE: Final = "package://example-robot-data/robots/panda_description/urdf/panda.urdf"
HAND: Final = "single"
ARM: Final = f"arm_{HAND}"
GRIPPER: Final = "gripper"
MOUNT: Final = "panda_mount"
CAMERA_FRAME: Final = "post_optical_frame"
FOOTPRINT_RADIUS: Final = 0.20
"""Metres: the pedestal."""
HEIGHT: Final = 1.6
"""Metres, with the arm up."""
PEDESTAL: Final = (0.24, 0.24, 0.60)
"""Edges in metres."""
POST_XY: Final = (0.05, 0.62)
"""Metres in the base: the camera's post stands at the arm's left."""
CAMERA_HEIGHT: Final = 1.25
"""Metres above the floor: half a metre above where it looks."""
LOOKS_AT: Final = (0.62, 0.0, 0.76)
"""Where the camera looks, in the base (m): the middle of a table before the robot."""
SMOOTH: Final = Smoothness(acceleration=5.0, jerk=50.0)
"""Ours; the maker allows 7.5 to 20 rad/s2 and 3,750 rad/s3 or more, joint by joint."""
HOME: Final = (0.0, -1.10, 0.0, -2.60, 0.0, 2.30, 0.785)
"""The arm folded back over the pedestal, the hand before it, level with the shoulder."""


def compose() -> RobotModel:
    """Put the robot together from the installed description.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - loads numpy; the room it takes is known without

    document = UrdfDocument(resolve(SOURCE).read_text(encoding="utf-8"))
    document.cut("panda_hand")
    document.add(_surroundings())
    document.put_first(ROOT)
    parallel_gripper.fit(document, GRIPPER, mount=MOUNT)
    hand = _hand()
    physics_urdf, frames = finish(document, (MOUNT,))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(hand,),
        wheels=None,
        floor_frictions={},
        bumper_links=(),
        touching_links=(("panda_link5", "panda_link7"), hand.finger_links),
    )


def _surroundings() -> str:
    """Return pedestal, post with camera, and the gripper's mount, whose x is out of the wrist."""
    x, y = POST_XY
    length, width, height = PEDESTAL
    yaw = math.atan2(LOOKS_AT[1] - y, LOOKS_AT[0] - x)
    down = math.atan2(CAMERA_HEIGHT - LOOKS_AT[2], math.hypot(LOOKS_AT[0] - x, LOOKS_AT[1] - y))
    half = math.pi / 2
    return f"""
      <link name="{ROOT}">
        <inertial><origin xyz="0 0 {height / 2}"/><mass value="40"/>
          <inertia ixx="1.4" ixy="0" ixz="0" iyy="1.4" iyz="0" izz="0.4"/></inertial>
        <collision><origin xyz="0 0 {height / 2}"/>
          <geometry><box size="{length} {width} {height}"/></geometry></collision>
        <collision><origin xyz="{x} {y} {CAMERA_HEIGHT / 2 - 0.05}"/>
          <geometry><box size="0.04 0.04 {CAMERA_HEIGHT - 0.1}"/></geometry></collision>
      </link>
      <joint name="pedestal_joint" type="fixed"><origin xyz="0 0 {height}"/>
        <parent link="{ROOT}"/><child link="panda_link0"/></joint>
      <link name="post_link"/>
      <joint name="post_joint" type="fixed"><origin xyz="{x} {y} {CAMERA_HEIGHT}" rpy="0 {down} {yaw}"/>
        <parent link="{ROOT}"/><child link="post_link"/></joint>
      <link name="{CAMERA_FRAME}"/>
      <joint name="post_optical_joint" type="fixed"><origin xyz="0 0 0" rpy="{-half} 0 {-half}"/>
        <parent link="post_link"/><child link="{CAMERA_FRAME}"/></joint>
      <link name="{MOUNT}"/>
      <joint name="{MOUNT}_joint" type="fixed"><origin xyz="0 0 0" rpy="0 {-half} 0"/>
        <parent link="panda_link8"/><child link="{MOUNT}"/></joint>"""


def _describe(document: Document) -> RobotDescription:
    hand = _hand()
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=(group(document, ARM, tuple(f"panda_joint{i}" for i in range(1, 8)), SMOOTH),),
        end_effectors=(
            EndEffector(
                side=HAND,
                group=ARM,
                frame=parallel_gripper.tool_frame(GRIPPER),
                touch_links=(*hand.finger_links, hand.mount_link),
                gripper=parallel_gripper.gripper(hand),
                work_point=(0.55, 0.0),
                safe_point=(0.45, 0.0, 1.10),
            ),
        ),
        cameras=(camera_sensor(CAMERA_FRAME),),
        postures=(
            Posture(name="home", group=ARM, positions=HOME),
            Posture(name="carry", group=ARM, positions=HOME),
        ),
        period=0.01,
    )


def _hand() -> Hand:
    return parallel_gripper.hand(HAND, GRIPPER, mount=MOUNT, wrench_joint=f"{MOUNT}_joint")


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, HEIGHT, compose)
