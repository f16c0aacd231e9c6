"""Which files go first, whatever the wall clock did between two starts."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.records.boxes import Boxes
from tandem.executive.records.dated import began_of, oldest_first, stamp_of
from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.recording import Facts, Recorded, Span
from tandem.executive.records.recording_sink import Bounds, RecordingSink
from tandem.skills.wire.clocks import SteppedClocks

DAY = 86_400.0
NOW = 1_800_000_000.0
YEAR = 365 * DAY
FACTS = Facts(site="lab", robot="tiago", release="0.1.0", began=NOW)


def files(*days_ago: float) -> list[Path]:
    return [Path(f"{stamp_of(NOW - days * DAY)}.mcap") for days in days_ago]


@pytest.mark.parametrize(
    ("days_ago", "ages"),
    [
        ((3, 1, 2), [3, 2, 1]),
        ((40, 1), [1, 1]),  # a gap that nobody believes; how old the first is, is not known
        ((25, 1), [25, 1]),
        ((365, 366), [1, 0]),  # the clock is a year ahead
        ((-365, 1, 2), [2, 2, 1]),  # it was, when the first was begun
        ((-20_000, -20_001), [1, 0]),  # it begins at 1970 without a battery
    ],
)
def test_a_file_is_as_old_as_can_be_believed(days_ago: tuple[float, ...], ages: list[float]) -> None:
    found = oldest_first(files(*days_ago), NOW)
    assert [round(age / DAY, 3) for age in found.values()] == ages


def test_files_of_the_future_come_first_and_those_of_one_second_in_their_order() -> None:
    stamp = stamp_of(NOW)
    names = [f"{stamp}-10.mcap", f"{stamp}-2.mcap", f"{stamp}.mcap", f"{stamp_of(NOW + YEAR)}.mcap"]
    assert [each.name for each in oldest_first(map(Path, names), NOW + 0.5)] == names[::-1]


@pytest.mark.parametrize("name", ["notes.mcap", "20261399T000000Z.mcap", "", "2026.mcap"])
def test_a_file_of_another_name_is_left_alone(name: str) -> None:
    assert began_of(Path(name)) is None
    assert oldest_first([Path(name)], NOW) == {}


def test_a_start_a_year_ahead_costs_no_recording(tmp_path: Path) -> None:
    kept = [tmp_path / each.name for each in files(3, 1)]
    for path in kept:
        path.write_bytes(b"a recording")
    record(tmp_path, NOW + YEAR)
    record(tmp_path, NOW + YEAR + DAY)
    assert all(path.exists() for path in kept)
    record(tmp_path, NOW + YEAR + 15 * DAY)
    assert not kept[0].exists(), "by then it is old by any clock"


def record(folder: Path, utc: float) -> None:
    clocks = SteppedClocks()
    clocks.wall = utc
    sink = RecordingSink(
        folder, FACTS, clocks, schema_of=JsonSchemas().of, tell=lambda _: None, bounds=Bounds()
    )
    sink.take([Recorded("hw/stop/state", 0.0, None, 0, b"{}")])
    sink.close()


def test_a_black_box_of_a_wrong_clock_goes_before_those_of_a_right_one(tmp_path: Path) -> None:
    boxes = Boxes(tmp_path, files=2)
    keep(boxes, NOW + YEAR)
    right = [keep(boxes, NOW), keep(boxes, NOW + 60.0)]
    assert list(boxes.paths()) == right


def keep(boxes: Boxes, utc: float) -> Path:
    return boxes.keep(utc, FACTS, Span(0.0, 1.0), (), ())
