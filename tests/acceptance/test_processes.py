"""The whole system as processes: a fetch, what clients get wrong, and second ones."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import load_scenario
from tandem.sim.truth import lies_on
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import REQUEST, TASK_ANSWERS, TaskAnswer, TaskState
from tandem.skills.site import load
from tests.acceptance.live import (
    COMMAND,
    ENVIRONMENT,
    ROOT,
    go_on,
    left_behind,
    own_bus,
    play,
    query,
    tasks,
    written,
)

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)
WRONG = {
    "not JSON": (b'{"task": "fetch", "item"', ""),
    "not UTF-8": (b"\xff\xfe\x00", ""),
    "an unknown item": (b'{"task": "fetch", "item": 500}', "item"),
    "an unknown field": (b'{"task": "fetch", "item": 29, "colour": "red"}', "colour"),
    "no item": (b'{"task": "fetch"}', "item"),
    "not a number": (b'{"task": "fetch", "item": NaN}', "item"),
    "out of range": (b'{"task": "fetch", "item": -1}', "item"),
    "an unknown destination": (b'{"task": "fetch", "item": 29, "to": "moon"}', "to"),
    "an unknown arm": (b'{"task": "fetch", "item": 29, "arm": "third"}', "arm"),
    "an unknown task": (b'{"task": "dance"}', "task"),
    "too much": (b'{"task": "fetch", "item": 29, "to": "%s"}' % (b"x" * 65 * 1024), ""),
}


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ProcessSystem]:
    """Return one system for all that leaves it as it was."""
    scenario = load_scenario("Demo").starting_at(BEFORE_THE_TABLE)
    path = written(scenario, tmp_path_factory.mktemp("scenario"))
    with ProcessSystem(RunOptions(bus=own_bus(), scenario=path, speed=None)) as system:
        yield system
        groups = list(system.pids().values())
    assert left_behind(groups) == ()


def put(system: ProcessSystem, answers: Latest[TaskAnswer], payload: bytes) -> TaskAnswer:
    """Put a request and wait for what is told to those who only put."""
    system.bus.publish(REQUEST, payload)
    return heard(system, answers)


def heard(system: ProcessSystem, answers: Latest[TaskAnswer]) -> TaskAnswer:
    """Wait for the one answer that is under way: each request's is told, also a query's."""
    got: list[TaskAnswer] = []

    def answered() -> bool:
        got.extend(answers.take())
        return bool(got)

    go_on(system, answered, within=5.0)
    (answer,) = got
    return answer


def test_a_fetch_asked_for_by_a_plain_put_goes_on_whatever_else_is_asked(live: ProcessSystem) -> None:
    caller, answers = Caller(live, lambda _: None), Latest(live.bus, TASK_ANSWERS, depth=64)
    go_on(live, lambda: live.bus.listened(REQUEST), within=5.0)
    taken = put(live, answers, b'{"task": "fetch", "item": 29, "id": "mine"}')
    assert taken.accepted, taken
    assert taken.client_id == "mine"

    for what, (payload, path) in WRONG.items():
        asked = query(live, payload)
        assert heard(live, answers) == asked, what
        for answer in (asked, put(live, answers, payload)):
            assert not answer.accepted, what
            assert answer.problems[0].path.startswith(path), what
            assert answer.problems[0].expected, what
    (only,) = tasks(live).tasks
    assert only.state is TaskState.RUNNING

    assert caller.follow(taken.task, within=200.0).state is TaskState.SUCCEEDED
    assert lies_on(caller.truth(), load("lab"), 29, "depot")


@pytest.mark.parametrize("role", ["hardware", "executive"])
def test_a_second_one_for_the_same_robot_refuses(live: ProcessSystem, tmp_path: Path, role: str) -> None:
    code, words = play(role, live._options, tmp_path)
    assert code == ExitCode.REFUSED, words
    assert f"{role}: process " in words
    assert "plays this role already" in words
    assert "for test/tiago at" in words
    assert "Traceback" not in words
    live.advance()


def test_a_second_system_at_the_same_endpoint_refuses(live: ProcessSystem) -> None:
    argv = [*COMMAND, "up", "--connect", live._options.bus.endpoint]
    done = subprocess.run(
        argv, check=False, env=ENVIRONMENT, cwd=ROOT, capture_output=True, text=True, timeout=60
    )
    assert done.returncode == ExitCode.REFUSED, done.stdout + done.stderr
    assert "another system is running there" in done.stderr
    live.advance()
