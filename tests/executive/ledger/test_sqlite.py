"""The ledger's file, where things go wrong: crashes, other owners, full and read-only disks, other files."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from tandem.executive.ledger.port import Entry, LedgerError, LedgerLockedError, Reading
from tandem.executive.ledger.schema import MIGRATIONS, VERSION
from tandem.executive.ledger.sqlite import FILE, SqliteLedger
from tandem.skills.ports.tasks import AskHistory, TaskState, TaskStatus


def entry(number: int, words: str = "") -> Entry:
    status = TaskStatus(
        task=f"wait-{number}", kind="wait", request={"words": words}, state=TaskState.QUEUED, accepted_at=1.0
    )
    return Entry(status, number)


def there(folder: Path) -> list[str]:
    ledger = SqliteLedger(folder)
    try:
        return [each.status.task for each in ledger.open_entries()]
    finally:
        ledger.close()


def test_it_is_written_as_it_must_be_to_survive_a_power_cut(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    asked = {
        name: ledger._db.execute(f"PRAGMA {name}").fetchone()[0] for name in ("journal_mode", "synchronous")
    }
    assert asked == {"journal_mode": "wal", "synchronous": 2}
    ledger.close()


def test_what_was_not_committed_is_gone_with_the_process(tmp_path: Path) -> None:
    code = f"""
import os, sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
from pathlib import Path
from test_sqlite import SqliteLedger, entry
ledger = SqliteLedger(Path({str(tmp_path)!r}))
ledger.enter(entry(1))
ledger.commit()
ledger.enter(entry(2))
os.kill(os.getpid(), 9)
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=Path(__file__).parents[3], check=False)
    assert done.returncode == -9
    assert there(tmp_path) == ["wait-1"]


def test_a_file_cut_off_in_the_middle_of_its_last_write_is_read_up_to_there(tmp_path: Path) -> None:
    """As after a power cut: the write-ahead log ends in the middle of a page."""
    ledger, copy = SqliteLedger(tmp_path / "one"), tmp_path / "two"
    for number in range(1, 4):
        ledger.enter(entry(number, "x" * 6000))
        ledger.commit()
    copy.mkdir()
    (copy / FILE).write_bytes(ledger.path.read_bytes())
    log = ledger.path.with_name(f"{FILE}-wal").read_bytes()
    (copy / f"{FILE}-wal").write_bytes(log[:-3000])
    ledger.close()
    assert there(copy) == ["wait-1", "wait-2"]


def test_a_second_owner_is_refused(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    with pytest.raises(LedgerLockedError, match="another executive has this ledger"):
        SqliteLedger(tmp_path)
    ledger.close()
    assert there(tmp_path) == []


def test_a_full_disk_loses_nothing_that_was_committed(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    ledger.enter(entry(1))
    ledger.commit()
    (pages,) = ledger._db.execute("PRAGMA page_count").fetchone()
    ledger._db.execute(f"PRAGMA max_page_count = {pages}")
    ledger.enter(entry(2))
    with pytest.raises(LedgerError, match="the disk is full"):
        ledger.enter(entry(3, "x" * 100_000))
    assert [each.number for each in ledger.open_entries()] == [1], "what was not committed is taken back"
    ledger._db.execute("PRAGMA max_page_count = 100000")
    ledger.enter(entry(2))
    ledger.commit()
    ledger.close()
    assert there(tmp_path) == ["wait-1", "wait-2"]


def test_a_disk_that_can_not_be_written_is_told(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    ledger._db.execute("PRAGMA query_only = 1")
    with pytest.raises(LedgerError, match="cannot write the file"):
        ledger.enter(entry(1))
    ledger.close()


def test_a_folder_that_is_none_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(LedgerError, match="choose another one with --data"):
        SqliteLedger(tmp_path / "file")


@pytest.mark.parametrize(
    "content", [b"something else entirely, and long enough to be a file" * 40, b"\0" * 9000]
)
def test_a_file_that_is_no_ledger_is_left_as_it_is(tmp_path: Path, content: bytes) -> None:
    (tmp_path / FILE).write_bytes(content)
    with pytest.raises(LedgerError, match="left as it is"):
        SqliteLedger(tmp_path)
    assert (tmp_path / FILE).read_bytes() == content


def test_a_damaged_file_is_told_and_not_overwritten(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    for number in range(1, 40):
        ledger.enter(entry(number, "x" * 500))
    ledger.commit()
    ledger.close()
    whole = (tmp_path / FILE).read_bytes()
    damaged = whole[:4096] + bytes(len(whole) - 4096)
    (tmp_path / FILE).write_bytes(damaged)
    with pytest.raises(LedgerError, match="damaged"):
        there(tmp_path)
    assert len((tmp_path / FILE).read_bytes()) == len(whole)


def test_a_file_of_a_newer_version_is_left_as_it_is(tmp_path: Path) -> None:
    SqliteLedger(tmp_path, (*MIGRATIONS, ("CREATE TABLE of_tomorrow (a INTEGER)",))).close()
    before = (tmp_path / FILE).read_bytes()
    with pytest.raises(
        LedgerError, match=f"version {VERSION + 1}, but this program supports versions up to {VERSION}"
    ):
        SqliteLedger(tmp_path)
    assert (tmp_path / FILE).read_bytes() == before


def test_a_file_of_an_older_version_is_brought_up_with_all_that_is_in_it(tmp_path: Path) -> None:
    ledger = SqliteLedger(tmp_path)
    ledger.enter(entry(1))
    ledger.commit()
    ledger.close()
    newer = (*MIGRATIONS, ("ALTER TABLE tasks ADD COLUMN note TEXT NOT NULL DEFAULT ''",))
    ledger = SqliteLedger(tmp_path, newer)
    assert [each.number for each in ledger.open_entries()] == [1]
    assert ledger._db.execute("PRAGMA user_version").fetchone() == (VERSION + 1,)
    ledger.close()


def test_a_file_of_the_first_version_knows_the_time_of_its_last_entry(tmp_path: Path) -> None:
    folder = tmp_path
    with sqlite3.connect(folder / FILE) as file:
        for statement in MIGRATIONS[0]:
            file.execute(statement)
        file.execute("PRAGMA user_version = 1")
        file.execute(
            "INSERT INTO transitions (task, state, at) VALUES ('a', 'QUEUED', 5.0), ('a', 'RUNNING', 7.0)"
        )
    file.close()
    ledger = SqliteLedger(folder)
    assert ledger.reading() == Reading(utc=7.0, host="", monotonic=0.0)
    ledger.close()


def test_another_robot_does_not_take_up_its_tasks(tmp_path: Path) -> None:
    folder = tmp_path / "a-b-c"  # where both the robot c of the site a-b and b-c of a would look
    SqliteLedger(folder, robot="a-b/c").close()
    SqliteLedger(folder, robot="a-b/c").close()
    SqliteLedger(folder).close()  # to read, whosever it is
    with pytest.raises(
        LedgerError, match=r"tasks of a-b/c, and a/b-c must not take them up; choose another --data"
    ):
        SqliteLedger(folder, robot="a/b-c")


def test_a_migration_that_fails_changes_nothing(tmp_path: Path) -> None:
    SqliteLedger(tmp_path).close()
    with pytest.raises(LedgerError):
        SqliteLedger(tmp_path, (*MIGRATIONS, ("CREATE TABLE more (a INTEGER)", "nonsense")))
    with sqlite3.connect(tmp_path / FILE) as file:
        tables = {name for (name,) in file.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    file.close()
    assert "more" not in tables


NEWER: dict[str, str] = {
    "status": "UPDATE tasks SET status = json_patch(status, ?)",
    "memory": "UPDATE tasks SET memory = json_patch(memory, ?)",
}


def written_by_a_newer_version(folder: Path, column: str, state: TaskState, added: str) -> SqliteLedger:
    """Return a ledger with one task, one of whose documents has what a version to come adds to it."""
    ledger = SqliteLedger(folder)
    ledger.enter(Entry(entry(1).status.model_copy(update={"state": state}), 1))
    ledger.commit()
    ledger._db.execute(NEWER[column], (added,))
    return ledger


@pytest.mark.parametrize(
    ("column", "added", "words"),
    [
        ("status", '{"new": 1}', "new: expected no such field, found 1"),
        ("status", '{"state": "ASLEEP"}', 'state: expected .*, found "ASLEEP"'),
        ("memory", '{"new": 1}', "new: expected no such field, found 1"),
    ],
)
def test_a_task_that_goes_on_is_refused_when_not_all_of_it_is_understood(
    tmp_path: Path, column: str, added: str, words: str
) -> None:
    ledger = written_by_a_newer_version(tmp_path, column, TaskState.RUNNING, added)
    with pytest.raises(LedgerError, match=f"its task 1: {words}.*; nothing was changed"):
        ledger.open_entries()
    ledger.close()


@pytest.mark.parametrize("added", ['{"new": 1}', '{"failure": {"kind": "NEW"}}', '{"result": "a text"}'])
def test_a_task_that_has_ended_is_shown_without_what_is_not_understood(tmp_path: Path, added: str) -> None:
    ledger = written_by_a_newer_version(tmp_path, "status", TaskState.FAILED, added)
    assert [each.task for each in ledger.history(AskHistory()).tasks] == ["wait-1"]
    ledger.close()
