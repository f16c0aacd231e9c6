"""Robots that the sim can stand in for. Needs the extra ``sim``.

``UrdfDocument`` loads numpy. Import it where the robot is put together, in ``compose``: commands that only
ask which room a robot takes then run without it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tandem.sim.model import ROOT, Hand, RobotModel, Sector, Wheels
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import Smoothness, group, groups
from tandem.sim.robots.parallel_gripper import fit as fit_gripper
from tandem.sim.robots.parallel_gripper import gripper as gripper_of
from tandem.sim.robots.parallel_gripper import hand as hand_of
from tandem.sim.robots.parallel_gripper import tool_frame
from tandem.sim.robots.primitives import ball_wheel, frame, wheel
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import bumpers
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.robot_description import (
    ArmsCrossing,
    DifferentialDrive,
    EndEffector,
    Gripper,
    JointGroup,
    JointLimit,
    Posture,
    RobotDescription,
    SkidSteerDrive,
)
from tandem.skills.ports.sensors import (
    Bumper,
    CameraSensor,
    CliffSensor,
    LaserSensor,
    PoseSensor,
    RangeSensor,
    RobotSensor,
)

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

__all__ = [
    "ROOT",
    "ArmsCrossing",
    "Bumper",
    "CameraSensor",
    "CliffSensor",
    "DifferentialDrive",
    "EndEffector",
    "Gripper",
    "Hand",
    "JointGroup",
    "JointLimit",
    "LaserSensor",
    "PoseSensor",
    "Posture",
    "RangeSensor",
    "ReflexSetting",
    "Robot",
    "RobotDescription",
    "RobotModel",
    "RobotSensor",
    "Sector",
    "SkidSteerDrive",
    "Smoothness",
    "UrdfDocument",
    "Wheels",
    "ball_wheel",
    "bumpers",
    "finish",
    "fit_gripper",
    "frame",
    "gripper_of",
    "group",
    "groups",
    "hand_of",
    "resolve",
    "tool_frame",
    "wheel",
]


def __getattr__(name: str) -> object:
    """Load what needs numpy when it is asked for."""
    if name != "UrdfDocument":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - see above

    return UrdfDocument
