"""The sensors that the shipped robots carry."""

from __future__ import annotations

import math
from typing import Final

from tandem.sim.model import QUARTERS
from tandem.skills.ports.sensors import Bumper, CameraSensor, LaserSensor, PoseSensor, RangeSensor

CAMERA_WIDTH: Final = 1280
CAMERA_HEIGHT: Final = 720
"""Pixels, of colour and depth alike."""
CAMERA_FIELD: Final = math.radians(60.0)
"""Horizontal."""

LASER_BEAMS: Final = 541
"""Half a degree apart."""
LASER_FIELD: Final = math.radians(270.0)
"""Radians: behind is the robot itself."""
LASER_RANGE: Final = (0.05, 10.0)
"""Metres."""
LASER_PERIOD: Final = 0.1
"""Robot seconds between two scans; ours, as small scanners have it."""

SONAR_CONE: Final = math.radians(30.0)
"""Radians, from edge to edge: as in the Stage simulator's model of the Pioneer, whose neighbours look
20 degrees apart, so that their cones overlap. The SUMMIT-XL's look 30 degrees apart: edge to edge."""
SONAR_RANGE: Final = (0.15, 5.0)
"""Metres: nearer things read as 0.15, and 5 says that there is nothing."""
SONAR_PERIOD: Final = 0.1
"""Robot seconds between two packets of the Pioneer's controller. The real sonars of an array fire one after
the other, 40 ms apart unless told to hurry; these fire together."""

CAPTURE_PERIOD: Final = 0.05
"""Robot seconds between two poses; ours."""
CAPTURE_SIGMA: Final = 0.010
CAPTURE_YAW_SIGMA: Final = math.radians(0.5)
"""10 mm and 0.5 degrees (RoCS, experiments)."""


def camera_sensor(frame: str) -> CameraSensor:
    """Return what a robot's description says of its camera."""
    return CameraSensor(
        name="head", frame=frame, width=CAMERA_WIDTH, height=CAMERA_HEIGHT, horizontal_fov=CAMERA_FIELD
    )


def laser_sensor(frame: str) -> LaserSensor:
    """Return what a robot's description says of its laser."""
    return LaserSensor(
        name="base",
        frame=frame,
        angle_min=-LASER_FIELD / 2,
        angle_step=LASER_FIELD / (LASER_BEAMS - 1),
        beams=LASER_BEAMS,
        range_min=LASER_RANGE[0],
        range_max=LASER_RANGE[1],
        period=LASER_PERIOD,
    )


def range_sensor(name: str, frame: str) -> RangeSensor:
    """Return what a robot's description says of one of its sonars."""
    return RangeSensor(
        name=name,
        frame=frame,
        cone=SONAR_CONE,
        range_min=SONAR_RANGE[0],
        range_max=SONAR_RANGE[1],
        period=SONAR_PERIOD,
    )


def bumpers() -> tuple[Bumper, ...]:
    """Return the bumpers all around a base: each tells of contacts in its quarter."""
    return tuple(Bumper(name=each.name) for each in QUARTERS)


def motion_capture() -> PoseSensor:
    """Return a robot's place as motion capture tells it, with the errors of the RoCS paper."""
    return PoseSensor(
        name="markers", period=CAPTURE_PERIOD, position_sigma=CAPTURE_SIGMA, yaw_sigma=CAPTURE_YAW_SIGMA
    )
