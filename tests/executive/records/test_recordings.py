"""Which recordings are told: by their names, oldest first."""

from __future__ import annotations

from pathlib import Path

from tandem.executive.records.recordings import MOST, recordings_in


def test_recordings_are_told_with_when_they_began(tmp_path: Path) -> None:
    for name in ("20261127T120000Z-2.mcap", "20261127T120000Z.mcap", "20261126T120000Z.mcap"):
        (tmp_path / name).write_bytes(b"12345")
    for other in ("20269999T120000Z.mcap", "run.mcap", "20261127T120000Z-stop.jsonl.gz"):
        (tmp_path / other).touch()
    found = recordings_in((tmp_path, tmp_path / "missing"))
    assert [Path(each.file).name[6:8] for each in found] == ["26", "27", "27"]
    assert (found[1].began - found[0].began, found[0].size) == (86_400.0, 5)
    assert found[0].written > found[0].began - 1e9


def test_the_newest_are_told_of_many(tmp_path: Path) -> None:
    for number in range(MOST + 5):
        (tmp_path / f"20261127T{number // 60:02}{number % 60:02}00Z.mcap").touch()
    found = recordings_in((tmp_path,))
    assert (len(found), Path(found[0].file).name) == (MOST, "20261127T000500Z.mcap")
