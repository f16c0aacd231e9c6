"""What was known at a moment is looked up rather than walked to; also in a file that is still written."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from synthetic_record import FACTS, motion, one_fetch

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.mcap_growing import GrowingRecording
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.recording import MCAP, Attachment, Recorded, RecordError, open_recording
from tandem.executive.records.tape import Tape
from tandem.skills.ports.message import RobotTime

MOMENTS = (0.0, 0.3, 1.5, 2.02, 2.5, 3.99, 4.0)


def of_another_boot(message: Recorded) -> Recorded:
    assert message.stamp is not None
    stamp = RobotTime(boot="c", seconds=message.stamp.seconds)
    return Recorded(message.key, message.at + 10.0, stamp, message.host, message.payload)


class Written:
    """A recording under way, a chunk for each half second of two boots of the robot."""

    def __init__(self, path: Path) -> None:
        first = sorted([*motion(), *one_fetch()], key=lambda each: each.at)
        self.path, self.messages = path, [*first, *(of_another_boot(each) for each in first)]
        self.stream = path.open("wb")
        self.file = McapFile(self.stream, FACTS, 0.0, JsonSchemas().of)
        self.file.attach(Attachment("task/site", 0.0, b"{}"))
        self.done = 0

    def write(self, until: float) -> None:
        for number, each in enumerate(self.messages[self.done :], self.done):
            if each.at > until:
                break
            self.file.put(each)
            self.done = number + 1
            if number % 40 == 0:
                self.file.flush()
        self.file.flush()

    def known(self, at: float) -> list[Recorded]:
        last: dict[str, Recorded] = {}
        for each in self.messages[: self.done]:
            if each.at <= at:
                last.pop(each.key, None)
                last[each.key] = each
        return list(last.values())


@pytest.fixture
def written(tmp_path: Path) -> Iterator[Written]:
    made = Written(tmp_path / "run.mcap")
    yield made
    made.stream.close()


def test_what_was_known_is_read_while_the_file_grows(written: Written) -> None:
    written.write(2.0)
    record = GrowingRecording(written.path)
    assert (record.facts, record.span.end) == (FACTS, 2.0)
    for until in (3.0, 12.5, 14.0):
        written.write(until)
        record.grow()
        assert record.span.end == until
        for at in (*MOMENTS, 10.5, 12.02, until):
            assert list(record.known(at).values()) == written.known(at)
    assert [(each.boot, each.begin, each.end, each.offset) for each in record.boots()] == [
        ("b", 0.0, 4.0, 0.0),
        ("c", 0.0, 4.0, 10.0),
    ]
    assert [each.name for each in record.attachments] == ["task/site"]
    record.close()


def test_a_file_at_its_end_says_the_same(written: Written) -> None:
    written.write(14.0)
    written.file.finish()
    growing, whole = GrowingRecording(written.path), open_recording(written.path)
    assert (growing.span, growing.boots()) == (whole.span, whole.boots())
    for at in (*MOMENTS, 11.0):
        assert list(whole.known(at).values()) == list(growing.known(at).values()) == written.known(at)
    assert growing.attachments == whole.attachments
    growing.close()
    whole.close()


def test_a_tape_that_skips_knows_what_one_knows_that_walks(written: Written) -> None:
    written.write(14.0)
    written.file.finish()
    record = open_recording(written.path)
    skips, walks = Tape(record), Tape(record)
    skips.go(13.0)
    for _ in walks.walk(13.0):
        pass
    assert list(skips.known().last.items()) == list(walks.known().last.items())
    assert list(skips.walk(14.0)) == list(walks.walk(14.0))
    record.close()


@pytest.mark.parametrize("size", [0, 8, 20, 100])
def test_a_file_without_its_first_records_is_refused(written: Written, tmp_path: Path, size: int) -> None:
    written.write(1.0)
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(written.path.read_bytes()[:size])
    with pytest.raises(RecordError, match=r"cut\.mcap"):
        GrowingRecording(cut)


@pytest.mark.parametrize("less", [1, 7, 50, 333, 1000])
def test_a_record_that_is_half_written_is_not_read_yet(written: Written, tmp_path: Path, less: int) -> None:
    written.write(4.0)
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(written.path.read_bytes()[:-less])
    record = GrowingRecording(cut)
    read = list(record.messages())
    assert read == written.messages[: len(read)]
    assert len(read) > 100
    record.close()


@pytest.mark.parametrize("place", [0.02, 0.3, 0.6, 0.9, 0.97, 0.99])
def test_a_changed_byte_is_told_or_harmless(written: Written, tmp_path: Path, place: float) -> None:
    written.write(14.0)
    written.file.finish()
    data = bytearray(written.path.read_bytes())
    data[int(len(data) * place)] ^= 0xFF
    changed = tmp_path / "changed.mcap"
    changed.write_bytes(data)
    for opened in (open_recording, GrowingRecording):
        try:
            record = opened(changed)
        except RecordError:
            continue
        with suppress(RecordError):
            assert list(record.messages()) == written.messages
        record.close()


def test_a_file_of_two_ends_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "short.mcap"
    path.write_bytes(MCAP * 2)
    with pytest.raises(RecordError, match=r"short\.mcap"):
        open_recording(path)
