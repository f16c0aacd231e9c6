"""A parallel gripper with the figures of PAL's, to be mounted on any wrist: a palm and two prismatic fingers.

Along the mount's x, closing along its y. The links and joints are named after ``name``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.sim.model import Hand
from tandem.skills.ports.robot_description import Gripper

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

FINGER_TRAVEL: Final = 0.045
"""Metres of one finger."""
FINGER_FORCE: Final = 16.0
"""Newtons of one finger."""
FINGER_SPEED: Final = 0.05
"""m/s of one finger."""
PALM_LENGTH: Final = 0.06
FINGER_LENGTH: Final = 0.085
FINGER_THICKNESS: Final = 0.012
FINGER_HEIGHT: Final = 0.024
"""Metres: the boxes that stand for palm and fingers. Both lengths, less TIP_BEYOND_GRASP, put the tool's
origin 0.13 m before the mount."""
TIP_BEYOND_GRASP: Final = 0.015
"""How far the fingertips reach past the tool frame's origin: short, so that they clear the table."""


def hand(side: str, name: str, *, mount: str, wrench_joint: str) -> Hand:
    """Return the hand of this gripper.

    Args:
        side: the hand's name in the description.
        name: of the gripper, such as ``gripper_left``.
        mount: the link that it is mounted on.
        wrench_joint: the joint before it, whose reaction the wrist's sensor measures.
    """
    inner, outer = (f"{name}_{which}_finger" for which in ("inner", "outer"))
    return Hand(
        side=side,
        mount_link=mount,
        wrench_joint=wrench_joint,
        inner=f"{inner}_joint",
        outer=f"{outer}_joint",
        finger_links=(f"{inner}_link", f"{outer}_link"),
    )


def gripper(of: Hand) -> Gripper:
    """Return what a description says of it."""
    return Gripper(
        joints=(of.inner, of.outer),
        max_width=2.0 * FINGER_TRAVEL,
        speed=2.0 * FINGER_SPEED,
        force=FINGER_FORCE,
    )


def tool_frame(name: str) -> str:
    """Return the frame between the pads."""
    return f"{name}_grasping_frame"


def fit(document: UrdfDocument, name: str, *, mount: str) -> None:
    """Mount a gripper on a link that carries nothing."""
    tool = PALM_LENGTH + FINGER_LENGTH - TIP_BEYOND_GRASP
    document.add(f"""
      <link name="{name}_palm_link">
        <inertial><origin xyz="{PALM_LENGTH / 2} 0 0"/><mass value="0.5"/>
          <inertia ixx="0.0007" ixy="0" ixz="0" iyy="0.0003" iyz="0" izz="0.0007"/></inertial>
        <collision><origin xyz="{PALM_LENGTH / 2} 0 0"/>
          <geometry><box size="{PALM_LENGTH} 0.12 0.05"/></geometry></collision>
      </link>
      <joint name="{name}_palm_joint" type="fixed"><origin xyz="0 0 0"/>
        <parent link="{mount}"/><child link="{name}_palm_link"/></joint>
      {_finger(name, "inner", 1)}{_finger(name, "outer", -1)}
      <link name="{name}_grasping_frame"/>
      <joint name="{name}_grasping_joint" type="fixed"><origin xyz="{tool} 0 0"/>
        <parent link="{mount}"/><child link="{name}_grasping_frame"/></joint>""")


def _finger(of: str, which: str, sign: int) -> str:
    name = f"{of}_{which}_finger"
    centre = f"{FINGER_LENGTH / 2} {sign * FINGER_THICKNESS / 2} 0"
    size = f"{FINGER_LENGTH} {FINGER_THICKNESS} {FINGER_HEIGHT}"
    return f"""
      <link name="{name}_link">
        <inertial><origin xyz="{centre}"/><mass value="0.1"/>
          <inertia ixx="0.00001" ixy="0" ixz="0" iyy="0.00007" iyz="0" izz="0.00007"/></inertial>
        <collision><origin xyz="{centre}"/><geometry><box size="{size}"/></geometry></collision>
      </link>
      <joint name="{name}_joint" type="prismatic"><origin xyz="{PALM_LENGTH} 0 0"/>
        <parent link="{of}_palm_link"/><child link="{name}_link"/>
        <axis xyz="0 {sign} 0"/>
        <limit lower="0" upper="{FINGER_TRAVEL}" effort="{FINGER_FORCE}" velocity="{FINGER_SPEED}"/>
      </joint>"""
