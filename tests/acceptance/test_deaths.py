"""Processes that die, are killed, can't start, or are ended with Ctrl-C."""

from __future__ import annotations

import signal
import subprocess
import time
from functools import partial
from pathlib import Path

import pytest

from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import Processes, RunOptions
from tandem.executive.ledger.sqlite import FILE, SqliteLedger
from tandem.executive.system.crews import roles_of
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.processes import RESTARTS
from tandem.executive.system.systems import LedgerFailure, RefusedError, SystemFailure, wait_for
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import load_scenario
from tandem.sim.truth import lies_on
from tandem.skills.ports.action import GoalState, status_topic
from tandem.skills.ports.actions.arm import move
from tandem.skills.ports.actions.base import DRIVE
from tandem.skills.ports.actions.perception import LOOK
from tandem.skills.ports.actions.world import EDIT
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState, TaskStatus, task_status
from tandem.skills.site import load
from tests.acceptance.live import (
    COMMAND,
    ENVIRONMENT,
    ROOT,
    children,
    go_on,
    kill,
    left_behind,
    own_bus,
    query,
    tasks,
    written,
)

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)


def test_a_process_that_nobody_can_do_without_is_named_and_the_rest_ends() -> None:
    role: str = "router"
    ends = {}

    def one_dies() -> None:
        with ProcessSystem(RunOptions(bus=own_bus(), scenario="Defaults")) as system:
            ends.update({child.role: child.process for child in system.supervisor.children})
            kill(ends[role].pid)
            go_on(system, lambda: False, within=10.0)

    with pytest.raises(SystemFailure) as caught:
        one_dies()
    assert str(caught.value).startswith(f"the {role} process ended (signal 9)")
    codes = {name: end.returncode for name, end in ends.items()}
    assert codes == {name: -9 if name == role else 0 for name in roles_of(load_scenario("Defaults"))}
    assert left_behind(end.pid for end in ends.values()) == ()


def replaced(system: ProcessSystem, dead: int) -> bool:
    return system.pids().get("base") not in (None, dead)


def test_a_skill_that_dies_is_started_again_until_it_dies_too_often() -> None:
    said: list[str] = []
    groups: list[int] = []

    def one_dies_often() -> None:
        with ProcessSystem(RunOptions(bus=own_bus(), scenario="Defaults"), say=said.append) as system:
            for _ in range(RESTARTS + 1):
                groups.extend(system.pids().values())
                dead = system.pids()["base"]
                kill(dead)
                go_on(system, partial(replaced, system, dead), within=10.0)

    with pytest.raises(SystemFailure) as caught:
        one_dies_often()
    assert said == ["the base process ended (signal 9); restarted"] * RESTARTS
    assert str(caught.value).startswith("the base process ended (signal 9)")
    assert left_behind(groups) == ()


def test_an_executive_that_dies_is_started_again_and_goes_on_with_its_task(tmp_path: Path) -> None:
    said: list[str] = []
    options = RunOptions(bus=own_bus(), scenario="Defaults", data=tmp_path)
    with ProcessSystem(options, say=said.append) as system:
        task = query(system, b'{"task": "fetch", "item": 29, "id": "mine"}').task
        running = partial(begun, system, task, 1)
        go_on(system, running, within=20.0)
        kill(system.pids()["executive"])
        go_on(system, partial(begun, system, task, 2), within=20.0)
        assert said == ["the executive process ended (signal 9); restarted"]
        assert query(system, b'{"task": "fetch", "item": 29, "id": "mine"}').task == task
        (status,) = tasks(system).tasks
        assert not status.state.terminal


def begun(system: ProcessSystem, task: str, times: int) -> bool:
    """Say whether a task's tree has begun so often; nobody may answer for a moment."""
    answer = wait_for(system, system.bus.query(task_status(task).key, b""), 1.0)
    return answer is not None and TaskStatus.model_validate_json(answer).begun >= times


def test_a_ledger_that_can_not_be_read_is_told_and_all_ends(tmp_path: Path) -> None:
    (tmp_path / FILE).write_bytes(b"no ledger" * 1000)
    system = ProcessSystem(RunOptions(bus=own_bus(), data=tmp_path), roles=("router", "executive"))
    with pytest.raises(LedgerFailure, match="not a ledger; the file was left as it is"):
        system.__enter__()


def test_a_ledger_has_one_owner(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    system = ProcessSystem(RunOptions(bus=own_bus(), data=tmp_path), roles=("router", "executive"))
    with pytest.raises(RefusedError, match=r"exit code 4.*\n?.*another executive has this ledger"):
        system.__enter__()
    ledger.close()


KILLS = (
    ("perception", LOOK.name, 2),
    ("base", DRIVE.name, 1),
    ("arm_left", move("arm_left").name, 2),
    ("keeper", EDIT.name, 1),
)
"""Which process is killed while it is at its goal of this number on that action."""


@pytest.mark.parametrize(
    ("processes", "kills"), [("many", KILLS), pytest.param("few", KILLS[1:], marks=pytest.mark.thorough)]
)
def test_skills_killed_at_work_are_started_again_and_the_item_gets_there(
    tmp_path: Path, processes: Processes, kills: tuple[tuple[str, str, int], ...]
) -> None:
    path = written(load_scenario("Demo").starting_at(BEFORE_THE_TABLE), tmp_path)
    said: list[str] = []
    options = RunOptions(bus=own_bus(), scenario=path, speed=None, processes=processes)
    called = {role: "skills" if processes == "few" else role for role, _, _ in kills}
    with ProcessSystem(options, say=said.append) as system:
        caller = Caller(system, lambda _: None)
        at_work = {role: _Goals(system, action, number) for role, action, number in kills}
        task = caller.request({"task": "fetch", "item": 29, "arm": "left"}).task

        def next_kill() -> bool:
            for role in [each for each, goals in at_work.items() if goals.reached()]:
                del at_work[role]
                kill(system.pids()[called[role]])
            return not at_work

        go_on(system, next_kill, within=600.0)
        status = caller.follow(task, within=900.0)
        assert sorted(said) == sorted(
            f"the {name} process ended (signal 9); restarted" for name in called.values()
        )
        assert status.state is TaskState.SUCCEEDED, status.model_dump_json(indent=1)
        assert lies_on(caller.truth(), load("lab"), 29, "depot")


class _Goals:
    """Says when a skill is at its n-th goal."""

    def __init__(self, system: ProcessSystem, action: str, number: int) -> None:
        self._statuses = Latest(system.bus, status_topic(action), depth=1024)
        self._number, self._seen = number, dict[str, None]()

    def reached(self) -> bool:
        running = (each.goal_id for each in self._statuses.take() if each.state is GoalState.RUNNING)
        self._seen.update(dict.fromkeys(running))
        return len(self._seen) >= self._number


def test_a_process_that_can_not_start_is_named_with_its_last_words(tmp_path: Path) -> None:
    scenario = tmp_path / "wrong.yaml"
    scenario.write_text("name: wrong\nstart: {x: 0.0, y: 0.0, yaw: 0.0}\n")
    system = ProcessSystem(RunOptions(bus=own_bus(), scenario=str(scenario)))
    scenario.write_text("name: wrong\nstart: nowhere\n")  # after it was checked: the hardware finds it so
    with pytest.raises(SystemFailure, match=r"the hardware process ended \(exit code 1\); last output"):
        system.__enter__()


@pytest.mark.parametrize("when", ["starting", "ready"])
def test_ctrl_c_ends_all(tmp_path: Path, when: str) -> None:
    said = tmp_path / "said.txt"
    bus = own_bus()
    argv = [*COMMAND, "up", "--connect", bus.endpoint, "--scenario", "Defaults", "--data", str(tmp_path)]
    with said.open("w") as stream:
        up = subprocess.Popen(
            argv, env=ENVIRONMENT, cwd=ROOT, stdout=stream, stderr=stream, start_new_session=True
        )
    try:
        deadline = time.monotonic() + 60.0
        started: dict[int, str] = {}
        while time.monotonic() < deadline and not (
            "ready" in said.read_text() if when == "ready" else len(started) >= 3
        ):
            started = children(up.pid)
            time.sleep(0.02)
        started = children(up.pid)
        least = len(roles_of(load_scenario("Defaults"))) if when == "ready" else 3
        assert len(started) >= least, said.read_text()
        up.send_signal(signal.SIGINT)
        assert up.wait(30.0) == ExitCode.INTERRUPTED, said.read_text()
        assert "stopped" in said.read_text()
        assert left_behind([up.pid, *started]) == ()
    finally:
        up.kill()
        up.wait()


def test_without_a_parent_all_processes_end(tmp_path: Path) -> None:
    """The command itself is killed: nobody is left to end what it started."""
    bus = own_bus()
    argv = [*COMMAND, "up", "--connect", bus.endpoint, "--scenario", "Defaults", "--data", str(tmp_path)]
    up = subprocess.Popen(argv, env=ENVIRONMENT, cwd=ROOT, stdout=subprocess.PIPE, start_new_session=True)
    assert up.stdout is not None
    assert b"ready" in up.stdout.readline()
    started = children(up.pid)
    kill(up.pid)
    up.wait()
    assert left_behind([up.pid, *started], within=10.0) == ()
