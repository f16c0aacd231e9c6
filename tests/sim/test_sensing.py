"""The sensors of a robot without laser and camera, in the whole stand-in."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from tandem.sim.faults import Fault, RangeSilent, RangeStuck
from tandem.sim.scenario import Noise, ScenarioError, load_scenario
from tandem.sim.station import Station, StationSettings
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import Ranges
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus


class Stage:
    """Stations that end with the test."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        self.stations: list[Station] = []
        self.ranges, self.poses, self.robots = (
            keys.Latest(self.bus, keys.RANGES),
            keys.Latest(self.bus, keys.POSE_READING),
            keys.Latest(self.bus, keys.ROBOTS_SEEN),
        )

    def __call__(self, name: str, *faults: Fault, noise: Noise | None = None, seed: int = 1) -> Station:
        scenario = load_scenario(name).with_faults(faults)
        scenario = scenario if noise is None else scenario.model_copy(update={"noise": noise})
        how = StationSettings(boot=f"b{len(self.stations)}", seed=seed)
        self.stations.append(Station(self.bus, load("rocs"), scenario, how))
        self.bus.ear.know(self.stations[-1].hardware.description)
        return self.stations[-1]

    def run(self, seconds: float) -> None:
        """Let robot seconds pass."""
        for _ in range(round(seconds * 100)):
            self.stations[-1].step()

    def told(self, seconds: float) -> list[Ranges]:
        """Return the readings of the next seconds."""
        self.ranges.take()
        self.run(seconds)
        return self.ranges.take()


@pytest.fixture
def stage() -> Iterator[Stage]:
    made = Stage()
    yield made
    for station in made.stations:
        station.close()


@pytest.mark.parametrize(("scenario", "sensors"), [("RocsP3dx", 16), ("RocsSummit", 3)])
def test_all_sensors_tell_in_their_periods_what_the_checks_let_in(
    stage: Stage, scenario: str, sensors: int
) -> None:
    stage(scenario)
    stage.run(1.0)
    ranges, poses = stage.ranges.take(), stage.poses.take()
    assert (len(ranges), len(poses)) == (10, 20)
    assert {len(each.readings) for each in ranges} == {sensors}
    assert stage.bus.ear.total == 0


def test_a_robot_sensor_tells_that_nobody_is_there(stage: Stage) -> None:
    stage("RocsSummit")
    stage.run(0.3)
    told = stage.robots.take()
    assert [each.robots for each in told] == [()] * 3


def test_the_pioneers_sonars_see_the_corner_that_it_looks_into(stage: Stage) -> None:
    """At (-2, -1.9), heading south-west: the walls are 0.5 m to the west and 0.6 m to the south."""
    stage("RocsP3dx", noise=Noise())
    told = stage.told(0.3)[-1]
    ahead = min(told.of("sonar_1") or 9.0, told.of("sonar_2") or 9.0)
    assert 0.25 < ahead < 0.6
    assert min(each.distance for each in told.readings) >= 0.15


def test_the_same_seed_tells_the_same(stage: Stage) -> None:
    told = []
    for seed in (1, 1, 2):
        station = stage("RocsP3dx", seed=seed)
        told.append([each.readings for each in stage.told(0.5)])
        station.close()
    assert told[0] == told[1] != told[2]


def test_a_silent_sonar_is_missing_and_comes_back(stage: Stage) -> None:
    stage("RocsP3dx", RangeSilent(sensor="sonar_3", at=0.3, lasts=0.5))
    told = stage.told(1.2)
    missing = [each.stamp.seconds for each in told if each.of("sonar_3") is None]
    assert missing
    assert min(missing) > 0.3
    assert max(missing) <= 0.81
    assert {len(each.readings) for each in told} == {15, 16}


def test_all_may_be_silent(stage: Stage) -> None:
    stage("RocsSummit", RangeSilent(at=0.0))
    assert {each.readings for each in stage.told(0.5)} == {()}


def test_a_stuck_sonar_repeats_itself_while_the_others_go_on(stage: Stage) -> None:
    stage("RocsSummit", RangeStuck(sensor="range_middle", at=0.3))
    told = stage.told(1.0)
    after = [each for each in told if each.stamp.seconds > 0.5]
    assert len({each.of("range_middle") for each in after}) == 1
    assert len({each.of("range_left") for each in after}) > 1


def test_a_fault_of_a_sensor_that_the_robot_lacks_is_refused_with_those_it_has(stage: Stage) -> None:
    with pytest.raises(ScenarioError, match="one of range_left, range_middle, range_right, found tail"):
        stage("RocsSummit", RangeStuck(sensor="tail"))


@pytest.mark.parametrize("scenario", ["RocsP3dx", "RocsSummit"])
def test_it_drives_by_velocity_commands_and_its_pose_sensor_tells_where(stage: Stage, scenario: str) -> None:
    """Backwards out of the corner, at 0.2 m/s for 1 s, and 0.04 m or less to stop."""
    station = stage(scenario)
    stage.run(0.2)
    begun = station.truth().base_in_map.position
    for _ in range(100):
        keys.BASE_VELOCITY.publish(stage.bus, BaseVelocity(linear=-0.2, angular=0.0))
        station.step()
    stage.run(1.0)
    ended, reading = station.truth().base_in_map.position, stage.poses.refresh()
    way = math.dist(begun, ended)
    assert 0.15 < way < 0.30
    assert reading is not None
    assert (reading.base_in_map.x, reading.base_in_map.y) == pytest.approx(ended[:2], abs=0.05)


@pytest.mark.parametrize(
    ("scenario", "linear", "bumper"),
    [
        ("RocsP3dx", 0.2, "front"),
        ("RocsSummit", 0.2, "front"),
        ("RocsSummit", -0.2, "back"),
    ],
)
def test_its_bumpers_tell_what_it_runs_into_and_not_the_floor(
    stage: Stage, scenario: str, linear: float, bumper: str
) -> None:
    """From the room's middle, heading west; an immovable wall stands 0.3 m beyond the robot, either way."""
    station = stage(scenario)
    station.reset(1, station.scenario.model_copy(update={"start": FloorPose(x=0.0, y=0.0, yaw=math.pi)}))
    told = keys.Latest(stage.bus, keys.BUMPERS)
    stage.run(0.5)
    assert {each.pressed for each in told.take()} == {()}
    robot = station.hardware.description.footprint_radius
    for side in (-1.0, 1.0):
        station.physics.add_box((0.1, 2.0, 0.6), 0.0, (side * (robot + 0.35), 0.0, 0.3))
    for _ in range(400):
        keys.BASE_VELOCITY.publish(stage.bus, BaseVelocity(linear=linear, angular=0.0))
        station.step()
    assert {name for each in told.take() for name in each.pressed} == {bumper}
