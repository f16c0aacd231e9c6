"""Which records a task has, and what is told of a moment."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from web_fake import FakeRobot
from web_record import record

from tandem.executive.web.app import application
from tandem.skills.ports.records import BlackBox, Cause, RecordingFile, Records
from tandem.skills.ports.tasks import TaskState, TaskStatus

AT = "http://127.0.0.1:8447"
TASK = TaskStatus(
    task="fetch-0001", kind="fetch", state=TaskState.SUCCEEDED, request={}, accepted_at=100.0, ended_at=200.0
)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("my records") / "box.jsonl.gz"
    record(made)
    return made


@pytest.fixture
def robot(path: Path) -> FakeRobot:
    cause = Cause(kind="task", words="GRASP_EMPTY", task=TASK.task)
    box = BlackBox(file=str(path), size=1000, began=0.0, causes=(cause,))
    return FakeRobot(tasks=(TASK,), records=Records(boxes=(box,)))


@pytest.fixture
def page(robot: FakeRobot) -> Iterator[TestClient]:
    with TestClient(application(robot), base_url=AT, headers={"origin": AT}) as client:
        yield client


def test_a_black_box_is_told_with_its_cause_and_a_command(page: TestClient, path: Path) -> None:
    (box,) = page.get("/api/task/fetch-0001/records").json()["boxes"]
    assert box["causes"] == [{"words": "GRASP_EMPTY", "stamp": None}]
    assert box["command"] == f"tandem replay '{path}' --web"


@pytest.mark.parametrize(
    ("began", "written", "has"), [(0, 99, False), (0, 150, True), (150, 300, True), (201, 300, False)]
)
def test_a_recording_of_the_time_of_the_task_has_it(
    page: TestClient, robot: FakeRobot, began: float, written: float, *, has: bool
) -> None:
    file = RecordingFile(file="/records/a.mcap", size=5, began=began, written=written)
    robot.records = Records(boxes=(), recordings=(file,))
    told = page.get("/api/task/fetch-0001/records").json()["recordings"]
    assert [each["command"] for each in told] == ["tandem replay /records/a.mcap --web"] * has


def test_board_beliefs_and_tree_are_as_they_were(page: TestClient) -> None:
    def told(seconds: float) -> Any:
        return page.get(f"/api/task/fetch-0001/moment?seconds={seconds}").json()

    early, late, again = told(1.5), told(14.0), told(1.5)
    every = " ".join(json.dumps(told(tenths / 10)["tree"]) for tenths in range(20, 70, 2))
    assert '"running: phase MOVING, progress 0.00"' in every, "and no lists of corners"
    assert again == early
    assert (early["tree"]["board"]["item"], "grasp" in early["tree"]["board"]) == ("29", False)
    assert "pre_grasp" in late["tree"]["board"]["grasp"]
    assert [each["item"] for each in late["world"]["items"]] == [29]
    assert abs(early["stamp"]["seconds"] - 1.5) < 0.1


@pytest.mark.parametrize(
    ("seconds", "file", "status", "words"),
    [
        ("500", None, 404, "nothing was recorded at 500.0 s; box.jsonl.gz ends 485 s before"),
        ("nan", None, 422, "expected robot seconds"),
        ("soon", None, 422, "expected robot seconds"),
        ("2", "", 404, "no black box has fetch-0001"),
        ("2", "/elsewhere/box.jsonl.gz", 404, "run `tandem replay /elsewhere/box.jsonl.gz --web` there"),
    ],
)
def test_what_can_not_be_told_is_said_in_words(  # noqa: PLR0917
    page: TestClient, robot: FakeRobot, seconds: str, file: str | None, status: int, words: str
) -> None:
    if file is not None:
        box = robot.records.boxes[0].model_copy(update={"file": file})
        robot.records = Records(boxes=(box,) if file else ())
    answer = page.get(f"/api/task/fetch-0001/moment?seconds={seconds}")
    assert (answer.status_code, words in answer.json()["error"]) == (status, True)
