"""Two robots with an executive each and a third that a script drives, in one lockstep."""

from __future__ import annotations

import math

import pytest

from tandem.executive.system.lockstep import Lockstep
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.starts import RobotStart
from tandem.sim.truth import Truth
from tandem.skills.ports.hardware import Stop
from tandem.skills.ports.keys import STOP, STOP_STATE, Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Neighbours
from tandem.skills.wire.memory import MemoryBus

TRIO = Scenario(
    name="trio",
    robots=(
        RobotStart(name="r1", robot="tiago_base", start=FloorPose(x=-1.3, y=-1.2, yaw=2.0), drives="wander"),
        RobotStart(name="r2", robot="tiago_base", start=FloorPose(x=-0.8, y=1.2, yaw=1.57)),
        RobotStart(name="r3", robot="tiago_base", start=FloorPose(x=2.2, y=-1.5, yaw=1.57)),
    ),
)
QUIET = 0.01
"""Metres that a robot stirs by itself."""


def moved(before: Truth, after: Truth) -> set[str]:
    """Return the robots that truly moved."""
    return {
        each.name
        for each in after.robots
        if math.dist(each.base_in_map.position, before.robot(each.name).base_in_map.position) > QUIET
    }


def run_for(system: LockstepSystem, seconds: float) -> None:
    system.lockstep.run_until(lambda: False, within=seconds)


def test_each_robot_does_what_its_own_executive_is_asked() -> None:
    system = LockstepSystem(TRIO, 1)
    try:
        start = system.lockstep.station.truth()
        assert Caller(system.of("r3"), lambda _: None).request({"task": "inspect"}).accepted
        run_for(system, 8.0)
        middle = system.lockstep.station.truth()
        assert moved(start, middle) == {"r1", "r3"}
        assert Caller(system.of("r2"), lambda _: None).request({"task": "inspect"}).accepted
        run_for(system, 8.0)
        assert moved(middle, system.lockstep.station.truth()) >= {"r1", "r2"}
    finally:
        system.close()


def test_a_stop_of_one_robot_leaves_the_others_at_work() -> None:
    system = LockstepSystem(TRIO, 1)
    try:
        stops = {name: Latest(each.bus, STOP_STATE) for name, each in system.lockstep.robots.items()}
        for name in ("r2", "r3"):
            assert Caller(system.of(name), lambda _: None).request({"task": "inspect"}).accepted
        STOP.query(system.of("r2").bus, Stop(by="test", reason="r2 alone"))
        run_for(system, 1.0)
        before = system.lockstep.station.truth()
        run_for(system, 8.0)
        assert moved(before, system.lockstep.station.truth()) == {"r1", "r3"}
        told = {name: each.refresh() for name, each in stops.items()}
        assert [name for name, state in told.items() if state is not None and state.stopped] == ["r2"]
    finally:
        system.close()


def test_the_same_seed_gives_the_same_run() -> None:
    digests = set()
    for _ in range(2):
        system = LockstepSystem(TRIO, 5, digest=True)
        try:
            Caller(system.of("r2"), lambda _: None).request({"task": "inspect"})
            run_for(system, 3.0)
            digests.add(system.digest())
        finally:
            system.close()
    assert len(digests) == 1


def test_robots_are_asked_for_by_name() -> None:
    system = LockstepSystem(TRIO, 1)
    try:
        with pytest.raises(KeyError, match="there are r2, r3"):
            system.of("r1")
    finally:
        system.close()


def test_somebody_must_have_an_executive() -> None:
    wanderers = tuple(each.model_copy(update={"drives": "wander"}) for each in TRIO.robots)
    with pytest.raises(ScenarioError, match="robots: expected one with drives: executive"):
        Lockstep(TRIO.model_copy(update={"robots": wanderers}), 1)


def test_robots_know_of_each_other_where_they_are_and_what_they_do() -> None:
    system = LockstepSystem(TRIO, 1)
    try:
        heard = Neighbours(MemoryBus(system.lockstep.commons), system.lockstep.clocks, "r2")
        assert Caller(system.of("r3"), lambda _: None).request({"task": "inspect"}).accepted
        for _ in range(300):
            system.advance()
            heard.refresh()
        told = heard.of("r3")
        assert told is not None
        assert set(heard.all()) == {"r3"}  # a robot that a script drives tells nothing
        assert (told.told.task, told.told.kind) == ("inspect-0001", "inspect")
        assert told.told.phase
        assert told.age <= 0.11
        assert told.told.base_in_map is not None
        truth = system.lockstep.station.truth().robot("r3").base_in_map
        where = (told.told.base_in_map.x, told.told.base_in_map.y)
        # 0.3 m/s at the most by now, 0.1 s old, and 3 cm for localisation.
        assert math.dist(where, truth.position[:2]) < 0.1
    finally:
        system.close()
