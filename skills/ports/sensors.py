"""The sensors that a robot's description lists, and what each of them tells.

Frames are named in the description's URDF. Ranges and positions are in metres, angles in radians. A laser's
scans have a key for each laser; the other sensors of one kind share one (``tandem.skills.ports.keys``).
"""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import Field, model_validator

from tandem.skills.ports.message import Count, Message, PartName, Positive, RobotTime, repeated
from tandem.skills.ports.pose import FloorPose

Distance = Annotated[float, Field(ge=0.0)]


class CameraSensor(Message):
    """An RGB-D camera; ``frame`` is optical: z forward, x right, y down."""

    name: PartName
    frame: str
    width: Count
    height: Count
    horizontal_fov: Positive
    """Radians."""


class LaserSensor(Message):
    """A 2D laser; ``frame`` has x at angle 0 and z up."""

    name: PartName
    frame: str
    angle_min: float
    angle_step: Positive
    beams: Count
    range_min: float
    range_max: float
    period: Positive


class RangeSensor(Message):
    """A sonar or another sensor that tells one distance: of the nearest thing in its cone.

    ``frame`` has x along the cone's axis, away from the robot. What is nearer than ``range_min`` reads as
    ``range_min``.
    """

    name: PartName
    frame: str
    cone: Annotated[float, Field(gt=0.0, le=math.pi)]
    """Full opening angle, in radians."""
    range_min: Distance
    range_max: Positive
    period: Positive

    @model_validator(mode="after")
    def _ordered(self) -> RangeSensor:
        if self.range_min >= self.range_max:
            raise ValueError(
                f"range sensor {self.name!r}: expected a range_min below range_max, "
                f"found {self.range_min:g} and {self.range_max:g}"
            )
        return self


class CliffSensor(Message):
    """Looks down before the wheels, and tells how far the floor is.

    ``frame`` has x straight down: how high it is above the base's frame is what it reads over an even floor.
    """

    name: PartName
    frame: str
    range_max: Positive
    """Metres: a floor as far away as this or farther reads as this."""
    lead: Positive
    """Metres between it and what carries the base behind it: how far the base may go on that sees an edge."""
    period: Positive


class PoseSensor(Message):
    """Tells where the base is in the map, as motion capture does: it doesn't drift."""

    name: PartName
    period: Positive
    position_sigma: Distance
    """Standard deviation of x, and of y, in metres, as the maker states it."""
    yaw_sigma: Distance
    """Standard deviation of the heading, in radians."""


class RobotSensor(Message):
    """Sees other robots, and tells them apart; ``frame`` has x in the middle of its field and z up."""

    name: PartName
    frame: str
    field: Annotated[float, Field(gt=0.0, le=2.0 * math.pi)]
    """Full horizontal opening angle, in radians."""
    range_max: Positive
    period: Positive


class Bumper(Message):
    """A contact switch on the base; ``Bumpers.pressed`` names it."""

    name: PartName


class LaserScan(Message):
    """Ranges in metres, counter-clockwise from angle_min; range_max or more means nothing seen."""

    stamp: RobotTime
    ranges: tuple[Distance, ...]


class RangeReading(Message):
    """What one range sensor measured: metres from its frame; range_max or more means nothing seen."""

    sensor: PartName
    distance: Distance


class Ranges(Message):
    """The last reading of each range sensor; one that is silent is missing."""

    stamp: RobotTime
    readings: tuple[RangeReading, ...]

    @model_validator(mode="after")
    def _each_once(self) -> Ranges:
        if twice := repeated(each.sensor for each in self.readings):
            raise ValueError(f"expected one reading of each sensor, several of: {', '.join(twice)}")
        return self

    def of(self, sensor: str) -> float | None:
        """Return the distance that a sensor measured, in metres, or None: it is silent."""
        return next((each.distance for each in self.readings if each.sensor == sensor), None)


class Cliffs(Ranges):
    """The last distance to the floor of each cliff sensor, in metres; one that is silent is missing."""


class PoseReading(Message):
    """Where a pose sensor has the base, in the map."""

    stamp: RobotTime
    sensor: PartName
    base_in_map: FloorPose


class SeenRobot(Message):
    """Another robot: the middle of its base, in the base of the robot that sees it (m)."""

    name: Annotated[str, Field(min_length=1, max_length=60)]
    x: float
    y: float


class RobotsSeen(Message):
    """The other robots that a sensor sees now; none when it sees none."""

    stamp: RobotTime
    sensor: PartName
    robots: tuple[SeenRobot, ...]

    @model_validator(mode="after")
    def _each_once(self) -> RobotsSeen:
        if twice := repeated(each.name for each in self.robots):
            raise ValueError(f"expected each robot once, several times there: {', '.join(twice)}")
        return self


class Bumpers(Message):
    """The bumpers that are pressed."""

    stamp: RobotTime
    pressed: tuple[str, ...]
