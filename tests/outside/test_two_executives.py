"""One robot has one executive, whenever and however often one is started.

A user saw: of two executives that were started at the same moment both stayed (one pair in six), and both
accepted the same request under the same task id. On a busy machine one started beside another that had been
there for a minute.
"""

from __future__ import annotations

import json
import re
import signal
from pathlib import Path

import pytest

from tests.outside._mocked import Mocked, until

REFUSED = 4
FETCH = {"task": "fetch", "item": 29}
NAMES_THE_OTHER = re.compile(r"executive: process \d+ on \S+ plays this role already")
pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


def another(system: Mocked, name: str) -> None:
    """Start an executive that somebody else has started: with a parent and a ledger of its own."""
    folder = system.folder / name
    folder.mkdir(exist_ok=True)
    system.start("executive", name=name, data=str(folder), lineage=name, generation=1)


def words(system: Mocked, name: str) -> str:
    return (system.folder / f"{name}.log").read_text("utf-8", "replace")


def begun(system: Mocked, task: str) -> int:
    """Return how many goals of a task the robot has begun."""
    file = system.folder / "deeds.jsonl"
    deeds = [json.loads(line) for line in file.read_text("utf-8").splitlines()] if file.exists() else []
    return sum(deed["what"] == "began" and deed["goal_id"].startswith(f"{task}/") for deed in deeds)


def test_of_two_that_start_together_one_serves_and_whoever_comes_late_leaves(tmp_path: Path) -> None:
    with Mocked(tmp_path, "pairs") as system:
        system.signal("executive", signal.SIGKILL)
        until("the first is gone", lambda: system.code("executive") is not None)
        pair = ("left", "right")
        for name in pair:
            another(system, name)
        until("one of them ends", lambda: any(system.code(name) is not None for name in pair))
        (loser,) = (name for name in pair if system.code(name) is not None)
        assert system.code(loser) == REFUSED, words(system, loser)
        assert NAMES_THE_OTHER.search(words(system, loser))
        assert "Traceback" not in words(system, loser)
        until("the other serves", system._is_there)
        assert system.until_state(system.client.submit(FETCH), "SUCCEEDED") == "SUCCEEDED"

        another(system, "late")
        until("the late one ends", lambda: system.code("late") is not None)
        assert system.code("late") == REFUSED
        assert NAMES_THE_OTHER.search(words(system, "late"))
        assert len(system.alive("role/executive/*")) == 1


def test_one_that_was_stopped_until_another_took_over_moves_nothing(tmp_path: Path) -> None:
    """It is stopped in the middle of a task. When it goes on it would send the task's next goal."""
    with Mocked(tmp_path, "zombie") as system:
        task = system.client.submit(FETCH)
        until("its task goes on", lambda: begun(system, task))
        system.signal("executive", signal.SIGSTOP)
        until("it is dropped", lambda: not system.alive("role/executive/*"))
        another(system, "heir")
        until("the other serves", lambda: system.alive("process/executive"))
        before = begun(system, task)
        system.signal("executive", signal.SIGCONT)
        until("it ends", lambda: system.code("executive") is not None)
        assert system.code("executive") == REFUSED, system.log
        assert NAMES_THE_OTHER.search(system.log)
        assert begun(system, task) == before
        system._leave()
        heirs = system.client.submit(FETCH)
        assert system.until_state(heirs, "SUCCEEDED") == "SUCCEEDED"
        assert begun(system, heirs)
