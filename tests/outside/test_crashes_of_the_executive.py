"""The executive is killed, and what was acknowledged holds.

A user saw: ``on_cancel: put_down``, a cancel, kill -9 within a second, and the task was CANCELED with the
item still in the hand; a breakpoint that had been taken was gone; a task at which the executive crashed 40
times was taken up once more, and the next one waited for ever.
"""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.outside._mocked import Mocked, until

FETCH = {"task": "fetch", "item": 29, "on_cancel": "put_down"}
IN_HAND = "put down"
"""A node of the fetch that begins with the item in the hand."""
pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


def held_before(system: Mocked, node: str) -> str:
    task = system.client.submit(FETCH)
    until("it runs", lambda: system.state(task) == "RUNNING")
    system.signal("mock", signal.SIGSTOP)  # so that it does not pass the node before the breakpoint is set
    system.client.set_breakpoint(task, node)
    system.signal("mock", signal.SIGCONT)
    assert system.until_state(task, "PAUSED") == "PAUSED"
    return task


def test_verbs_hold_over_kill_9(tmp_path: Path) -> None:
    with Mocked(tmp_path, "verbshold") as system:
        task = held_before(system, IN_HAND)
        system.crash()
        system.client.resume(task)
        assert system.until_state(task, "PAUSED") == "PAUSED", "the breakpoint is still there"
        assert system.hands() == {29}
        system.client.cancel(task)
        system.crash()
        assert system.until_state(task) == "CANCELED"
        assert system.client.status(task).failure is None
        assert system.hands() == set()


def test_a_task_at_which_the_executive_crashes_again_and_again_is_given_up(tmp_path: Path) -> None:
    with Mocked(tmp_path, "poison") as system:
        poison, after = system.client.submit(FETCH), system.client.submit(FETCH)
        until("it runs", lambda: system.state(poison) == "RUNNING")
        system.signal("mock", signal.SIGSTOP)
        for number in range(8):
            system.crash(died=f"signal 11, crash number {number}")
            if system.state(poison) == "INTERRUPTED":
                break
        system.signal("mock", signal.SIGCONT)
        assert system.state(poison) == "INTERRUPTED"
        assert number >= 3, "it was taken up three times before"
        why = system.client.why(poison)
        assert "crashed 4 times" in why
        assert f"signal 11, crash number {number}" in why
        assert system.until_state(after) == "SUCCEEDED"
