"""A client that asks ten thousand times a second: the running task goes on, and others are answered."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import REQUEST, TASK_STATUS, TaskAnswer, TaskState, by_client
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until
from tests.fakes.ports import free_endpoint

pytestmark = pytest.mark.processes
HERE = Path(__file__).parents[2]
ROOT = HERE.parents[1]
FETCH = json.dumps({"task": "fetch", "item": 29}).encode()


@pytest.fixture
def endpoint() -> Iterator[str]:
    """A system with a mocked robot, each of whose skills takes 0.1 s."""
    endpoint = free_endpoint()
    argv = [
        sys.executable,
        str(HERE / "mock_system.py"),
        endpoint.rpartition(":")[2],
        "0.1",
        "robot,executive",
    ]
    system = subprocess.Popen(argv, cwd=ROOT, env={"PYTHONPATH": "."}, stdout=subprocess.PIPE, text=True)
    assert system.stdout is not None
    assert system.stdout.readline() == "ready\n"
    yield endpoint
    system.kill()
    system.wait()


def ask(bus: ZenohBus, client: str) -> TaskAnswer:
    """Ask until there is an answer, as every client does."""
    while True:
        answer = wait_until(bus, bus.query(by_client(client, REQUEST), FETCH), 2.0)
        if answer is not None:
            return TaskAnswer.model_validate_json(answer)


def test_a_flood_stops_neither_the_task_nor_another_client(endpoint: str) -> None:
    bus = ZenohBus(endpoint, "lab/tiago")
    statuses = Latest(bus, TASK_STATUS, depth=4096)
    running = ask(bus, "polite").task
    argv = [sys.executable, "-m", "benchmarks.flood", endpoint, "lab/tiago", "flood", "10000", "3"]
    with subprocess.Popen(argv, cwd=ROOT, stdout=subprocess.PIPE, text=True) as flood:
        ended: set[str] = set()
        answers = []
        deadline = time.monotonic() + 30.0
        while (running not in ended or flood.poll() is None) and time.monotonic() < deadline:
            if len(answers) < 20:
                answers.append(ask(bus, "polite"))
            bus.waker.wait(0.1)
            ended |= {each.task for each in statuses.take() if each.state is TaskState.SUCCEEDED}
        said = flood.communicate()[0]
    bus.close()
    assert int(said.split()[0]) > 1000
    assert running in ended
    assert [answer for answer in answers if not answer.accepted] == []
