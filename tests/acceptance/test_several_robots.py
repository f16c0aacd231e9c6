"""Two robots with an executive each, and a third that a script drives, as processes behind one router.

With keys: each robot's processes show its own, and whoever asks shows an operator's.
"""

from __future__ import annotations

import datetime as dt
import math
from dataclasses import replace
from functools import partial
from pathlib import Path
from urllib.request import urlopen

import pytest

from tandem.executive.config.run_options import RunOptions
from tandem.executive.security.authority import Wanted, begin, issue
from tandem.executive.security.identity import Identity
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.processes import RESTARTS
from tandem.executive.system.systems import RobotSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import Scenario
from tandem.sim.starts import RobotStart
from tandem.skills.ports.hardware import Stop, StopState
from tandem.skills.ports.keys import STOP, STOP_STATE, Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Neighbours
from tandem.skills.wire.zenoh_bus import ZenohBus
from tests.acceptance.live import go_on, kill, own_bus, written
from tests.fakes.ports import free_pair

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]

TRIO = Scenario(
    name="trio",
    robots=(
        RobotStart(name="r2", robot="tiago_base", start=FloorPose(x=-0.8, y=1.2, yaw=1.57)),
        RobotStart(name="r1", robot="tiago_base", start=FloorPose(x=-1.3, y=-1.2, yaw=2.0), drives="wander"),
        RobotStart(name="r3", robot="tiago_base", start=FloorPose(x=2.2, y=-1.5, yaw=1.57)),
    ),
)


def has_moved(caller: Caller, robot: str, start: FloorPose) -> bool:
    x, y, _ = caller.truth().robot(robot).base_in_map.position
    return math.dist((x, y), (start.x, start.y)) > 0.05


def stopped(state: Latest[StopState]) -> bool:
    told = state.refresh()
    return told is not None and told.stopped


def replaced(system: ProcessSystem, name: str, dead: int) -> bool:
    return system.pids().get(name) not in (None, dead)


def keys_in(folder: Path) -> Path:
    now = dt.datetime.now(dt.UTC)
    begin(folder, now)
    for wanted in (Wanted("robot", "r2"), Wanted("robot", "r3"), Wanted("operator", "kim")):
        issue(folder, wanted, now)
    return folder


def as_kim(system: ProcessSystem, options: RunOptions, robot: str) -> RobotSystem:
    """The same system, as an operator has it."""
    bus = options.bus
    assert bus.keys is not None
    shown = Identity(bus.keys, "kim").client()
    own = ZenohBus(bus.endpoint, f"{bus.site}/{robot}", waker=system.bus.waker, credentials=shown)
    return RobotSystem(system, own, system.of(robot).clocks)


def knows_of(neighbours: Neighbours, name: str) -> bool:
    neighbours.refresh()
    return neighbours.of(name) is not None


def test_each_robot_has_processes_of_its_own_and_outlives_the_other(tmp_path: Path) -> None:
    said: list[str] = []
    port = free_pair()
    bus = own_bus()
    options = RunOptions(
        bus=replace(bus, endpoint=bus.endpoint.replace("tcp/", "tls/"), keys=keys_in(tmp_path / "keys")),
        scenario=written(TRIO, tmp_path),
        data=tmp_path / "data",
        metrics=f"127.0.0.1:{port}",
    )
    with ProcessSystem(options, say=said.append) as system:
        each = {"executive", "base", "perception", "keeper", "observer"}
        expected = {"router", "hardware"} | {f"{robot}/{role}" for robot in ("r2", "r3") for role in each}
        assert set(system.pids()) == expected
        for each_port in (port, port + 1):
            with urlopen(f"http://127.0.0.1:{each_port}/metrics") as page:
                assert b"tandem_queue_length" in page.read()
        r2, r3 = (as_kim(system, options, name) for name in ("r2", "r3"))
        stops = {name: Latest(end.bus, STOP_STATE) for name, end in (("r2", r2), ("r3", r3))}
        caller = Caller(r3, lambda _: None)
        assert isinstance(r2.bus, ZenohBus)
        neighbours = Neighbours(r2.bus.commons(), r2.clocks, "r2")
        go_on(system, partial(knows_of, neighbours, "r3"), within=20.0)

        # The stop of r2, and the death of its executive, are r2's alone.
        STOP.query(r2.bus, Stop(by="test", reason="r2 alone"))
        go_on(system, partial(stopped, stops["r2"]), within=10.0)
        dead = system.pids()["r2/executive"]
        kill(dead)
        go_on(system, partial(replaced, system, "r2/executive", dead), within=20.0)
        assert said[-1].startswith("the r2/executive process ended (signal 9)")

        assert caller.request({"task": "inspect"}).accepted
        start = TRIO.placed[2].start
        go_on(system, partial(has_moved, caller, "r3", start), within=60.0)
        assert not stopped(stops["r3"])
        assert has_moved(caller, "r1", TRIO.placed[1].start)
        assert not has_moved(caller, "r2", TRIO.placed[0].start)


def test_robots_go_on_without_a_page_whose_process_dies_too_often(tmp_path: Path) -> None:
    said, page = list[str](), "r2/web"
    web = f"127.0.0.1:{free_pair()}"
    options = RunOptions(bus=own_bus(), scenario=written(TRIO, tmp_path), data=tmp_path / "data", web=web)
    with ProcessSystem(options, say=said.append) as system:
        others = {name: process for name, process in system.pids().items() if name != page}
        for _ in range(RESTARTS):
            dead = system.pids()[page]
            kill(dead)
            go_on(system, partial(replaced, system, page, dead), within=20.0)
        kill(system.pids()[page])
        go_on(system, lambda: page not in system.pids(), within=20.0)
        assert said[-1] == "the r2/web process ended (signal 9) too often; there is no page from now on"
        assert system.pids() == others
