"""Interbotix' arm WX250s and its hand: six joints, two fingers that slide. As on a LoCoBot.

Joints, limits and masses are those of ``mobile_wx250s.urdf.xacro``; the shapes are boxes of the size of its
parts, and what no file tells is stated here as ours.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.sim.model import ROOT, Hand
from tandem.sim.robots.primitives import box, fixed, link, turning
from tandem.skills.ports.message import HandName, Vector3
from tandem.skills.ports.robot_description import EndEffector, Gripper

MOUNT: Final = "gripper_mount"
TOOL: Final = "ee_gripper_link"
FINGERS: Final = ("left_finger", "right_finger")
JOINTS: Final = ("waist", "shoulder", "elbow", "forearm_roll", "wrist_angle", "wrist_rotate")
FINGER_TRAVEL: Final = (0.015, 0.037)
"""Metres from the middle: 30 to 74 mm between the pads."""
FINGER_FORCE: Final = 5.0
"""Newtons of one finger: the limit of its joint's effort."""
FINGER_SPEED: Final = 0.025
"""Ours, m/s: the maker names none."""
PALM: Final = 0.022
"""Metres from the palm to the middle of the pads."""


def links() -> str:
    """Return the links of arm and hand, as URDF."""
    return (
        link("arm_base_link", 0.380, (0.0, 0.0, 0.034), box((0.0, 0.0, 0.0255), (0.103, 0.103, 0.051)))
        + link("shoulder_link", 0.481, (0.0, 0.0, 0.007), box((0.0, 0.0, 0.022), (0.072, 0.086, 0.060)))
        + link(
            "upper_arm_link",
            0.431,
            (0.017, 0.0, 0.191),
            box((0.0, 0.0, 0.120), (0.045, 0.06, 0.26)) + box((0.030, 0.0, 0.25), (0.064, 0.06, 0.037)),
        )
        + link("upper_forearm_link", 0.235, (0.108, 0.0, 0.0), box((0.080, 0.0, 0.0), (0.19, 0.042, 0.042)))
        + link("lower_forearm_link", 0.221, (0.037, 0.005, 0.0), box((0.037, 0.0, 0.0), (0.08, 0.06, 0.05)))
        + link("wrist_link", 0.085, (0.042, 0.0, 0.0106), box((0.030, 0.0, 0.007), (0.066, 0.044, 0.055)))
        + link("gripper_link", 0.073, (0.022, 0.0, 0.011), box((0.012, 0.0, 0.007), (0.03, 0.04, 0.055)))
        + link(MOUNT, 0.036, (0.010, 0.0, 0.005), box((0.014, 0.0, 0.004), (0.028, 0.103, 0.036)))
        + "".join(_finger(name, sign) for name, sign in zip(FINGERS, (1, -1), strict=True))
    )


def joints(mount: Vector3) -> str:
    """Return their joints, as URDF.

    Args:
        mount: of the arm on the base's root (m).
    """
    pi = math.pi - 0.00001
    degrees = math.radians
    return (
        fixed("arm_mount", ROOT, "arm_base_link", mount)
        + turning("waist", "arm_base_link", "shoulder_link", (0.0, 0.0, 0.066175), "0 0 1", (-pi, pi), 10)
        + turning(
            "shoulder",
            "shoulder_link",
            "upper_arm_link",
            (0.0, 0.0, 0.03865),
            "0 1 0",
            (degrees(-108), degrees(114)),
            20,
        )
        + turning(
            "elbow",
            "upper_arm_link",
            "upper_forearm_link",
            (0.04975, 0.0, 0.25),
            "0 1 0",
            (degrees(-123), degrees(92)),
            15,
        )
        + turning(
            "forearm_roll",
            "upper_forearm_link",
            "lower_forearm_link",
            (0.175, 0.0, 0.0),
            "1 0 0",
            (-pi, pi),
            2,
        )
        + turning(
            "wrist_angle",
            "lower_forearm_link",
            "wrist_link",
            (0.075, 0.0, 0.0),
            "0 1 0",
            (degrees(-100), degrees(123)),
            5,
        )
        + turning("wrist_rotate", "wrist_link", "gripper_link", (0.065, 0.0, 0.0), "1 0 0", (-pi, pi), 1)
        + fixed("gripper_mount_joint", "gripper_link", MOUNT, (0.043, 0.0, 0.0))
        + "".join(_sliding(name, sign) for name, sign in zip(FINGERS, (1, -1), strict=True))
    )


def tool() -> str:
    """Return the tool's frame between the pads, as URDF."""
    return f'<link name="{TOOL}"/>' + fixed("ee_gripper", MOUNT, TOOL, (0.050575, 0.0, 0.0))


def hand(side: HandName) -> Hand:
    """Return what the simulation drives as a hand."""
    left, right = FINGERS
    return Hand(
        side=side,
        mount_link=MOUNT,
        wrench_joint="gripper_mount_joint",
        inner=left,
        outer=right,
        finger_links=(f"{left}_link", f"{right}_link"),
    )


def end_effector(side: HandName, group: str, work_point: tuple[float, float]) -> EndEffector:
    """Return the hand as the robot describes it.

    Args:
        side: the hand's name.
        group: the arm's.
        work_point: x and y in the base (m) around which the hand works best at table height.
    """
    fingers = hand(side)
    return EndEffector(
        side=side,
        group=group,
        frame=TOOL,
        touch_links=(*fingers.finger_links, fingers.mount_link),
        gripper=Gripper(
            joints=(fingers.inner, fingers.outer),
            min_width=2 * FINGER_TRAVEL[0],
            max_width=2 * FINGER_TRAVEL[1],
            palm=PALM,
            speed=2 * FINGER_SPEED,
            force=FINGER_FORCE,
        ),
        work_point=work_point,
    )


def _finger(name: str, sign: int) -> str:
    """Return a finger: 55 mm long, its pad at the joint's position from the middle.

    It is heavier than the maker's 16 g, so that the physics' contacts are calm.
    """
    return link(
        f"{name}_link",
        0.04,
        (0.0155, sign * 0.006, 0.0),
        box((0.0155, sign * 0.006, 0.0), (0.055, 0.012, 0.029)),
    )


def _sliding(name: str, sign: int) -> str:
    low, high = FINGER_TRAVEL
    return f"""<joint name="{name}" type="prismatic"><origin xyz="0.023 0 0"/>
        <parent link="{MOUNT}"/><child link="{name}_link"/><axis xyz="0 {sign} 0"/>
        <limit lower="{low}" upper="{high}" effort="{FINGER_FORCE}" velocity="{FINGER_SPEED}"/></joint>"""
