"""Several robots in one world: the scenario's form, what they see and touch of each other, who is whose."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TypeVar

import cv2
import numpy as np
import pytest
import yaml
from numpy.typing import NDArray
from pydantic import JsonValue

from tandem.executive.cli.commands.scenario_commands import checked
from tandem.sim.controls import FAULT, FAULTS, RESET, ResetRequest
from tandem.sim.faults import BumperPressed, FaultRequest
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.starts import RobotStart
from tandem.sim.station import Station, StationSettings
from tandem.sim.truth import TRUTH
from tandem.skills.ports.hardware import BaseVelocity, Stop
from tandem.skills.ports.keys import (
    BASE_VELOCITY,
    CLOCK,
    STOP,
    STOP_STATE,
    Latest,
    Nothing,
    Service,
    laser,
)
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sources import DocumentError
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus

Asked = TypeVar("Asked", bound=Message)
Answered = TypeVar("Answered", bound=Message)

FREE = (-1.5, -1.2)
"""A place in the lab with nothing within 1 m (x, y in m)."""


def robot(name: str, x: float, y: float, yaw: float = 0.0, **more: str) -> dict[str, JsonValue]:
    return {"name": name, "robot": "tiago_base", "start": {"x": x, "y": y, "yaw": yaw}, **more}


def scenario(*robots: dict[str, JsonValue]) -> Scenario:
    return Scenario(name="several", robots=tuple(RobotStart.model_validate(each) for each in robots))


class Stage:
    """A station with a bus for each robot."""

    def __init__(self, made: Scenario, seed: int = 1) -> None:
        self.buses = {each.name: MemoryBus() for each in made.placed}
        self.station = Station(self.buses, load("lab"), made, StationSettings(boot="b", seed=seed))

    def ask(self, robot: str, service: Service[Asked, Answered], message: Asked) -> Answered:
        pending = service.query(self.buses[robot], message)
        self.station.step()
        answer = pending.poll()
        assert answer is not None
        return service.decode_answer(answer)

    def at(self, robot: str) -> tuple[float, float]:
        x, y, _ = self.station.truth().robot(robot).base_in_map.position
        return x, y

    def drive(self, seconds: float, commands: Mapping[str, float]) -> None:
        for _ in range(round(seconds / 0.01)):
            for name, linear in commands.items():
                BASE_VELOCITY.publish(self.buses[name], BaseVelocity(linear=linear, angular=0.0))
            self.station.step()


@pytest.fixture
def pair() -> Iterator[Stage]:
    x, y = FREE
    stage = Stage(scenario(robot("r1", x, y), robot("r2", x, y - 1.0)))
    yield stage
    stage.station.close()


def test_each_robot_obeys_its_own_commands_only(pair: Stage) -> None:
    before = {name: pair.at(name) for name in ("r1", "r2")}
    pair.drive(2.0, {"r1": 0.3})
    # At 0.5 m/s2 it has 0.3 m/s after 0.6 s: 2.0 * 0.3 - 0.3 * 0.6 / 2 = 0.51 m.
    assert math.dist(pair.at("r1"), before["r1"]) == pytest.approx(0.51, abs=0.02)
    assert math.dist(pair.at("r2"), before["r2"]) < 0.005


def test_each_tells_the_same_tick_on_its_own_keys(pair: Stage) -> None:
    clocks = {name: Latest(bus, CLOCK) for name, bus in pair.buses.items()}
    pair.drive(0.05, {})
    told = [clock.refresh() for clock in clocks.values()]
    assert [each.tick for each in told if each is not None] == [5, 5]
    assert told[0] == told[1]


def test_a_stop_of_one_leaves_the_other_free(pair: Stage) -> None:
    states = {name: Latest(bus, STOP_STATE) for name, bus in pair.buses.items()}
    before = {name: pair.at(name) for name in ("r1", "r2")}
    assert pair.ask("r1", STOP, Stop(by="test", reason="r1 alone")).stopped
    pair.drive(2.0, {"r1": 0.3, "r2": 0.3})
    told = {name: state.refresh() for name, state in states.items()}
    assert [name for name, state in told.items() if state is not None and state.stopped] == ["r1"]
    assert math.dist(pair.at("r1"), before["r1"]) < 0.005
    assert math.dist(pair.at("r2"), before["r2"]) == pytest.approx(0.51, abs=0.02)


def test_a_laser_sees_the_other_robot_and_not_its_own() -> None:
    x, y = FREE
    stage = Stage(scenario(robot("r1", x, y), robot("r2", x, y - 1.2, math.pi / 2)))
    scans = Latest(stage.buses["r2"], laser("base"))
    try:
        stage.drive(0.3, {})
        scan = scans.refresh()
        assert scan is not None
        # From 0.202 m before r2's centre to the rim of r1, a disc of 0.27 m.
        assert scan.ranges[len(scan.ranges) // 2] == pytest.approx(1.2 - 0.202 - 0.27, abs=0.03)
        assert min(scan.ranges) > 0.5
    finally:
        stage.station.close()


def test_who_is_driven_into_another_touches_it_by_name() -> None:
    x, y = FREE
    stage = Stage(scenario(robot("r1", x, y), robot("r2", x + 0.7, y)))
    try:
        stage.drive(2.0, {"r1": 0.3})
        pairs = [(one.first, one.second) for one in stage.station.truth().contacts]
        assert any(one.startswith("r1/") and other.startswith("r2/") for one, other in pairs)
    finally:
        stage.station.close()


def test_who_drives_into_a_robot_that_a_script_drives_touches_it_as_one_touches_a_person() -> None:
    x, y = FREE
    stage = Stage(scenario(robot("r1", x, y), robot("r2", x + 0.65, y, math.pi, drives="wander")))
    try:
        stage.drive(3.0, {"r1": 0.4})
        touches = stage.station.truth().touches
    finally:
        stage.station.close()
    assert {(each.person, each.robot) for each in touches} == {("r2", "r1")}
    assert touches[0].stood < 0.1


def test_the_keys_of_each_tell_the_truth_from_its_side(pair: Stage) -> None:
    for name in ("r1", "r2"):
        truth = pair.ask(name, TRUTH, Nothing())
        assert truth.base_in_map == truth.robot(name).base_in_map
        assert [each.name for each in truth.robots] == ["r1", "r2"]


@pytest.mark.parametrize(
    ("asked", "meant", "hit"),
    [("r1", None, "r1"), ("r2", None, "r2"), ("r1", "r2", "r2"), ("r2", "r1", "r1")],
)
def test_a_fault_hits_the_robot_that_it_names(pair: Stage, asked: str, meant: str | None, hit: str) -> None:
    told = {name: Latest(bus, FAULTS) for name, bus in pair.buses.items()}
    fault = BumperPressed(bumper="front", robot=meant)
    assert pair.ask(asked, FAULT, FaultRequest(fault=fault)).accepted
    pair.station.step()
    assert [name for name, each in told.items() if each.refresh() is not None] == [hit]


def test_a_fault_of_a_robot_that_is_not_there_is_refused(pair: Stage) -> None:
    answer = pair.ask("r1", FAULT, FaultRequest(fault=BumperPressed(bumper="front", robot="r9")))
    assert (answer.accepted, answer.reason) == (False, "robot: expected one of r1, r2, found r9")


def test_a_reset_asked_of_one_begins_anew_for_all(pair: Stage) -> None:
    pair.drive(1.0, {"r1": 0.3})
    assert pair.ask("r2", RESET, ResetRequest(seed=2)).accepted
    assert {each.hardware.now.boot for each in pair.station.robots.values()} == {"b.1"}
    assert pair.at("r1") == pytest.approx(FREE, abs=0.01)


def test_a_reset_with_other_robots_is_refused(pair: Stage) -> None:
    alone = Scenario(name="alone", robot="tiago_base", start=FloorPose(x=FREE[0], y=FREE[1], yaw=0.0))
    with pytest.raises(ScenarioError, match=r"robot: expected r1 \(tiago_base, executive\)"):
        pair.station.reset(1, alone)


R1, R2 = robot("r1", *FREE), robot("r2", FREE[0], FREE[1] - 1.0)


@pytest.mark.parametrize(
    ("fields", "path", "said"),
    [
        ({}, "start", "a value, or robots"),
        ({"robots": []}, "start", "a value, or robots"),
        ({"robots": [R1], "start": R1["start"]}, "start", "beside"),
        ({"robots": [R1], "robot": "tiago"}, "robot", "beside"),
        ({"robots": [R1, {**R2, "name": "r1"}]}, "", "expected each robot once; several times there: r1"),
        ({"robots": [R1, {**R2, "name": "world"}]}, "robots.1.name", "another name than world"),
        ({"robots": [R1, {**R2, "name": "R 2"}]}, "robots.1.name", "R 2"),
        ({"robots": [R1, {**R2, "drives": "nobody"}]}, "robots.1.drives", "wander"),
        ({"robots": [R1, {**R2, "robot": "robbie"}]}, "robots.1.robot", "found robbie"),
        ({"robots": [R1, robot("r2", 9.0, 0.0)]}, "robots.1.start", "a place in the room"),
        ({"robots": [R1, robot("r2", FREE[0] + 0.5, FREE[1])]}, "robots.1.start", "is inside r1"),
        ({"robots": [R1, robot("r2", 1.0, 0.5)]}, "robots.1.start", "is inside table"),
        (
            {"robots": [R1, R2], "faults": [{"kind": "laser_silent", "robot": "r9"}]},
            "faults.0.robot",
            "expected one of r1, r2, found r9",
        ),
    ],
)
def test_a_mistake_is_told_with_file_path_and_line(
    tmp_path: Path, fields: dict[str, JsonValue], path: str, said: str
) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text(yaml.safe_dump({"name": "mine", **fields}))
    with pytest.raises(DocumentError) as caught:
        checked(str(file))
    line = next(each for each in str(caught.value).splitlines() if said in each)
    assert line.startswith(f"{file}: {path}" if path else str(file))


def test_the_single_form_is_one_robot() -> None:
    start = FloorPose(x=0.0, y=-1.0, yaw=0.5)
    alone = Scenario(name="alone", robot="tiago_base", start=start)
    assert alone.placed == (RobotStart(name="robot", robot="tiago_base", start=start),)
    assert alone.starting_at(FloorPose(x=1.0, y=0.0, yaw=0.0)).first.start.x == 1.0
    assert Scenario.model_validate_json(alone.model_dump_json()) == alone


def test_several_survive_a_file_and_the_first_can_be_moved() -> None:
    made = scenario(R1, R2)
    assert Scenario.model_validate_json(made.model_dump_json()) == made
    moved = made.starting_at(FloorPose(x=1.0, y=-1.0, yaw=0.0))
    assert [each.start.x for each in moved.placed] == [1.0, FREE[0]]


def test_a_photograph_shows_robots_of_different_kinds() -> None:
    x, y = FREE
    small = {"name": "r2", "robot": "p3dx", "start": {"x": x, "y": y - 1.0, "yaw": 0.0}}
    stage = Stage(scenario(robot("r1", x, y), small))
    empty = Stage(scenario(robot("r1", x, y), {**small, "start": {"x": 2.4, "y": -2.4, "yaw": 0.0}}))
    try:
        pictures = [photograph(each) for each in (stage, empty)]
        shown = np.abs(pictures[0].astype(int) - pictures[1].astype(int)).max(axis=2) > 30
        # The middle of the picture is r2, 0.5 m wide at 1.5 m: about a third of 60 degrees.
        assert shown[90:110, 90:110].mean() > 0.8
    finally:
        stage.station.close()
        empty.station.close()


def photograph(stage: Stage) -> NDArray[np.uint8]:
    x, y = FREE
    studio = stage.station.studio
    number = studio.order_photograph((x + 1.2, y - 1.0, 1.0), (x, y - 1.0, 0.12), 200, 200)
    png = studio.fetch(number)
    assert png is not None
    picture = cv2.imdecode(np.frombuffer(png, dtype=np.uint8), cv2.IMREAD_COLOR)
    return np.asarray(picture, dtype=np.uint8)
