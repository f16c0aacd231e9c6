"""TIAGo: one arm, with a parallel gripper in place of its hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, Hand, RobotModel
from tandem.sim.robots import parallel_gripper, pmb2, tiago_upper
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import groups
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import bumpers, camera_sensor, laser_sensor
from tandem.skills.ports.robot_description import EndEffector, Posture, RobotDescription

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "tiago"
HAND: Final = "single"
ARM: Final = f"arm_{HAND}"
MOUNT: Final = "wrist_ft_tool_link"
GRIPPER: Final = "gripper"
FOOTPRINT_RADIUS: Final = 0.35
"""Metres. What the hand carries reaches 0.383 m from the base's axis, within the margin that arms have; the
base itself 0.30 m."""
ARM_HOME: Final = (0.20, -1.34, -0.20, 1.94, -1.57, 1.37, 0.0)
"""PAL's: the arm folded before the torso, 0.283 m from the base's axis at the most."""
ARM_CARRY: Final = (0.727, -1.159, -0.379, 2.303, 1.555, 0.348, 1.711)
"""The hand level at the left of the torso, 0.80 m high with the torso at 0.30 m, pointing to the left.

Found by a random search: the hand upright, 3 cm between the forearm and the torso, also with the torso at
0.15 m.
"""
POSTURES: Final = (
    Posture(name="home", group=ARM, positions=ARM_HOME),
    Posture(name="carry", group=ARM, positions=ARM_CARRY),
    *tiago_upper.POSTURES,
)


def compose() -> RobotModel:
    """Put the robot together from the installed description.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    document = tiago_upper.load("tiago.urdf")
    tiago_upper.cut_hand(document, MOUNT)
    parallel_gripper.fit(document, GRIPPER, mount=MOUNT)
    hand = _hand()
    physics_urdf, frames = finish(document, (MOUNT, pmb2.CASTERS_LINK))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(hand,),
        wheels=pmb2.WHEELS,
        floor_frictions=pmb2.FLOOR_FRICTIONS,
        bumper_links=pmb2.BUMPER_LINKS,
        touching_links=(("arm_5_link", "arm_7_link"), hand.finger_links),
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    arm = {ARM: (tuple(f"arm_{i}_joint" for i in range(1, 8)), tiago_upper.TURNING)}
    hand = _hand()
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=tiago_upper.HEIGHT,
        groups=groups(document, {**arm, **tiago_upper.GROUPS}),
        end_effectors=(
            EndEffector(
                side=HAND,
                group=ARM,
                frame=parallel_gripper.tool_frame(GRIPPER),
                touch_links=(*hand.finger_links, hand.mount_link),
                gripper=parallel_gripper.gripper(hand),
                work_point=(0.62, 0.0),
                work_heading=0.0,
            ),
        ),
        cameras=(camera_sensor(tiago_upper.CAMERA_FRAME),),
        lasers=(laser_sensor(pmb2.LASER_FRAME),),
        bumpers=bumpers(),
        drive=pmb2.DRIVE,
        postures=POSTURES,
        period=tiago_upper.PERIOD,
    )


def _hand() -> Hand:
    return parallel_gripper.hand(HAND, GRIPPER, mount=MOUNT, wrench_joint="wrist_tool_joint")


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, tiago_upper.HEIGHT, compose)
