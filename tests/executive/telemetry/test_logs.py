"""Logs: a line for people or a line of JSON, with the task that it is about."""

from __future__ import annotations

import json
import logging
import sys
from pathlib import Path

import pytest
from surroundings import Surroundings

from tandem.executive.telemetry.log_files import UserLog, trim
from tandem.executive.telemetry.logs import formatter
from tandem.executive.telemetry.relay import LogRelay

AT = 1_790_000_000.25


def record(**about: object) -> logging.LogRecord:
    made = logging.LogRecord(
        "tandem.skills.server", logging.INFO, "server.py", 1, "goal %s", ("ended",), None
    )
    made.created = AT
    for name, value in about.items():
        setattr(made, name, value)
    return made


def test_a_line_of_json_has_time_role_event_and_task() -> None:
    line = formatter("json", "base").format(record(task="fetch-0001", state="FAILED", kind=""))
    assert json.loads(line) == {
        "time": "2026-09-21T14:13:20.250Z",
        "level": "info",
        "role": "base",
        "logger": "tandem.skills.server",
        "event": "goal ended",
        "task": "fetch-0001",
        "state": "FAILED",
    }


def test_a_line_for_people_says_the_same() -> None:
    line = formatter("text", "base").format(record(task="fetch-0001"))
    assert line == "2026-09-21T14:13:20.250Z INFO    base tandem.skills.server: goal ended task=fetch-0001"


@pytest.mark.parametrize(("which", "lines"), [("json", 1), ("text", 4)])
def test_a_trace_of_the_stack_is_kept_together(which: str, lines: int) -> None:
    made = record()
    try:
        int("a mistake")
    except ValueError:
        made.exc_info = sys.exc_info()
    text = formatter("json" if which == "json" else "text", "base").format(made)
    assert "ValueError: invalid literal" in text
    assert len(text.splitlines()) >= lines
    assert which == "text" or "ValueError" in json.loads(text)["trace"]


def test_a_tasks_changes_are_logged_with_its_id(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, logger="tandem.executive.service.tasks.task_log")
    here = Surroundings()
    here.ask({"task": "wait", "item": 1})
    here.world(2)
    here.step(3)
    told = [
        (vars(each)["task"], vars(each)["state"], vars(each).get("kind", ""))
        for each in caplog.records
        if each.name == "tandem.executive.service.tasks.task_log"
    ]
    assert told == [
        ("wait-0001", "QUEUED", ""),
        ("wait-0001", "RUNNING", ""),
        ("wait-0001", "FAILED", "GRASP_EMPTY"),
    ]


def test_logs_of_processes_come_together_line_by_line(tmp_path: Path) -> None:
    told: list[str] = []
    relay = LogRelay(lambda: tmp_path.glob("*.log"), (told.append,))
    base, keeper = tmp_path / "base.log", tmp_path / "keeper.log"
    base.write_text("one\ntw")
    relay.step()
    keeper.write_text("three\n")
    relay.step()
    with base.open("a") as more:
        more.write("o\nlast")
    relay.step()
    assert told == ["one", "three", "two"]
    relay.step(last=True)
    assert told[3:] == ["last"]


def test_what_a_library_prints_becomes_json_too(tmp_path: Path) -> None:
    told: list[str] = []
    (tmp_path / "hardware.log").write_text('pybullet build time: May\n\n{"event": "goal ended"}\n')
    LogRelay(lambda: tmp_path.glob("*.log"), (told.append,), "json").step()
    printed, logged = map(json.loads, told)
    assert (printed["role"], printed["event"]) == ("hardware", "pybullet build time: May")
    assert logged == {"event": "goal ended"}


def test_a_log_that_has_grown_too_large_begins_anew_while_its_process_writes_on(tmp_path: Path) -> None:
    told: list[str] = []
    relay, log = LogRelay(lambda: tmp_path.glob("*.log"), (told.append,)), tmp_path / "base.log"
    with log.open("ab", buffering=0) as stream:
        stream.write(b"first\n" * 20)
        relay.step()
        assert trim(log, limit=100)
        stream.write(b"second\n")
        relay.step()
    assert log.read_text() == "second\n"
    assert (tmp_path / "base.log.1").read_text() == "first\n" * 20
    assert told == ["first"] * 20 + ["second"]


def test_a_log_that_is_short_stays_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "base.log").write_text("first\n")
    assert not trim(tmp_path / "base.log", limit=100)


def test_the_users_log_keeps_the_newest_lines_in_a_bounded_number_of_files(tmp_path: Path) -> None:
    log = UserLog(tmp_path / "logs" / "tandem.log", limit=1000)
    for number in range(2000):
        log.write(f"line {number}")
    log.close()
    files = sorted(each.name for each in (tmp_path / "logs").iterdir())
    assert files == ["tandem.log", *(f"tandem.log.{number}" for number in range(1, 5))]
    assert all(each.stat().st_size <= 1000 for each in (tmp_path / "logs").iterdir())
    assert (tmp_path / "logs" / "tandem.log").read_text().splitlines()[-1] == "line 1999"
