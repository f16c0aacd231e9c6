"""The command and a plain client against a real router and executive, with a mocked robot."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pytest

from tandem.executive.cli.main import main

pytestmark = pytest.mark.processes
HERE = Path(__file__).parents[1]
ROOT = HERE.parents[1]
Start = Callable[[str, str], list[str]]


@pytest.fixture
def start() -> Iterator[Start]:
    """Start a system with these parts; returns the options that lead a command to it."""
    started: list[subprocess.Popen[str]] = []

    def begin(duration: str, parts: str) -> list[str]:
        with closing(socket.socket()) as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        argv = [sys.executable, str(HERE / "mock_system.py"), str(port), duration, parts]
        process = subprocess.Popen(argv, cwd=ROOT, env={"PYTHONPATH": "."}, stdout=subprocess.PIPE, text=True)
        started.append(process)
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        return ["--connect", f"tcp/127.0.0.1:{port}"]

    yield begin
    for process in started:
        process.kill()
        process.wait()


def test_a_fetch_from_the_command(start: Start, capfd: pytest.CaptureFixture[str]) -> None:
    system = start("0.1", "robot,executive")
    assert main(["request", "fetch", "--item", "29", "--wait", *system]) == 0
    out = capfd.readouterr().out
    assert out.startswith("fetch-")
    assert "SUCCEEDED" in out
    assert main(["tasks", *system]) == 0
    assert "SUCCEEDED" in capfd.readouterr().out
    assert main(["watch", "--once", *system]) == 0
    assert "100%" in capfd.readouterr().out
    assert main(["tree", "render", "--live", *system]) == 0
    assert "✓ → fetch" in capfd.readouterr().out
    assert main(["request", "fetch", "--item", "30", *system]) == 2
    assert "item: expected one of" in capfd.readouterr().err
    assert main(["request", "json", '{"task": "fetch", "item": NaN}', *system]) == 2
    assert "item: expected a finite number, found NaN" in capfd.readouterr().err


def test_cancel_from_the_command(start: Start, capfd: pytest.CaptureFixture[str]) -> None:
    system = start("0.5", "robot,executive")
    assert main(["request", "fetch", "--item", "29", *system]) == 0
    task = capfd.readouterr().out.strip()
    assert main(["cancel", task, *system]) == 0
    assert "cancelling" in capfd.readouterr().out
    for _ in range(50):
        assert main(["tasks", "--json", *system]) == 0
        (status,) = json.loads(capfd.readouterr().out)["tasks"]
        if status["state"] == "CANCELED":
            break
        time.sleep(0.05)
    assert status["state"] == "CANCELED"
    assert main(["cancel", task, *system]) == 2


def state(system: list[str], capfd: pytest.CaptureFixture[str], wanted: str) -> bool:
    """Wait until the only task is in this state."""
    for _ in range(100):
        assert main(["tasks", "--json", *system]) == 0
        (status,) = json.loads(capfd.readouterr().out)["tasks"]
        if status["state"] == wanted:
            return True
        time.sleep(0.05)
    return False


def test_pause_step_and_resume_from_the_command(start: Start, capfd: pytest.CaptureFixture[str]) -> None:
    system = start("0.5", "robot,executive")
    assert main(["why", *system]) == 0
    assert "no task has failed" in capfd.readouterr().out
    assert main(["pause", *system]) == 2
    assert "no task is running" in capfd.readouterr().err
    assert main(["request", "fetch", "--item", "29", *system]) == 0
    task = capfd.readouterr().out.strip()
    assert main(["pause", *system]) == 0
    assert f"pausing {task}" in capfd.readouterr().out
    assert state(system, capfd, "PAUSED")
    assert main(["step", *system]) == 0
    capfd.readouterr()
    assert state(system, capfd, "PAUSED")
    assert main(["resume", task, *system]) == 0
    assert "resuming" in capfd.readouterr().out
    assert main(["step", *system]) == 2
    assert "not paused" in capfd.readouterr().err
    assert main(["why", *system]) == 0
    assert f"{task}: RUNNING" in capfd.readouterr().out
    assert main(["why", "fetch-0", *system]) == 2
    assert "tandem tasks" in capfd.readouterr().err


def test_a_router_alone_is_not_enough(start: Start, capfd: pytest.CaptureFixture[str]) -> None:
    system = start("0.0", "nothing")
    began = time.monotonic()
    assert main(["request", "fetch", "--item", "29", *system]) == 3
    assert time.monotonic() - began < 3.0
    assert "no executive answers on lab/tiago" in capfd.readouterr().err


def test_an_executive_without_a_robot_takes_the_task_and_says_so(
    start: Start, capfd: pytest.CaptureFixture[str]
) -> None:
    system = start("0.0", "executive")
    assert main(["request", "fetch", "--item", "29", *system]) == 0
    said = capfd.readouterr()
    assert f"no robot answers on lab/tiago: {said.out.strip()} is queued" in said.err


def test_ten_lines_of_python(start: Start) -> None:
    system = start("0.1", "robot,executive")
    argv = [sys.executable, str(ROOT / "examples" / "request.py"), "29", system[1]]
    done = subprocess.run(argv, capture_output=True, text=True, check=True, timeout=20)
    assert "'accepted': True" in done.stdout
