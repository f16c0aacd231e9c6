"""``tandem log`` and ``tandem replay``: what they print of a record, and what they refuse."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from mocked_fetch import MockedFetch

from tandem.executive.cli import option_checks
from tandem.executive.cli.commands.why_command import record_of
from tandem.executive.cli.main import main
from tandem.executive.config.extras import RECORD
from tandem.executive.config.run_options import BusOptions
from tandem.executive.records.moments import span_of
from tandem.executive.records.recording import Span, open_recording
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import TaskState, TaskStatus


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a black box of a task that failed."""
    system = MockedFetch(tmp_path_factory.mktemp("boxes"))
    system.fail()
    (path,) = system.black_boxes()
    return path


@pytest.fixture
def box(kept: Path, tmp_path: Path) -> str:
    """Return a copy of it, in a folder of its own."""
    folder = tmp_path / "records"
    folder.mkdir()
    return str(shutil.copy(kept, folder))


def test_replay_lists_tasks_and_failures(box: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", box]) == 0
    printed = capsys.readouterr().out
    assert "wait-0001 started" in printed
    assert "wait-0001 FAILED: GRASP_EMPTY: closed on nothing" in printed


def test_replay_shows_what_watch_and_why_showed(box: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", box, "--task", "wait-0001"]) == 0
    printed = capsys.readouterr().out
    assert "wait for the world" in printed
    assert "what was tried" in printed
    assert "GRASP_EMPTY: closed on nothing" in printed


def test_replay_before_the_task_shows_none(box: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", box, "--at", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["status"] is None


def test_log_info_says_why_it_was_kept(box: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["log", "info", box]) == 0
    printed = capsys.readouterr().out
    assert "kept because wait-0001 FAILED: GRASP_EMPTY" in printed
    assert "hw/clock" in printed


def test_log_cut_export_and_recover(box: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    part = str(tmp_path / "part.jsonl.gz")
    assert main(["log", "cut", box, "--task", "wait-0001", "-o", part]) == 0
    whole, cut = open_recording(Path(box)), open_recording(Path(part))
    ran = span_of(whole, "wait-0001")
    assert ran is not None
    around = Span(whole.span.clipped(ran.begin - 2.0), whole.span.clipped(ran.end + 2.0))
    assert cut.span == around
    assert main(["log", "cut", box, "--from", "1", "--to", "2"]) == 0
    capsys.readouterr()
    assert main(["log", "export", part, "--key", "task/*/status"]) == 0
    states = [json.loads(line)["message"]["state"] for line in capsys.readouterr().out.splitlines()]
    assert states[-1] == "FAILED"
    Path(part).write_bytes(Path(part).read_bytes()[:-100])
    assert main(["log", "info", part]) == 2
    assert f"tandem log recover {part}" in capsys.readouterr().err
    assert main(["log", "recover", part]) == 0
    assert main(["log", "info", str(tmp_path / "part.recovered.jsonl.gz")]) == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["log", "cut", "BOX"], "expected --task ID, or --from and --to"),
        (["log", "cut", "BOX", "--task", "fetch-9"], "no task 'fetch-9' in it"),
        (["replay", "BOX", "--task", "fetch-9"], "no task 'fetch-9' in it"),
        (["replay", "BOX", "--again"], "expected a run in lockstep"),
        (["replay", "none.mcap"], "No such file"),
        (["log", "recover", "none.mcap"], "No such file"),
    ],
)
def test_what_can_not_be_done_is_said(
    words: list[str], said: str, box: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([box if each == "BOX" else each for each in words]) == 2
    assert said in capsys.readouterr().err


def test_why_names_the_black_box_of_a_task(box: str, tmp_path: Path) -> None:
    failure = Failure(kind=FailureKind.GRASP_EMPTY, message="closed on nothing")
    status = TaskStatus(
        task="wait-0001", kind="wait", request={}, state=TaskState.FAILED, accepted_at=0.0, failure=failure
    )
    assert record_of(BusOptions(), tmp_path, status) == box
    assert record_of(BusOptions(), tmp_path, status.model_copy(update={"task": "other"})) == ""


def test_up_records_only_where_there_is_a_recorder(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["up", "--record", "--only", "executive"]) == 2
    assert "expected recorder among the roles of --only; found executive" in capsys.readouterr().err


def test_up_records_only_with_its_extra(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lacks = "a recording: mcap missing"
    monkeypatch.setattr(option_checks, "words_on", lambda extra, _: lacks if extra is RECORD else "")
    assert main(["up", "--record"]) == 2
    assert lacks in capsys.readouterr().err


def test_up_records_only_where_it_can_write(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").touch()
    assert main(["up", "--record", "--record-to", str(tmp_path / "file" / "below")]) == 2
    assert "Not a directory" in capsys.readouterr().err
