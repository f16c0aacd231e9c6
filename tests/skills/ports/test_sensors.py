"""What a description may say of sensors, and what they may tell."""

from __future__ import annotations

import math

import pytest
from pydantic import ValidationError

from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import (
    Bumper,
    PoseReading,
    PoseSensor,
    RangeReading,
    Ranges,
    RangeSensor,
    RobotSensor,
    RobotsSeen,
    SeenRobot,
)
from tandem.skills.testing.mock_description import mock_description

ROBOT = mock_description()
NOW = RobotTime(boot="b", seconds=1.0)
SONAR = ROBOT.range_sensors[0].model_dump()


@pytest.mark.parametrize(
    "more",
    [
        {"cameras": ROBOT.cameras * 2},
        {"lasers": ROBOT.lasers * 2},
        {"range_sensors": ROBOT.range_sensors * 2},
        {"cliff_sensors": ROBOT.cliff_sensors * 2},
        {"pose_sensors": ROBOT.pose_sensors * 2},
        {"robot_sensors": ROBOT.robot_sensors * 2},
        {"bumpers": (Bumper(name="front"), Bumper(name="front"))},
    ],
    ids=lambda more: str(*more),
)
def test_sensors_of_one_kind_have_names_of_their_own(more: dict[str, object]) -> None:
    (field,) = more
    with pytest.raises(ValidationError, match=f"{field}: expected unique names"):
        RobotDescription.model_validate({**ROBOT.model_dump(), **more})


@pytest.mark.parametrize(
    "wrong",
    [
        {"range_min": 5.0},
        {"range_min": -0.1},
        {"range_max": 0.1},
        {"cone": 0.0},
        {"cone": 3.2},
        {"period": 0.0},
        {"name": "hw/clock"},
    ],
)
def test_a_range_sensor_that_cannot_be_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        RangeSensor.model_validate(SONAR | wrong)


def test_sensors_that_cannot_be_are_refused() -> None:
    with pytest.raises(ValidationError):
        PoseSensor(name="markers", period=0.05, position_sigma=-0.01, yaw_sigma=0.0)
    with pytest.raises(ValidationError):
        RobotSensor(name="others", frame="base", field=2.1 * math.pi, range_max=5.0, period=0.1)


def test_a_description_with_all_sensors_is_the_same_after_the_wire() -> None:
    assert RobotDescription.model_validate_json(ROBOT.model_dump_json()) == ROBOT


def test_a_description_of_before_these_sensors_still_reads() -> None:
    new = ("range_sensors", "cliff_sensors", "pose_sensors", "robot_sensors", "bumpers")
    old = {key: value for key, value in ROBOT.model_dump().items() if key not in new}
    assert RobotDescription.model_validate(old).range_sensors == ()


def test_each_sensor_has_one_reading_and_each_robot_is_seen_once() -> None:
    reading, robot = RangeReading(sensor="front", distance=1.0), SeenRobot(name="r1", x=1.0, y=0.0)
    with pytest.raises(ValidationError, match="several of: front"):
        Ranges(stamp=NOW, readings=(reading, reading))
    with pytest.raises(ValidationError, match="several times there: r1"):
        RobotsSeen(stamp=NOW, sensor="others", robots=(robot, robot))


def test_a_silent_sensor_has_no_reading() -> None:
    ranges = Ranges(stamp=NOW, readings=(RangeReading(sensor="front", distance=1.0),))
    assert (ranges.of("front"), ranges.of("left")) == (1.0, None)


@pytest.mark.parametrize("distance", [-0.1, math.nan, math.inf])
def test_a_distance_is_a_number_from_zero(distance: float) -> None:
    with pytest.raises(ValidationError):
        RangeReading(sensor="front", distance=distance)


def test_a_place_is_made_of_numbers() -> None:
    with pytest.raises(ValidationError):
        PoseReading(stamp=NOW, sensor="markers", base_in_map=FloorPose(x=math.nan, y=0.0, yaw=0.0))
