"""What ``tandem up`` says of its robot's tasks: a line when one is accepted, starts and ends."""

from __future__ import annotations

import pytest

from tandem.executive.cli.task_lines import TaskLines
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TASK_STATUS, TaskState, TaskStatus
from tandem.skills.wire.memory import MemoryBus

QUEUED, RUNNING, PAUSED = TaskState.QUEUED, TaskState.RUNNING, TaskState.PAUSED
ACCEPTED = 'fetch-1 accepted: fetch {"item": 29}'


def status(state: TaskState, **more: object) -> TaskStatus:
    began = None if state is QUEUED else RobotTime(boot="b", seconds=1.0)
    return TaskStatus.model_validate(
        {
            "task": "fetch-1",
            "kind": "fetch",
            "request": {"task": "fetch", "id": "x", "item": 29},
            "state": state,
            "accepted_at": 0.0,
            "started": began,
            "ended": RobotTime(boot="b", seconds=62.25) if state.terminal else None,
            "begun": 0 if state is QUEUED else 1,
            **more,
        }
    )


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ([status(QUEUED), status(QUEUED)], [ACCEPTED]),
        ([status(QUEUED), status(RUNNING), status(PAUSED), status(RUNNING)], [ACCEPTED, "fetch-1 started"]),
        ([status(RUNNING, begun=2)], ["fetch-1 started again"]),
        (
            [status(QUEUED), status(RUNNING), status(TaskState.SUCCEEDED), status(TaskState.SUCCEEDED)],
            [ACCEPTED, "fetch-1 started", "fetch-1 ended: SUCCEEDED after 61.2 s of robot time"],
        ),
        ([status(TaskState.SUCCEEDED)], []),
    ],
)
def test_each_change_is_a_line_and_nothing_else_is(told: list[TaskStatus], said: list[str]) -> None:
    bus, lines = MemoryBus(), list[str]()
    tasks = TaskLines(bus, lines.append)
    for each in told:
        TASK_STATUS.publish(bus, each)
        tasks.step()
    assert lines == said


def test_a_failure_says_why() -> None:
    bus, lines = MemoryBus(), list[str]()
    tasks = TaskLines(bus, lines.append)
    failure = {"kind": "NO_IK", "message": "no joints"}
    for each in (status(QUEUED), status(TaskState.FAILED, failure=failure, started=None)):
        TASK_STATUS.publish(bus, each)
        tasks.step()
    assert lines[-1] == "fetch-1 ended: FAILED: NO_IK: no joints"


def test_long_requests_are_cut() -> None:
    bus, lines = MemoryBus(), list[str]()
    tasks = TaskLines(bus, lines.append)
    TASK_STATUS.publish(bus, status(QUEUED, request={"task": "fetch", "to": "x" * 200}))
    tasks.step()
    assert len(lines[0]) < 140
