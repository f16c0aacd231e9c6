"""ROS messages to the readings that the hardware's keys carry."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.skills.geometry.poses import to_floor
from tandem.skills.ports.checks import LARGEST, too_large
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.sensors import CliffSensor

if TYPE_CHECKING:
    from tandem.skills.ports.sensors import LaserSensor, RangeSensor
    from tandem.skills.ros.messages import Header, RosPose, RosRange, RosScan, Xyz, Xyzw

ANGLE_OFF: Final = 1e-3
"""rad by which the ends of a scan may differ from the description: drivers round their angles."""


class UnfitError(ValueError):
    """A message that says something else than the robot's description; the text says what."""


def seconds_of(header: Header) -> float:
    """Return a header's stamp in ROS seconds; 0 when it has none."""
    return header.stamp.sec + header.stamp.nanosec * 1e-9


def measured(what: str, *values: float) -> tuple[float, ...]:
    """Return numbers as floats.

    Raises:
        UnfitError: one of them is none, or larger than any robot tells.
    """
    told = tuple(map(float, values))
    if too_large(told):
        raise UnfitError(f"expected {what} of at most {LARGEST:.0e}; found {', '.join(map(str, told))}")
    return told


def pose_of(position: Xyz, orientation: Xyzw) -> Pose:
    """Return a pose.

    Raises:
        UnfitError: its numbers are no pose.
    """
    x, y, z = measured("a position", position.x, position.y, position.z)
    values = (x, y, z)
    turn = (orientation.x, orientation.y, orientation.z, orientation.w)
    try:
        return Pose(position=values, orientation=turn)
    except ValueError as error:
        raise UnfitError(f"expected a pose; found position {values}, orientation {turn}") from error


def floor_pose_of(pose: RosPose) -> FloorPose:
    """Return x, y and heading of a pose."""
    return to_floor(pose_of(pose.position, pose.orientation))


def ranges_of(scan: RosScan, sensor: LaserSensor) -> tuple[float, ...]:
    """Return a scan's ranges in metres, as the description has its beams.

    What is measured as nothing (NaN, infinity, 0) or beyond ``range_max`` is ``range_max``; what is too near
    to be measured (minus infinity, below ``range_min``) is ``range_min`` (REP-117).

    Raises:
        UnfitError: other beams than described.
    """
    ranges = np.asarray(scan.ranges, dtype=np.float64)
    last = sensor.angle_min + (sensor.beams - 1) * sensor.angle_step
    found = scan.angle_min + (len(ranges) - 1) * scan.angle_increment
    if (
        len(ranges) != sensor.beams
        or not abs(scan.angle_min - sensor.angle_min) <= ANGLE_OFF  # NaN is near nothing
        or not abs(found - last) <= ANGLE_OFF
    ):
        raise UnfitError(
            f"expected {sensor.beams} beams from {sensor.angle_min:.4f} to {last:.4f} rad of laser "
            f"{sensor.name!r}; found {len(ranges)} from {scan.angle_min:.4f} to {found:.4f} rad"
        )
    nothing = ~(np.isfinite(ranges) | np.isneginf(ranges)) | (ranges == 0.0)
    limited = np.clip(ranges, sensor.range_min, sensor.range_max)
    return tuple(np.where(nothing, sensor.range_max, limited).round(4).tolist())


def distance_of(told: RosRange, sensor: RangeSensor | CliffSensor) -> float | None:
    """Return metres; None when nothing was measured (NaN): the sensor is silent.

    Plus infinity is "nothing there" (REP-117), which of a cliff sensor is an edge.
    """
    distance = float(told.range)
    if math.isnan(distance):
        return None
    nearest = 0.0 if isinstance(sensor, CliffSensor) else sensor.range_min
    return round(min(max(distance, nearest), sensor.range_max), 4)
