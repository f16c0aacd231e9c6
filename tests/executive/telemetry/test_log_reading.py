"""Logs read back: by role, by task, in the order of their times, and as they grow."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.telemetry.log_reading import LogFolder, LogLine, parsed, roles_in

BASE = (
    "2026-11-24T08:30:00.100Z INFO    base tandem.skills.server: goal begins task=fetch-1 action=base/drive\n"
    "2026-11-24T08:30:02.000Z ERROR   base tandem.skills.server: a bug task=fetch-2\n"
    "Traceback (most recent call last):\n"
)
KEEPER = "2026-11-24T08:30:01.000Z INFO    keeper tandem.skills.world: kept task=fetch-1\n"
JSON = '{"time": "2026-11-24T08:30:03.000Z", "level": "info", "event": "goal ended", "task": "fetch-1"}\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "base.log").write_text(BASE)
    (tmp_path / "keeper.log").write_text(KEEPER)
    return tmp_path


def everything(_: LogLine) -> bool:
    return True


@pytest.mark.parametrize(
    ("text", "time", "level", "task"),
    [
        (BASE.splitlines()[0], "2026-11-24T08:30:00.100Z", "info", "fetch-1"),
        (JSON.strip(), "2026-11-24T08:30:03.000Z", "info", "fetch-1"),
        ("pybullet build time: May", "", "", ""),
        ('{"broken', "", "", ""),
    ],
)
def test_a_line_is_read_as_text_and_as_json(text: str, time: str, level: str, task: str) -> None:
    assert parsed("base", text) == LogLine(time=time, level=level, role="base", task=task, text=text)


def test_lines_of_all_roles_come_in_the_order_of_their_times(folder: Path) -> None:
    found = LogFolder(folder, everything).first(10)
    assert [(line.role, line.time[17:19]) for line in found] == [
        ("base", "00"),
        ("keeper", "01"),
        ("base", "02"),
        ("base", ""),
    ]
    assert roles_in(folder) == ("base", "keeper")


@pytest.mark.parametrize(("task", "lines"), [("fetch-1", 2), ("fetch-2", 2), ("fetch-3", 0)])
def test_a_trace_belongs_to_the_line_above_it(task: str, lines: int, folder: Path) -> None:
    assert len(LogFolder(folder, lambda line: line.task == task).first(10)) == lines


def test_only_the_last_lines_are_told_and_then_what_is_new(folder: Path) -> None:
    found = LogFolder(folder, everything)
    assert len(found.first(1)) == 1
    assert found.more() == []
    with (folder / "base.log").open("a") as log:
        log.write(JSON + "half a li")
    assert [line.text for line in found.more()] == [JSON.strip()]


def test_what_an_earlier_run_has_logged_comes_first(folder: Path) -> None:
    (folder / "base.log.1").write_text(BASE.replace("T08", "T07"))
    assert LogFolder(folder, everything).first(100)[0].time.startswith("2026-11-24T07")


def test_a_log_that_was_begun_anew_is_read_from_its_start(folder: Path) -> None:
    found = LogFolder(folder, everything)
    found.first(0)
    (folder / "keeper.log").write_text("anew\n")
    assert [line.text for line in found.more()] == ["anew"]
