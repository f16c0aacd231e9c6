"""``tandem log export --lerobot``: what it prints, and what it refuses with words."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from synthetic_record import FACTS, motion, one_fetch, status, write_mcap

from tandem.executive.cli.commands import lerobot_export
from tandem.executive.cli.main import main
from tandem.executive.config.extras import Extra
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import Span
from tandem.skills.ports.tasks import TaskState


@pytest.fixture
def record(tmp_path: Path) -> Path:
    """Return a black box with one task, and one that was never started."""
    queued = status(0.5, "fetch-0002", state=TaskState.QUEUED)
    messages = sorted([*motion(), *one_fetch(), queued], key=lambda each: each.at)
    path = tmp_path / "box.jsonl.gz"
    write_lines(path, FACTS, Span(0.0, 4.0), [], messages)
    return path


def test_it_says_what_is_in_the_set_and_what_is_not(
    record: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "set"
    target.mkdir()  # an empty folder is taken
    assert main(["log", "export", str(record), "--lerobot", str(target), "--fps", "5"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"{target}: 1 episodes, 11 frames at 5 a second, no pictures",
        f"  left out: {record}: fetch-0002: it did not start in the record",
    ]


def _full(folder: Path, record: Path) -> list[str]:
    (folder / "set").mkdir()
    (folder / "set" / "mine.txt").write_text("kept", "utf-8")
    return [str(record)]


def _cut(folder: Path, _: Path) -> list[str]:
    path = write_mcap(folder / "cut.mcap", [*motion(), *one_fetch()])
    path.write_bytes(path.read_bytes()[:-400])
    return [str(path)]


def _empty(folder: Path, _: Path) -> list[str]:
    (folder / "none").mkdir()
    return [str(folder / "none")]


REFUSED: dict[str, tuple[Callable[[Path, Path], list[str]], str]] = {
    "a folder with something in it": (_full, "expected a folder that is new or empty; found one with"),
    "a record that was cut": (_cut, "tandem log recover"),
    "no record": (lambda folder, _: [str(folder / "none.mcap")], "none.mcap: expected a record"),
    "an empty folder": (_empty, "expected records (.mcap or .jsonl.gz) in the folder; found none"),
    "a camera that was not recorded": (
        lambda _, record: [str(record), "--camera", "head"],
        "expected pictures of head while fetch-0001 ran; found no pictures",
    ),
    "both": (lambda _, record: [str(record), "--camera", "head", "--no-pictures"], "found both"),
    "a key": (lambda _, record: [str(record), "--key", "hw/**"], "has no --key"),
}


@pytest.mark.parametrize(("arguments", "words"), REFUSED.values(), ids=REFUSED.keys())
def test_what_can_not_be_one_is_refused_with_words(
    record: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: Callable[[Path, Path], list[str]],
    words: str,
) -> None:
    given = arguments(tmp_path, record)
    assert main(["log", "export", *given, "--lerobot", str(tmp_path / "set")]) == 2
    assert words in capsys.readouterr().err
    assert not list(tmp_path.glob("set/meta"))
    assert not list(tmp_path.glob(".*.part"))


@pytest.mark.parametrize(
    ("given", "words"), [(["--no-pictures"], "go with --lerobot"), (["b.mcap"], "expected one record")]
)
def test_options_of_a_data_set_alone_are_refused(
    record: Path, capsys: pytest.CaptureFixture[str], given: list[str], words: str
) -> None:
    assert main(["log", "export", str(record), *given]) == 2
    assert words in capsys.readouterr().err


def test_a_missing_extra_is_named(
    record: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    lacks = Extra("lerobot", "data sets", (("pyarrow", "no_such_module", "tables"),))
    monkeypatch.setattr(lerobot_export, "LEROBOT", lacks)
    assert main(["log", "export", str(record), "--lerobot", str(tmp_path / "set")]) == 2
    assert "pyarrow missing; install with pip install 'tandem-executive[lerobot]'" in capsys.readouterr().err
