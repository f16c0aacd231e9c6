"""Weeks of uptime in an hour: many tasks one after the other, and what each process holds after them.

Router, executive and observer are the product's; the robot with its skills is the mock of ``crash_world``.
The supervisor is this process: it watches the others as ``tandem up`` does, and is measured like them.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from statistics import median
from typing import Final

from pydantic import JsonValue

from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.process_usage import usage
from tandem.executive.system.systems import SystemFailure, wait_for
from tandem.executive.trials.campaigns.crash_world import ITEM, RESET, AskReset
from tandem.executive.trials.campaigns.mock_roles import MOCKED
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TASK_STATUS, CancelTask, TaskAnswer

ROBOT: Final = "soak"
ROLES: Final[tuple[str, ...]] = ("router", "mock", "executive")
SUPERVISOR: Final = "supervisor"
OBSERVER: Final = "process/observer"
WARM_UP: Final = 200
"""Tasks after which memory is no longer expected to grow: caches, inboxes and arenas are full then."""
GROWTH_ALLOWED: Final = 2.0
"""Megabytes (10^6 bytes). Over 1,800 tasks that is 1.1 kB a task; a status that is kept for ever has 2 kB."""
SAMPLES: Final = 100
"""Samples over a whole run, or one a task if there are fewer tasks."""
WINDOW: Final = 5
"""Samples whose median counts: one alone may fall into a moment of garbage."""
TASK_WITHIN: Final = 60.0
"""Host seconds for a mocked task."""
CANCEL_EVERY: Final = 10
"""One task in ten is cancelled as it begins; one in ten asks for an item that is not there."""
LOGS_BOUND: Final = 10_000_000
"""Bytes of one process's log with the one before it (see ``executive.telemetry.log_files``), rounded up."""


class Sample(Message):
    """One process at one moment."""

    tasks: int
    """Tasks that had ended."""
    role: str
    memory: float
    """Its anonymous memory, in megabytes: what it took for itself, and not for a file that it reads.

    Its proportional set size would change when another process that has the same libraries open ends.
    """
    handles: int
    """Open file descriptors."""
    threads: int


class ProcessGrowth(Message):
    """One process over the whole run."""

    role: str
    memory: float
    """Megabytes after the warm-up."""
    growth: float
    """Megabytes from then to the end."""
    handles: tuple[int, int]
    """After the warm-up, and at the end."""
    threads: tuple[int, int]


class FileSize(Message):
    """One file that the run has made."""

    name: str
    bytes: int


class Soak(Message):
    """The whole run."""

    tasks: int
    ended: dict[str, int]
    """How many tasks ended in which state."""
    processes: tuple[ProcessGrowth, ...]
    files: tuple[FileSize, ...]
    ledger_bytes_a_task: float
    samples: tuple[Sample, ...]
    wrong: tuple[str, ...]
    """What missed its aim; empty when the run is right."""


def run_soak(
    folder: Path,
    endpoint: str,
    tasks: int,
    *,
    metrics: str,
    tell: Callable[[int], None],
    warm_up: int = WARM_UP,
) -> Soak:
    """Carry out ``tasks`` tasks and measure.

    Args:
        folder: of the ledger and the mock's truth.
        endpoint: where the router listens.
        tasks: how many.
        metrics: host and port of the observer's page.
        tell: told how many have ended, now and then.
        warm_up: tasks after which nothing is expected to grow.

    Raises:
        SystemFailure: when a process ended, or a task did not.
    """
    options = RunOptions(bus=BusOptions(endpoint=endpoint, robot=ROBOT), data=folder, metrics=metrics)
    samples: list[Sample] = []
    ended: dict[str, int] = {}
    with ProcessSystem(options, roles=ROLES, played_by={"mock": MOCKED}) as system:
        _await_observer(system)
        driver = _Driver(system)
        for number in range(1, tasks + 1):
            state = driver.one(number)
            ended[state] = ended.get(state, 0) + 1
            if number % max(1, tasks // SAMPLES) == 0:
                samples += _samples(system, number)
                tell(number)
        files = _files(folder, system.supervisor.folder)
    growth = growth_of(samples, warm_up)
    ledger = sum(each.bytes for each in files if "ledger" in each.name)
    return Soak(
        tasks=tasks,
        ended=ended,
        processes=growth,
        files=files,
        ledger_bytes_a_task=round(ledger / tasks, 1),
        samples=tuple(samples),
        wrong=what_is_wrong(growth, files, ended),
    )


def _await_observer(system: ProcessSystem) -> None:
    """Wait for what a start does not wait for: measured before it is there, its beginning would be growth."""
    end = system.clocks.monotonic() + TASK_WITHIN
    while OBSERVER not in system.bus.alive():
        system.advance()
        if system.clocks.monotonic() > end:
            raise SystemFailure(f"the observer was not there {TASK_WITHIN:.0f} s after the start")


class _Driver:
    """Asks for one task after the other, as a client would."""

    def __init__(self, system: ProcessSystem) -> None:
        self._system = system
        self._statuses = Latest(system.bus, TASK_STATUS)

    def one(self, number: int) -> str:
        """Carry out one task; return the state in which it ended."""
        self._ask(RESET.key, AskReset(by="campaign").model_dump_json().encode())
        answer = TaskAnswer.model_validate_json(self._ask(REQUEST, json.dumps(request(number)).encode()))
        if not answer.accepted:
            raise SystemFailure(f"task {number} was refused: {answer.problems}")
        if number % CANCEL_EVERY == 1:
            self._ask(TASK_CANCEL.key, CancelTask(task=answer.task).model_dump_json().encode())
        return self._end_of(answer.task)

    def _end_of(self, task: str) -> str:
        clock = self._system.clocks
        end = clock.monotonic() + TASK_WITHIN
        while clock.monotonic() < end:
            self._system.advance()
            for status in self._statuses.take():
                if status.task == task and status.state.terminal:
                    return str(status.state)
        raise SystemFailure(f"{task} had not ended {TASK_WITHIN:.0f} s after its request")

    def _ask(self, key: str, payload: bytes) -> bytes:
        for _ in range(10):
            answer = wait_for(self._system, self._system.bus.query(key, payload), 2.0)
            if answer is not None:
                return answer
        raise SystemFailure(f"nobody answered on {key}")


def request(number: int) -> dict[str, JsonValue]:
    """Return the request of a task by its number, with an id that is its own."""
    missing = number % CANCEL_EVERY == CANCEL_EVERY // 2
    return {"task": "fetch", "item": 42 if missing else ITEM, "to": "depot", "id": f"soak-{number}"}


def growth_of(samples: Iterable[Sample], warm_up: int) -> tuple[ProcessGrowth, ...]:
    """Compare the first samples after the warm-up with the last ones; medians of ``WINDOW``."""
    by_role: dict[str, list[Sample]] = {}
    for sample in samples:
        if sample.tasks >= warm_up:
            by_role.setdefault(sample.role, []).append(sample)
    return tuple(
        ProcessGrowth(
            role=role,
            memory=round(median(each.memory for each in taken[:WINDOW]), 2),
            growth=round(
                median(each.memory for each in taken[-WINDOW:])
                - median(each.memory for each in taken[:WINDOW]),
                2,
            ),
            handles=(
                _middle(each.handles for each in taken[:WINDOW]),
                _middle(each.handles for each in taken[-WINDOW:]),
            ),
            threads=(
                _middle(each.threads for each in taken[:WINDOW]),
                _middle(each.threads for each in taken[-WINDOW:]),
            ),
        )
        for role, taken in by_role.items()
    )


def what_is_wrong(
    growth: Sequence[ProcessGrowth], files: Iterable[FileSize], ended: dict[str, int]
) -> tuple[str, ...]:
    """Return what missed its aim, in words."""
    wrong = list[str]()
    if not growth:
        wrong.append("there are no samples after the warm-up; ask for more tasks")
    for each in growth:
        if each.growth > GROWTH_ALLOWED:
            wrong.append(f"{each.role} grew by {each.growth:.2f} MB; expected at most {GROWTH_ALLOWED:g}")
        if each.handles[0] != each.handles[1]:
            wrong.append(f"{each.role} has {each.handles[1]} open handles, and had {each.handles[0]}")
        if each.threads[0] != each.threads[1]:
            wrong.append(f"{each.role} has {each.threads[1]} threads, and had {each.threads[0]}")
    wrong += [
        f"{each.name} has {each.bytes} bytes; expected at most {LOGS_BOUND}"
        for each in files
        if ".log" in each.name and each.bytes > LOGS_BOUND
    ]
    if "SUCCEEDED" not in ended:
        wrong.append("no task succeeded, so nothing was shown")
    return tuple(wrong)


def _samples(system: ProcessSystem, tasks: int) -> list[Sample]:
    taken = []
    for role, pid in {SUPERVISOR: os.getpid(), **system.pids()}.items():
        found = usage(pid)
        taken.append(
            Sample(tasks=tasks, role=role, memory=found.memory, handles=found.handles, threads=found.threads)
        )
    return taken


def _files(*folders: Path) -> tuple[FileSize, ...]:
    return tuple(
        FileSize(name=str(path.relative_to(folder)), bytes=path.stat().st_size)
        for folder in folders
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    )


def _middle(values: Iterable[int]) -> int:
    return round(median(values))
