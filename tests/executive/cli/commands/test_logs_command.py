"""``tandem logs`` without a robot: the files that ``tandem up`` has left."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.cli.main import main
from tandem.executive.ledger.port import Entry
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.skills.ports.tasks import TaskState, TaskStatus

LINE = "2026-11-24T08:30:00.100Z INFO    base tandem.skills.server: goal begins task=fetch-1"
OTHER = "2026-11-24T08:30:00.200Z INFO    keeper tandem.skills.world: kept task=fetch-2"


@pytest.fixture
def data(tmp_path: Path) -> Path:
    (tmp_path / "logs").mkdir()
    (tmp_path / "logs" / "base.log").write_text(f"{LINE}\n")
    (tmp_path / "logs" / "keeper.log").write_text(f"{OTHER}\n")
    return tmp_path


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], [LINE, OTHER]),
        (["base"], [LINE]),
        (["fetch-2"], [OTHER]),
        (["-n", "1"], [OTHER]),
    ],
    ids=str,
)
def test_lines_are_those_of_a_process_or_of_a_task(
    words: list[str], said: list[str], data: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["logs", *words, "--data", str(data)]) == 0
    assert capfd.readouterr().out.splitlines() == said


def test_a_folder_without_logs_is_named(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["logs", "--data", str(tmp_path)]) == 2
    assert f"no logs in {tmp_path / 'logs'}" in capfd.readouterr().err


def test_what_no_log_knows_is_asked_of_the_robot(data: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["logs", "fetch-9", "--data", str(data), "--connect", "tcp/127.0.0.1:1"]) == 3
    assert "tandem up" in capfd.readouterr().err


def test_the_clients_id_of_a_request_finds_its_tasks_lines(
    data: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    ledger = SqliteLedger(data)
    status = TaskStatus(
        task="fetch-2", kind="fetch", request={}, state=TaskState.QUEUED, accepted_at=1.0, client_id="my-1"
    )
    ledger.enter(Entry(status, 1, "resume", test_run=False))
    ledger.commit()
    ledger.close()
    assert main(["logs", "my-1", "--data", str(data), "--connect", "tcp/127.0.0.1:1"]) == 0
    assert capfd.readouterr().out.splitlines() == [OTHER]


def test_the_default_folder_of_another_robot_is_refused(
    data: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    folder = data / "state" / "tandem" / "a-b-c"
    folder.mkdir(parents=True)
    (data / "logs").rename(folder / "logs")
    monkeypatch.setenv("XDG_STATE_HOME", str(data / "state"))
    kept = SqliteLedger(folder, robot="a/b-c")
    assert main(["logs", "--site-key", "a", "--robot", "b-c"]) == 0  # also while its executive runs
    assert main(["logs", "--site-key", "a-b", "--robot", "c"]) == 3
    assert "has the logs of a/b-c, not of a-b/c" in capfd.readouterr().err
    kept.close()
