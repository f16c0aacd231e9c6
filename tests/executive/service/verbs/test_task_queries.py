"""What questions about tasks leave behind."""

from __future__ import annotations

import gc
import weakref
from pathlib import Path

import pytest
from surroundings import Surroundings

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.tasks import task_book
from tandem.skills.ports.tasks import TASK_LIST, AskTasks, TaskStatus


def test_a_listed_task_is_forgotten_when_only_the_ledger_has_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page that lists the tasks again and again does not make the executive grow."""
    monkeypatch.setattr(task_book, "KEPT", 2)
    here, ended = Surroundings(ledger=lambda: SqliteLedger(tmp_path)), list[weakref.ref[TaskStatus]]()
    for number in range(5):
        task = here.ask({"task": "wait", "item": number}).task
        here.cancel(task)
        status = here.executive.book.get(task)
        assert status is not None
        ended.append(weakref.ref(status))
        del status
        listed = TASK_LIST.query(here.bus, AskTasks())
        here.step()
        assert listed.poll() is not None
    gc.collect()
    assert [each() is None for each in ended] == [True, True, True, False, False]
