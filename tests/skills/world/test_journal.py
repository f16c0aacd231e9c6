"""The journal gives back what was written, also after a crash in the middle of a line."""

from pathlib import Path

from skills.ports.geometry import Pose
from skills.ports.world import HeldItem, Placed
from skills.world import journal
from skills.world.journal import Journal, Remembered

HELD = Remembered(held=(HeldItem(side="left", item=29, item_in_tool=Pose()),))
PLACED = Remembered(placed=(Placed(item=29, depot="depot", slot=2),))


def test_a_new_journal_remembers_nothing(tmp_path: Path) -> None:
    assert Journal(tmp_path / "j").remembered == Remembered()


def test_the_last_line_counts(tmp_path: Path) -> None:
    writing = Journal(tmp_path / "j")
    writing.write(HELD)
    writing.write(PLACED)
    assert Journal(tmp_path / "j").remembered == PLACED


def test_a_torn_line_loses_only_itself(tmp_path: Path) -> None:
    Journal(tmp_path / "j").write(HELD)
    with (tmp_path / "j").open("a") as file:
        file.write(PLACED.model_dump_json()[:20])
    assert Journal(tmp_path / "j").remembered == HELD


def test_a_long_journal_is_rewritten(tmp_path: Path) -> None:
    writing = Journal(tmp_path / "j")
    for _ in range(journal.COMPACT_AFTER + 5):
        writing.write(PLACED)
    assert len((tmp_path / "j").read_text().splitlines()) < 10
