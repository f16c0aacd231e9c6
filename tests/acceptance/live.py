"""Real processes over zenoh: where they run, and what is left of them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import yaml

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.processes import Supervisor
from tandem.executive.system.systems import wait_for
from tandem.sim.scenario import Scenario
from tandem.skills.ports.tasks import REQUEST, TASK_LIST, AskTasks, TaskAnswer, TaskList
from tests.fakes.ports import free_endpoint

ROOT = Path(__file__).parents[2]
COMMAND = [sys.executable, "-c", "from tandem.executive.cli.main import run; run()"]
_STATE = tempfile.TemporaryDirectory(prefix="tandem-state-")
ENVIRONMENT = os.environ | {"PYTHONPATH": str(ROOT), "XDG_STATE_HOME": _STATE.name}
"""Of commands under test: what they keep goes with the tests."""


def own_bus() -> BusOptions:
    """Return an endpoint and keys that nobody else has."""
    return BusOptions(endpoint=free_endpoint(), site="test", robot="tiago")


def written(scenario: Scenario, folder: Path) -> str:
    """Write a scenario; return the file's path."""
    path = folder / f"{scenario.name}.yaml"
    path.write_text(yaml.safe_dump(scenario.model_dump(mode="json")), encoding="utf-8")
    return str(path)


@dataclass(frozen=True)
class Process:
    """What the kernel knows of a process."""

    number: int
    parent: int
    group: int
    state: str
    command: str


def processes() -> tuple[Process, ...]:
    """Return all processes of this machine."""
    found = []
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            name, _, rest = (entry / "stat").read_text().rpartition(") ")
            words = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode()[:200]
        except OSError:
            continue
        state, parent, group = rest.split()[:3]
        found.append(Process(int(entry.name), int(parent), int(group), state, words or name))
    return tuple(found)


def left_behind(groups: Iterable[int], *, within: float = 2.0) -> tuple[Process, ...]:
    """Return what still lives of these process groups after so many seconds at the most."""
    wanted, deadline = tuple(groups), time.monotonic() + within
    while True:
        left = tuple(each for each in processes() if each.group in wanted and each.state != "Z")
        if not left or time.monotonic() > deadline:
            return left
        time.sleep(0.05)


def children(parent: int) -> dict[int, str]:
    """Return the processes started by a process."""
    return {each.number: each.command for each in processes() if each.parent == parent}


def go_on(
    system: ProcessSystem, condition: Callable[[], bool], *, within: float, seen: Callable[[], object] = str
) -> None:
    """Let a system go on until the condition holds, at most so many host seconds; else say what was seen."""
    deadline = time.monotonic() + within
    while not condition():
        assert time.monotonic() < deadline, f"not so within {within} s: {seen()}"
        system.advance()


def alive(process: int) -> bool:
    """Say whether a process still runs."""
    return any(each.number == process and each.state != "Z" for each in processes())


def kill(process: int) -> None:
    """Kill a process as nobody can hear."""
    os.kill(process, signal.SIGKILL)


def play(role: str, options: RunOptions, folder: Path) -> tuple[int, str]:
    """Start one more process of a role; return its exit code and its last words."""
    settings = WorkerSettings(
        role=role,
        endpoint=options.bus.endpoint,
        prefix=options.bus.prefix,
        site="lab",
        scenario=options.scenario,
    )
    with Supervisor(folder) as supervisor:
        child = supervisor.start(settings)
        try:
            code = child.process.wait(20.0)
        except subprocess.TimeoutExpired:
            code = 0
        return code, child.last_words()


def query(system: ProcessSystem, payload: bytes) -> TaskAnswer:
    """Ask for a task; return the answer."""
    answer = wait_for(system, system.bus.query(REQUEST, payload, timeout=5.0), 5.0)
    assert answer is not None
    return TaskAnswer.model_validate_json(answer)


def tasks(system: ProcessSystem) -> TaskList:
    """Return all tasks that the executive remembers."""
    answer = wait_for(system, TASK_LIST.query(system.bus, AskTasks()), 5.0)
    assert answer is not None
    return TaskList.model_validate_json(answer)
