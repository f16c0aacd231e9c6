"""RoCS, experiment 1, as processes: the one that holds the reflexes is killed on the way."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path

import pytest

from tandem.executive.config.run_options import RunOptions
from tandem.executive.system import processes
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, ODOMETRY, Latest
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.live import alive, go_on, kill, own_bus, written

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


def speed(odometry: Latest[Odometry]) -> float:
    told = odometry.refresh()
    return 0.0 if told is None else abs(told.linear)


def test_the_robot_stops_by_itself_and_gets_there_when_the_base_is_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A base that is born by a fork is back before the robot stands.
    monkeypatch.setattr(processes, "possible", lambda: False)
    scenario = written(load_scenario("RocsP3dx"), tmp_path)
    options = RunOptions(bus=own_bus(), scenario=scenario, data=tmp_path / "data")
    with ProcessSystem(options) as system:
        odometry, commands = Latest(system.bus, ODOMETRY), Latest(system.bus, BASE_VELOCITY, depth=4096)
        caller = Caller(system, lambda _: None)
        asked = caller.request({"task": "go_to", "x": 0.0, "y": 0.0, "tolerance": 0.12})
        assert asked.accepted
        go_on(system, lambda: speed(odometry) > 0.15, within=30.0)
        dead = system.pids()["base"]
        kill(dead)
        go_on(system, lambda: not alive(dead), within=10.0)
        system.advance()
        commands.take()  # what it had sent before
        go_on(system, lambda: speed(odometry) < 0.005, within=10.0)
        assert not commands.take(), "nobody told it to stop"
        go_on(system, partial(_replaced, system, dead), within=30.0)
        ended = caller.follow(asked.task, within=120.0)
        assert ended.state is TaskState.SUCCEEDED
        x, y, _ = caller.truth().base_in_map.position
        assert math.hypot(x, y) < 0.15


def _replaced(system: ProcessSystem, dead: int) -> bool:
    return system.pids().get("base") not in (None, dead)
