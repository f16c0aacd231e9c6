"""What ``tandem up`` says that it takes up. Each state at a restart is cheaper to make from inside."""

from __future__ import annotations

import pytest

from tandem.executive.config.on_restart import OnRestart
from tandem.executive.ledger.port import Entry
from tandem.executive.system.startup_notice import MOVES, lines
from tandem.skills.ports.tasks import TaskState, TaskStatus


def entry(number: int, state: TaskState, on_restart: OnRestart | None = None) -> Entry:
    status = TaskStatus(
        task=f"fetch-{number:04}",
        kind="fetch",
        state=state,
        request={"task": "fetch", "item": 29, "id": "x"},
        accepted_at=1.0,
    )
    return Entry(status, number, on_restart=on_restart)


RUNNING, QUEUED, PAUSED = TaskState.RUNNING, TaskState.QUEUED, TaskState.PAUSED


@pytest.mark.parametrize(
    ("entries", "default", "said", "moves"),
    [
        ([], "resume", [], False),
        ([entry(1, RUNNING)], "resume", ["resumes"], True),
        ([entry(1, RUNNING)], "ask", ["asks an operator"], False),
        ([entry(1, RUNNING, "resume")], "ask", ["resumes"], True),
        ([entry(1, RUNNING)], "interrupt", ["INTERRUPTED"], False),
        ([entry(1, RUNNING), entry(2, QUEUED)], "interrupt", ["INTERRUPTED", "is queued"], True),
        ([entry(1, PAUSED), entry(2, QUEUED)], "resume", ["is paused", "is queued"], False),
        ([entry(1, TaskState.CANCELING)], "interrupt", ["is being cancelled"], True),
        ([entry(1, QUEUED)], "ask", ["is queued"], True),
    ],
)
def test_each_task_and_whether_the_robot_moves(
    entries: list[Entry], default: OnRestart, said: list[str], *, moves: bool
) -> None:
    told = list(lines(entries, default))
    assert (MOVES in told) is moves
    for line, words, each in zip(told, said, entries, strict=False):
        assert line.startswith(f'{each.status.task} {{"item": 29}} ')
        assert words in line
    assert len(told) == len(entries) + moves
