"""Faults of sensors and of the room, in the whole stand-in."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from tandem.sim.controls import FAULT, FAULTS
from tandem.sim.faults import (
    CameraDark,
    CameraFrozen,
    CameraSilent,
    CameraUsed,
    DepotTaken,
    Fault,
    FaultRequest,
    HardwareSilent,
    JointStall,
    LaserSilent,
    ObstacleAppears,
)
from tandem.sim.scenario import ScenarioError, load_scenario
from tandem.sim.station import Station, StationSettings
from tandem.sim.truth import lies_on
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer
from tandem.skills.ports.image import RgbdImage, decode
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus


class Stage:
    """Stations that end with the test; each has the Defaults' room with these faults."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        self.stations: list[Station] = []

    def __call__(self, *faults: Fault) -> Station:
        scenario = load_scenario("Defaults").model_copy(update={"faults": faults})
        how = StationSettings(boot="b", seed=1)
        self.stations.append(Station(self.bus, load("lab"), scenario, how))
        return self.stations[-1]

    def run(self, seconds: float) -> None:
        """Let robot seconds pass."""
        for _ in range(round(seconds * 100)):
            self.stations[-1].step()


@pytest.fixture
def stage() -> Iterator[Stage]:
    made = Stage()
    yield made
    for station in made.stations:
        station.close()


def pictures(stage: Stage, seconds: float) -> list[RgbdImage]:
    inbox = stage.bus.subscribe(keys.rgbd("head"))
    stage.run(seconds)
    inbox.close()
    return [decode(sample.payload) for sample in inbox.drain()]


def test_a_dark_camera_sends_black_pictures_without_depth(stage: Stage) -> None:
    stage(CameraDark(at=0.3))
    before, _, after = pictures(stage, 0.5)
    assert before.colour.any()
    assert before.depth.any()
    assert not after.colour.any()
    assert not after.depth.any()


def test_a_frozen_camera_sends_one_picture_with_new_stamps(stage: Stage) -> None:
    station = stage(CameraFrozen(at=0.0))
    inbox = stage.bus.subscribe(keys.rgbd("head"))
    stage.run(0.1)
    station.world.remove("item_29")
    station.world.remove("table.0")
    stage.run(0.2)
    first, second = (decode(sample.payload) for sample in inbox.drain())
    assert np.array_equal(first.colour, second.colour)
    assert np.array_equal(first.depth, second.depth)
    assert second.header.stamp.seconds > first.header.stamp.seconds


def test_a_silent_camera_sends_nothing_and_then_again(stage: Stage) -> None:
    stage(CameraSilent(at=0.0, lasts=0.5))
    assert pictures(stage, 0.5) == []
    assert len(pictures(stage, 0.2)) == 1


def test_a_camera_goes_silent_when_it_is_used(stage: Stage) -> None:
    stage(CameraSilent(when=CameraUsed()))
    told = keys.Latest(stage.bus, FAULTS)
    stage.run(0.2)
    assert told.take() == []
    assert pictures(stage, 0.5) == []
    assert [event.phase for event in told.take()] == ["began"]


def test_a_silent_laser_sends_nothing_while_the_rest_goes_on(stage: Stage) -> None:
    stage(LaserSilent(at=0.3, lasts=0.5))
    scans, odometry = stage.bus.subscribe(keys.laser("base").key), stage.bus.subscribe(keys.ODOMETRY.key)
    stage.run(1.0)
    stamps = [keys.laser("base").decode(sample.payload).stamp.seconds for sample in scans.drain()]
    assert [stamp for stamp in stamps if 0.31 <= stamp <= 0.8] == []
    assert stamps[-1] > 0.85
    assert len(odometry.drain()) == 50


def test_an_obstacle_ahead_is_seen_by_the_laser_and_leaves(stage: Stage) -> None:
    stage(ObstacleAppears(ahead=1.0, at=0.4, lasts=0.5))
    laser = keys.Latest(stage.bus, keys.laser("base"))
    ahead = []
    for _ in range(3):
        stage.run(0.35)
        told = laser.refresh()
        assert told is not None
        ahead.append(told.ranges[len(told.ranges) // 2])
    assert ahead[1] < ahead[0] - 0.3
    assert ahead[2] == pytest.approx(ahead[0], abs=0.02)


def test_an_obstacle_that_waits_appears_as_soon_as_there_is_room(stage: Stage) -> None:
    """A parcel stands where it is to appear, until 0.5 s; without waiting it is refused."""
    parcel = ObstacleAppears(name="parcel", ahead=1.0, at=0.0, lasts=0.5)
    stage(
        parcel,
        ObstacleAppears(ahead=1.0, at=0.1),
        ObstacleAppears(name="late", ahead=1.0, at=0.1, waits=True),
    )
    told = keys.Latest(stage.bus, FAULTS)
    stage.run(1.0)
    events = [(event.number, event.phase) for event in told.take()]
    assert events == [(0, "began"), (1, "refused"), (0, "ended"), (2, "began")]


def test_a_slot_of_the_depot_is_taken_by_a_parcel_or_an_item(stage: Stage) -> None:
    station = stage(DepotTaken(slot=0), DepotTaken(slot=1, item=29), DepotTaken(slot=0))
    told = keys.Latest(stage.bus, FAULTS)
    stage.run(0.5)
    assert [event.phase for event in told.take()] == ["began", "began", "refused"]
    assert lies_on(station.truth(), load("lab"), 29, "depot")
    assert station.world.pose("parcel_0").position[:2] == pytest.approx((-2.61, -1.10), abs=0.005)


def test_a_fault_can_be_asked_for_now(stage: Stage) -> None:
    station = stage()
    pending = FAULT.query(stage.bus, FaultRequest(fault=HardwareSilent(lasts=0.1)))
    stage.run(0.02)
    answer = pending.poll()
    assert answer is not None
    assert Answer.model_validate_json(answer).accepted
    assert station.silent
    stage.run(0.11)
    assert not station.silent


def test_a_fault_that_the_robot_has_no_place_for_is_refused(stage: Stage) -> None:
    stage()
    fault = JointStall(group="arm_left", joint=9)
    pending = FAULT.query(stage.bus, FaultRequest(fault=fault))
    stage.run(0.01)
    answer = pending.poll()
    assert answer is not None
    assert "0 to 6 or one of arm_left_1_joint" in Answer.model_validate_json(answer).reason


def test_a_reset_mends_everything_and_begins_the_faults_anew(stage: Stage) -> None:
    station = stage(HardwareSilent(at=0.1), ObstacleAppears(ahead=1.0, at=0.1))
    stage.run(0.2)
    assert station.silent
    station.reset(2)
    assert not station.silent
    assert "intruder" not in station.world.bodies
    stage.run(0.2)
    assert station.silent
    assert "intruder" in station.world.bodies


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        (JointStall(group="leg"), "faults.0.group: expected one of arm_left"),
        (DepotTaken(depot="attic"), "faults.0.depot: expected one of depot"),
        (DepotTaken(slot=9), "faults.0.slot: expected 0 to 6"),
        (DepotTaken(item=500), "faults.0.item: expected one of 3"),
        (ObstacleAppears(support="sofa", x=0.0, y=0.0), "faults.0.support: no furniture 'sofa'"),
    ],
)
def test_a_scenario_with_a_fault_that_fits_nothing_is_refused(fault: Fault, said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        Stage()(fault)
    assert said in str(caught.value)
