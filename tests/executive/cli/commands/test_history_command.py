"""``tandem tasks``, ``why`` and ``export`` when no executive runs: the ledger's file is read."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tandem.executive.cli.commands.history_command import moment
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.main import main
from tandem.executive.config.run_options import BusOptions, default_data
from tandem.executive.ledger.port import Entry
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import Attempt, Progress, TaskState, TaskStatus
from tests.fakes.ports import free_endpoint


@pytest.fixture
def nobody(tmp_path: Path) -> list[str]:
    """Return the options that lead to a file with three tasks, where no executive runs."""
    ledger = SqliteLedger(tmp_path)
    failure = Failure(kind=FailureKind.GRASP_EMPTY, message="closed on nothing")
    for number, state in ((1, TaskState.SUCCEEDED), (2, TaskState.FAILED), (3, TaskState.QUEUED)):
        status = TaskStatus(
            task=f"fetch-{number}",
            kind="fetch",
            request={"task": "fetch", "item": 29},
            state=state,
            accepted_at=1_800_000_000.0 + 100 * number,
            failure=failure if state is TaskState.FAILED else None,
        )
        ledger.enter(Entry(status, number))
    ledger.commit()
    ledger.close()
    return ["--connect", free_endpoint(), "--data", str(tmp_path)]


def listed(capfd: pytest.CaptureFixture[str], *argv: str) -> list[str]:
    assert main([*argv]) == 0
    return [status["task"] for status in json.loads(capfd.readouterr().out)["tasks"]]


def test_tasks_are_read_from_the_file(nobody: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    assert listed(capfd, "tasks", "--json", *nobody) == ["fetch-1", "fetch-2", "fetch-3"]
    assert listed(capfd, "tasks", "--json", "--state", "failed", *nobody) == ["fetch-2"]
    since = "2027-01-15T08:03:20"  # 1_800_000_200
    assert listed(capfd, "tasks", "--json", "--all", "--since", since, *nobody) == ["fetch-2", "fetch-3"]


def test_of_several_robots_each_has_a_folder_of_its_own(
    tmp_path: Path, nobody: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    ledger = SqliteLedger(tmp_path / "r2")
    status = TaskStatus(
        task="nod-1", kind="nod", request={}, state=TaskState.SUCCEEDED, accepted_at=1_800_000_000.0
    )
    ledger.enter(Entry(status, 1))
    ledger.commit()
    ledger.close()
    assert listed(capfd, "tasks", "--json", *nobody, "--robot", "r2") == ["nod-1"]
    assert listed(capfd, "tasks", "--json", *nobody) == ["fetch-1", "fetch-2", "fetch-3"]


def test_a_default_folder_with_another_robots_tasks_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    options = BusOptions(endpoint=free_endpoint(), site="a-b", robot="c")
    folder = default_data(options, os.environ)
    folder.mkdir(parents=True)
    SqliteLedger(folder, robot="a/b-c").close()
    assert main(["tasks", "--connect", options.endpoint, "--site-key", "a-b", "--robot", "c"]) == 3
    assert "has the tasks of a/b-c" in capfd.readouterr().err


def test_why_and_export_read_it_too(nobody: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["why", "fetch-2", *nobody]) == 0
    assert "GRASP_EMPTY: closed on nothing" in capfd.readouterr().out
    assert main(["why", "fetch-9", *nobody]) == 2
    assert "--all" in capfd.readouterr().err
    assert main(["export", *nobody]) == 0
    lines = capfd.readouterr().out.splitlines()
    assert [TaskStatus.model_validate_json(line).task for line in lines] == ["fetch-1", "fetch-2", "fetch-3"]


def test_without_a_file_it_is_said_where_it_was_looked_for(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["tasks", "--connect", free_endpoint(), "--data", str(tmp_path / "none")]) == 3
    said = capfd.readouterr().err
    assert "no router answers" in said
    assert f"no ledger found in {tmp_path / 'none'}" in said
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize("argv", [["--state", "DONE"], ["--since", "yesterday"]])
def test_what_can_not_be_meant_is_told(
    argv: list[str], nobody: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["tasks", *argv, *nobody]) == 2
    assert "; found" in capfd.readouterr().err


def test_moments() -> None:
    assert moment("") == 0.0
    assert moment("2027-01-15T08:00:00+00:00") == moment("2027-01-15T08:00") == 1_800_000_000.0
    assert moment("1h") < moment("30m")
    with pytest.raises(CommandError):
        moment("7 days")


def test_why_tells_offline_where_the_picture_is_and_ends_well(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """From outside it would take a fetch that fails in front of the camera."""
    ledger = SqliteLedger(tmp_path)
    failure = Failure(kind=FailureKind.GRASP_EMPTY, message="closed on nothing")
    moment_of_it = RobotTime(boot="a", seconds=20.0)
    status = TaskStatus(
        task="fetch-1",
        kind="fetch",
        request={"task": "fetch", "item": 29},
        state=TaskState.FAILED,
        accepted_at=1_800_000_000.0,
        failure=failure,
        tried=(Attempt(at=moment_of_it, failure=failure, recovery="draw back", times=1, picture="7"),),
    )
    ledger.enter(Entry(status, 1))
    ledger.commit()
    ledger.close()
    where = ["--connect", free_endpoint(), "--data", str(tmp_path)]
    assert main(["why", "fetch-1", *where]) == 0
    assert "tandem why fetch-1 --picture FILE" in capfd.readouterr().out
    assert main(["why", "fetch-1", "--picture", str(tmp_path / "picture.jpg"), *where]) == 3


@pytest.mark.parametrize("width", [20, 80])
def test_an_id_is_never_cut_off(
    width: int,
    nobody: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    ledger = SqliteLedger(tmp_path)
    task = "pick_both_hands-k7f3q2m9x1-000000000042"
    phases = Progress(phase="a phase with many words in its name", fraction=0.5)
    status = TaskStatus(
        task=task,
        kind="fetch",
        request={"task": "fetch", "item": 29, "to": "x" * 60},
        state=TaskState.QUEUED,
        progress=phases,
        accepted_at=1_800_000_900.0,
    )
    ledger.enter(Entry(status, 4))
    ledger.commit()
    ledger.close()
    monkeypatch.setenv("COLUMNS", str(width))
    for terminal in ("1", ""):
        monkeypatch.setenv("FORCE_COLOR", terminal)  # rich takes it for a terminal
        assert main(["tasks", *nobody]) == 0
        out = capfd.readouterr().out
        assert task in out
        assert "\u2026" not in out
        if not terminal:
            assert len(out.splitlines()) == 5, "a head, and a line for each task"
