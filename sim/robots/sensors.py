"""The sensors that the shipped robots carry."""

from __future__ import annotations

import math
from typing import Final

from tandem.sim.model import QUARTERS
from tandem.skills.ports.sensors import Bumper, CameraSensor, LaserSensor, PoseSensor

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


def bumpers() -> tuple[Bumper, ...]:
    """Return the bumpers all around a base: each tells of contacts in its quarter."""
    return tuple(Bumper(name=each.name) for each in QUARTERS)


def motion_capture() -> PoseSensor:
    """Return a robot's place as motion capture tells it, with the errors of the RoCS paper."""
    return PoseSensor(
        name="markers", period=CAPTURE_PERIOD, position_sigma=CAPTURE_SIGMA, yaw_sigma=CAPTURE_YAW_SIGMA
    )
