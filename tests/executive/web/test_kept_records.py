"""Which records a task has, and what is told of a moment."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from web_fake import FakeRobot
from web_record import STEP, Run, record

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.recording import Facts
from tandem.executive.web.app import application
from tandem.skills.ports.records import BlackBox, Cause, RecordingFile, Records
from tandem.skills.ports.tasks import TaskState, TaskStatus

FACTS = Facts(site="lab", robot="tiago", release="0.1.0", began=0.0)
AT = "http://127.0.0.1:8447"
TASK = TaskStatus(
    task="fetch-0001", kind="fetch", state=TaskState.SUCCEEDED, request={}, accepted_at=100.0, ended_at=200.0
)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("my records") / "box.jsonl.gz"


@pytest.fixture(scope="module", autouse=True)
def run(path: Path) -> Run:
    return record(path)


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

    first = told(1.5)
    early, late, again = first["shown"], told(14.0)["shown"], told(1.5)
    every = " ".join(json.dumps(told(tenths / 10)["shown"]["tree"]) for tenths in range(20, 70, 2))
    assert '"sent to arm_left/move"' in every
    assert again == first
    assert (early["tree"]["board"]["item"], "grasp" in early["tree"]["board"]) == ("29", False)
    assert "pre_grasp" in late["tree"]["board"]["grasp"]
    assert [each["item"] for each in late["world"]["items"]] == [29]
    assert abs(first["stamp"]["seconds"] - 1.5) < 0.1


def test_a_moment_is_told_as_it_was_told_then(page: TestClient, run: Run) -> None:
    for tick, then in run.shown.items():
        told = page.get(f"/api/task/fetch-0001/moment?seconds={(tick + 1) * STEP}&boot=b").json()["shown"]
        assert {"tree", "board", "world", "pose", "scene"} <= told.keys()
        assert {part: then.get(part, value) for part, value in told.items()} == told


def test_a_recording_that_is_still_written_has_the_moment_first(
    page: TestClient, robot: FakeRobot, run: Run, tmp_path: Path
) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as stream:
        file = McapFile(stream, FACTS, 0.0, JsonSchemas().of)
        for message in run.messages[: len(run.messages) // 2]:
            file.put(message)
        file.flush()
        written = RecordingFile(file=str(path), size=5, began=50.0, written=150.0)
        robot.records = Records(boxes=robot.records.boxes, recordings=(written,))

        def told(seconds: float, boot: str = "b") -> Any:
            return page.get(f"/api/task/fetch-0001/moment?seconds={seconds}&boot={boot}").json()

        early = told(1.5)
        assert early["file"] == str(path)
        assert told(14.0)["file"] == robot.records.boxes[0].file, "the recording has not come so far"
        for message in run.messages[len(run.messages) // 2 :]:
            file.put(message)
        file.flush()
        assert told(14.0)["file"] == str(path)
        assert told(1.5) == early
        assert "nothing of that start of the robot" in told(1.5, "another")["error"]


@pytest.mark.parametrize(
    ("seconds", "file", "status", "words"),
    [
        ("500", None, 404, "nothing was recorded at 500.0 s; box.jsonl.gz ends 485 s before"),
        ("nan", None, 422, "expected robot seconds"),
        ("soon", None, 422, "expected robot seconds"),
        ("2", "", 404, "no record has fetch-0001"),
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
