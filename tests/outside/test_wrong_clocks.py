"""The host's clock jumps, or is far off at one start.

A user saw: one start with the clock a year ahead forgot all history, and the same client id ran a second
time; a jump of an hour that lasted one second expired a task that had half an hour left; a clock that was set
back repeated a task id. That a task which has begun does not expire needs a moment that can't be hit from
outside (``tests/executive/service/tasks/test_task_queue.py`` has it).
"""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from tests.outside._mocked import Mocked, until

FETCH = {"task": "fetch", "item": 29}
HOUR = 3600.0
YEAR = 365 * 24 * HOUR
pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


def test_a_start_with_the_clock_a_year_ahead_forgets_nothing_and_runs_nothing_twice(tmp_path: Path) -> None:
    with Mocked(tmp_path, "yearahead") as system:
        first = system.client.submit(FETCH, client_id="mine")
        assert system.until_state(first) == "SUCCEEDED"
        ids = {first}
        for shift in (YEAR, -YEAR, 0.0):
            system.shift_clock(shift)
            system.crash()
            assert system.client.submit(FETCH, client_id="mine") == first
            assert first in {each.task for each in system.client.history().tasks}
            ids.add(system.client.submit(FETCH))
        assert len(ids) == 4
        assert system.client.status(first).begun == 1
        assert "old tasks are not deleted" in system.log


def test_a_jump_of_an_hour_expires_no_task_with_half_an_hour_left(tmp_path: Path) -> None:
    with Mocked(tmp_path, "hourjump") as system:
        system.put("hw/stop/state", {"stopped": True, "by": "test", "reason": "so that it waits"})
        until("the stop is heard", lambda: "stop" in _first(system))
        soon = system.client.submit({**FETCH, "expires": time.time() + HOUR / 2})
        late = system.client.submit({**FETCH, "expires": time.time() + 3.0})
        system.shift_clock(HOUR)
        until("it is noticed", lambda: "the ledger says" in system.log)
        assert system.state(soon) == "QUEUED"
        assert "a clock that can be trusted" in system.client.status(soon).waits_for
        system.shift_clock(0.0)
        until("it is noticed", lambda: "the clock is back" in system.log)
        assert system.until_state(late, "EXPIRED") == "EXPIRED"
        system.put("hw/stop/state", {"stopped": False})
        assert system.until_state(soon) == "SUCCEEDED"


def _first(system: Mocked) -> str:
    task = system.client.submit(FETCH, client_id="first")
    return system.client.status(task).waits_for
