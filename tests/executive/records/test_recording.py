"""Both kinds of file give back what was written, and what is no record of ours is refused in words."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.recording import (
    LAYOUT,
    Attachment,
    Facts,
    Recorded,
    RecordError,
    Span,
    open_recording,
)
from tandem.executive.records.recovering import recover, recovered_name
from tandem.skills.ports.message import RobotTime

FACTS = Facts(site="lab", robot="tiago", scenario="Demo", seed=3, release="0.1.0", began=7.5)
ATTACHMENT = Attachment("hw/description", 0.0, b'{"name": "tiago"}')


def heard(at: float, boot: str = "a", key: str = "hw/clock", payload: bytes = b"{}") -> Recorded:
    """Return a message of a robot whose second boot begins at ``at`` 2.0."""
    seconds = at if boot == "a" else round(at - 2.0, 9)
    return Recorded(key, at, RobotTime(boot=boot, seconds=seconds), 10**18 + round(at * 1e9), payload)


MESSAGES = (
    Recorded("task/status", 0.0, None, 5, b'{"task": "\xc3\xa4"}'),
    *(heard(each / 50) for each in range(100)),
    Recorded("odd", 1.98, RobotTime(boot="a", seconds=1.98), 11, b"\xff\x00", "bytes"),
    *(heard(round(2.0 + each / 50, 9), "b", "tree/snapshot") for each in range(50)),
)


def lines(folder: Path) -> Path:
    path = folder / "box.jsonl.gz"
    write_lines(path, FACTS, Span(0.0, 2.98), (ATTACHMENT,), MESSAGES)
    return path


def mcap(folder: Path) -> Path:
    path = folder / "run.mcap"
    with path.open("wb") as file:
        made = McapFile(file, FACTS, 0.0, JsonSchemas().of)
        made.attach(ATTACHMENT)
        for number, message in enumerate(MESSAGES):
            made.put(message)
            if number % 20 == 0:
                made.flush()
        made.finish()
    return path


both = pytest.mark.parametrize("written", [lines, mcap])
Written = Callable[[Path], Path]


@both
def test_what_was_written_is_read_back(written: Written, tmp_path: Path) -> None:
    record = open_recording(written(tmp_path))
    assert tuple(record.messages()) == MESSAGES
    assert record.attachments == (ATTACHMENT,)
    assert record.facts == FACTS
    assert record.span == Span(0.0, 2.98)
    record.close()


@both
def test_only_what_lies_between_two_moments(written: Written, tmp_path: Path) -> None:
    record = open_recording(written(tmp_path))
    found = tuple(record.messages(1.5, 2.1))
    assert found == tuple(each for each in MESSAGES if 1.5 <= each.at <= 2.1)
    record.close()


@both
def test_a_cut_file_is_refused_and_recovered(written: Written, tmp_path: Path) -> None:
    path = written(tmp_path)
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 6 // 10])
    with pytest.raises(RecordError, match=f"tandem log recover {path}"):
        open_recording(path)
    mended = recovered_name(path)
    assert recover(path, mended) > 0
    found = tuple(open_recording(mended).messages())
    assert found == MESSAGES[: len(found)]


def foreign(folder: Path) -> Path:
    path = folder / "notes.txt"
    path.write_text("hello")
    return path


def empty(folder: Path) -> Path:
    path = folder / "empty.mcap"
    path.touch()
    return path


def other_gzip(folder: Path) -> Path:
    path = folder / "other.gz"
    path.write_bytes(gzip.compress(b"some text\n"))
    return path


def newer_lines(folder: Path) -> Path:
    path = folder / "newer.jsonl.gz"
    head = {"tandem": "record", "layout": LAYOUT + 1, "facts": {"release": "9.0"}, "span": [0, 1]}
    path.write_bytes(gzip.compress(json.dumps(head).encode() + b"\n"))
    return path


def _foreign_mcap(folder: Path, metadata: dict[str, str] | None) -> Path:
    from mcap.writer import Writer  # noqa: PLC0415

    path = folder / "foreign.mcap"
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start()
        if metadata is not None:
            writer.add_metadata("tandem", metadata)
        writer.finish()
    return path


def other_mcap(folder: Path) -> Path:
    return _foreign_mcap(folder, None)


def folder_of_two_robots(folder: Path) -> Path:
    for name in ("r2/a.mcap", "r3/b.mcap"):
        (folder / name).parent.mkdir()
        (folder / name).touch()
    return folder


def newer_mcap(folder: Path) -> Path:
    return _foreign_mcap(folder, {"layout": str(LAYOUT + 1), "facts": '{"release": "9.0"}', "begin": "0"})


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (foreign, "expected a record of Tandem .*; found another kind of file"),
        (empty, "found an empty file"),
        (other_gzip, "found no record of Tandem"),
        (other_mcap, "found no record of Tandem"),
        (newer_lines, f"expected layout {LAYOUT} or older; found layout {LAYOUT + 1}, of release 9.0"),
        (newer_mcap, f"expected layout {LAYOUT} or older; found layout {LAYOUT + 1}, of release 9.0"),
        (lambda folder: folder / "absent.mcap", "No such file"),
        (lambda folder: folder, "found a folder without any"),
        (folder_of_two_robots, "found a folder with r3/b.mcap, r2/a.mcap; name one of its files"),
    ],
)
def test_what_is_no_record_is_refused(made: Written, words: str, tmp_path: Path) -> None:
    with pytest.raises(RecordError, match=words):
        open_recording(made(tmp_path))


def test_no_field_of_a_later_release_hinders(tmp_path: Path) -> None:
    """Within one layout, facts may gain fields."""
    path = tmp_path / "later.jsonl.gz"
    facts = {**FACTS.model_dump(mode="json"), "weather": "fine"}
    head = {"tandem": "record", "layout": LAYOUT, "facts": facts, "span": [0, 1]}
    path.write_bytes(gzip.compress(json.dumps(head).encode() + b'\n{"end": 0}\n'))
    assert open_recording(path).facts == FACTS


def test_a_target_that_is_there_is_not_written_over(tmp_path: Path) -> None:
    path = lines(tmp_path)
    with pytest.raises(RecordError, match="expected no such file yet"):
        recover(path, path)
