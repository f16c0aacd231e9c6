"""Processes that hang (SIGSTOP) while an arm moves: the arm stands, and goes on when they do."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator

import pytest

from benchmarks.hanging import Moving, stands
from tandem.executive.config.run_options import RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.skills.ports.action import GoalState
from tests.acceptance.live import go_on, own_bus

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


@pytest.fixture
def live() -> Iterator[ProcessSystem]:
    with ProcessSystem(RunOptions(bus=own_bus(), scenario="Defaults")) as system:
        yield system


@pytest.mark.parametrize("role", ["executive", "arm_left"])
def test_the_arm_stands_while_it_hangs_and_gets_there_afterwards(live: ProcessSystem, role: str) -> None:
    moving = Moving(live, f"{role}/hangs/1", "carry")
    go_on(live, moving.moves, within=30.0, seen=lambda: (moving.status(), moving.joints.refresh()))
    process = live.pids()[role]
    os.kill(process, signal.SIGSTOP)
    try:
        go_on(live, lambda: stands(moving), within=10.0)
    finally:
        os.kill(process, signal.SIGCONT)
    go_on(live, lambda: moving.state().terminal, within=60.0)
    assert moving.state() is GoalState.SUCCEEDED, moving.status()


def test_a_process_that_hangs_for_good_is_killed_and_started_again() -> None:
    said: list[str] = []
    with ProcessSystem(
        RunOptions(bus=own_bus(), scenario="Defaults"), say=said.append, hung_after=3.0
    ) as system:
        hangs = system.pids()["base"]
        os.kill(hangs, signal.SIGSTOP)
        go_on(system, lambda: system.pids().get("base") not in (None, hangs), within=30.0)
        go_on(system, lambda: "process/base" in system.bus.awake(), within=30.0)
    assert said == [
        "the base process hangs; killing it",
        "the base process ended (signal 9); restarted",
    ]
