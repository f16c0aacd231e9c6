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
        "    20.0 s  GRASP_EMPTY at close hand: gripper_left/grip: closed on nothing  (picture 1)\n",
        "-> draw back, 2 times: the first at 20.0 s, the last at 40.0 s\n",
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


def attempt(seconds: float, message: str, boot: str = "a", recovery: str = "draw back") -> Attempt:
    failure = EMPTY.model_copy(update={"message": message})
    return Attempt(at=RobotTime(boot=boot, seconds=seconds), failure=failure, recovery=recovery, times=1)


def test_failures_that_differ_in_numbers_alone_are_said_once_and_the_others_in_their_order() -> None:
    tried = (
        attempt(1.0, "off by 0.1 m"), attempt(2.0, "closed on nothing"), attempt(3.0, "off by 0.25 m"),
        attempt(4.0, "off by 0.3 m", recovery=""), attempt(0.5, "off by 0.1 m", boot="b"),
    )  # fmt: skip
    said = explain(FAILED.model_copy(update={"tried": tried})).split("what was tried\n")[1].splitlines()
    assert [line.split("close hand: gripper_left/grip: ")[-1].strip() for line in said[:8]] == [
        "off by 0.1 m", "-> draw back, 2 times: the first at 1.0 s, the last at 3.0 s",
        "closed on nothing", "-> draw back, 1st attempt",
        "off by 0.3 m", "-> nothing",
        "off by 0.1 m", "-> draw back, 1st attempt",
    ]  # fmt: skip


def test_a_repeated_cause_is_said_once_with_how_often_when_and_what_was_measured() -> None:
    causes = tuple(
        EMPTY.model_copy(update={"message": f"off by {off} m", "evidence": {"off_m": off, "arm": "left"}})
        for off in (0.3, 0.1, 0.2)
    )
    failure = Failure(kind=FailureKind.ITEM_UNREACHABLE, message="", causes=(causes[0], EMPTY, *causes[1:]))
    tried = (attempt(5.0, "off by 0.3 m"), attempt(9.0, "off by 0.2 m"))
    said = explain(FAILED.model_copy(update={"failure": failure, "tried": tried})).split("what was tried")[0]
    assert said.count("EMPTY: off by") == said.count("EMPTY: closed on nothing") == 1
    assert "3 times, the first at 5.0 s, the last at 9.0 s" in said
    assert "evidence: off_m 0.1 to 0.3, arm left" in said
