"""TIAGo without an arm: base, torso and head. It sees and drives, and takes hold of nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, RobotModel
from tandem.sim.robots import pmb2, tiago_upper
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import groups
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import bumpers, camera_sensor, laser_sensor
from tandem.skills.ports.robot_description import RobotDescription

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "tiago_base"
FOOTPRINT_RADIUS: Final = 0.30
"""Metres: the base itself."""


def compose() -> RobotModel:
    """Put the robot together from the installed description.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    document = tiago_upper.load("tiago.urdf")
    document.cut("arm_1_link")
    physics_urdf, frames = finish(document, (pmb2.CASTERS_LINK,))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(),
        wheels=pmb2.WHEELS,
        floor_frictions=pmb2.FLOOR_FRICTIONS,
        bumper_links=pmb2.BUMPER_LINKS,
        touching_links=(),
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=tiago_upper.HEIGHT,
        groups=groups(document, tiago_upper.GROUPS),
        end_effectors=(),
        cameras=(camera_sensor(tiago_upper.CAMERA_FRAME),),
        lasers=(laser_sensor(pmb2.LASER_FRAME),),
        bumpers=bumpers(),
        drive=pmb2.DRIVE,
        postures=tiago_upper.POSTURES,
        period=tiago_upper.PERIOD,
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, tiago_upper.HEIGHT, compose)
