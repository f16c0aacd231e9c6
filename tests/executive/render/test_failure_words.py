"""What an operator is told about a failed task."""

from __future__ import annotations

import pytest

from tandem.executive.render.failure_words import NEXT, chosen, explain, last_picture, what_next
from tandem.skills.ports.failure import Failure, FailureKind, Helper
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import Attempt, Progress, TaskState, TaskStatus

EMPTY = Failure(
    kind=FailureKind.GRASP_EMPTY, message="closed on nothing", where="close hand: gripper_left/grip"
)
FAILED = TaskStatus(
    task="fetch-1",
    kind="fetch",
    request={"task": "fetch", "item": 29},
    state=TaskState.FAILED,
    progress=Progress(phase="pick", fraction=0.3),
    accepted_at=0.0,
    started=RobotTime(boot="a", seconds=1.0),
    ended=RobotTime(boot="a", seconds=61.5),
    failure=Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message="tried from everywhere",
        where="get item",
        evidence={"item": 29, "item_is": "last seen at (1.00, 2.00, 0.70) m", "robot_is": "at home"},
        causes=(EMPTY,),
    ),
    tried=(
        Attempt(
            at=RobotTime(boot="a", seconds=20.0), failure=EMPTY, recovery="draw back", times=1, picture="1"
        ),
        Attempt(at=RobotTime(boot="a", seconds=40.0), failure=EMPTY, recovery="draw back", times=2),
    ),
)


def test_what_a_task_found_is_told_line_by_line() -> None:
    found = {"spots": ["a", "b"], "items": [{"item": 29}, {"item": 42}]}
    said = explain(FAILED.model_copy(update={"result": found}))
    assert 'what it found\n  spots: ["a", "b"]\n  items:\n    {"item": 29}\n    {"item": 42}' in said


def task(name: str, state: TaskState) -> TaskStatus:
    failure = EMPTY if state is TaskState.FAILED else None
    return FAILED.model_copy(update={"task": name, "state": state, "failure": failure})


@pytest.mark.parametrize(
    "said",
    [
        "fetch-1: FAILED after 60.5 s of robot time, in the phase 'pick', 30% done",
        "get item -> ITEM_UNREACHABLE: tried from everywhere",
        "evidence: item 29\n",
        "close hand -> gripper_left/grip -> GRASP_EMPTY: closed on nothing",
        "-> draw back, 2nd attempt",
        "in total: draw back 2 x",
        "the item is last seen at (1.00, 2.00, 0.70) m",
        "the robot is at home",
        "who can help: operator",
        "Move the item towards the edge",
    ],
)
def test_it_says(said: str) -> None:
    assert said in explain(FAILED)


@pytest.mark.parametrize("kind", FailureKind)
def test_something_can_be_done_about_each_kind(kind: FailureKind) -> None:
    assert len(what_next(Failure(kind=kind, message=""))) > 20


def test_each_helper_is_told_what_to_do() -> None:
    assert set(NEXT) == set(Helper)


def test_a_task_that_has_not_failed_is_told_so() -> None:
    assert "has not failed" in explain(task("fetch-2", TaskState.RUNNING))


@pytest.mark.parametrize(
    ("states", "expected"),
    [
        ("FAILED SUCCEEDED RUNNING QUEUED", "0"),
        ("FAILED FAILED RUNNING", "1"),
        ("SUCCEEDED PAUSED QUEUED", "1"),
        ("SUCCEEDED QUEUED", None),
        ("", None),
    ],
)
def test_which_task_is_told_unless_one_is_named(states: str, expected: str | None) -> None:
    tasks = tuple(task(str(number), TaskState(state)) for number, state in enumerate(states.split()))
    found = chosen(tasks, "")
    assert (None if found is None else found.task) == expected


def test_a_named_task_is_found_or_not() -> None:
    assert chosen((FAILED,), "fetch-1") is FAILED
    assert chosen((FAILED,), "fetch-2") is None


def test_the_newest_picture() -> None:
    assert last_picture(FAILED) == "1"
