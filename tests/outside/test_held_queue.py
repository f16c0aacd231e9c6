"""What would fail every task holds the queue.

A user saw: with the hardware's stop set, each waiting task began, waited for ten seconds and failed
HARDWARE_STOPPED, until none was left.
"""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.outside._mocked import Mocked, until

FETCH = {"task": "fetch", "item": 29}
SILENCE = ("the hardware, which is silent", "the robot to publish: ")
pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


def told(waits_for: str) -> bool:
    """Say whether a task waits for hardware that says nothing."""
    return waits_for.startswith(SILENCE)


def test_a_set_stop_and_a_silent_robot_hold_all_that_wait(tmp_path: Path) -> None:
    with Mocked(tmp_path, "heldqueue") as system:
        system.put("hw/stop/state", {"stopped": True, "by": "ann", "reason": "a child"})
        tasks = [system.client.submit(FETCH) for _ in range(3)]
        until("the stop is told", lambda: "set by ann" in system.client.status(tasks[0]).waits_for)
        assert "set by ann" in system.client.info().waits_for
        system.crash()
        system.put("hw/stop/state", {"stopped": True, "by": "ann", "reason": "a child"})
        until("the stop is told", lambda: "set by ann" in system.client.status(tasks[1]).waits_for)
        assert {system.state(task) for task in tasks} <= {"QUEUED", "RUNNING"}
        system.signal("mock", signal.SIGSTOP)
        system.put("hw/stop/state", {"stopped": False})
        # The executive has heard the robot since its start, or not yet: nobody said that it should have.
        until("the silence is told", lambda: told(system.client.status(tasks[2]).waits_for))
        system.signal("mock", signal.SIGCONT)
        assert [system.until_state(task) for task in tasks] == ["SUCCEEDED"] * 3
