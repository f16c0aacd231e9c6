"""Journals on a full disk: what was kept stays, and the next call tries again."""

from __future__ import annotations

import gc
import weakref
from pathlib import Path

import pytest

from tandem.skills.goal_journal import COMPACT_AFTER, KEPT, GoalJournal
from tandem.skills.journal_file import JournalFile
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import HeldItem
from tandem.skills.world.journal import Journal, Remembered
from tests.fakes.full_disk import full_at

FULL = "File too large|could be written"
HELD = Remembered(held=(HeldItem(side="left", item=29, item_in_tool=Pose()),))


@pytest.mark.parametrize("room", [0, 3], ids=["full", "full in the middle of a line"])
def test_a_line_that_does_not_fit_leaves_the_file_as_it_was(tmp_path: Path, room: int) -> None:
    journal = JournalFile(tmp_path / "j")
    journal.append("first")
    with full_at(len("first\n") + room), pytest.raises(OSError, match=FULL):
        journal.append("second")
    journal.append("third")
    assert (tmp_path / "j").read_text() == "first\nthird\n"


def test_a_torn_line_does_not_swallow_the_next_one(tmp_path: Path) -> None:
    (tmp_path / "j").write_text("first\nsec")
    journal = JournalFile(tmp_path / "j")
    assert journal.lines() == ["first"]
    journal.append("third")
    assert journal.lines() == ["first", "third"]


def test_a_rewrite_that_fails_leaves_the_file_as_it_was(tmp_path: Path) -> None:
    journal = JournalFile(tmp_path / "j")
    journal.append("first")
    with full_at(0), pytest.raises(OSError, match=FULL):
        journal.rewrite(["second"])
    journal.append("third")
    assert journal.lines() == ["first", "third"]


def test_an_id_that_could_not_be_written_is_unknown_and_the_next_is_taken(tmp_path: Path) -> None:
    journal = GoalJournal(tmp_path / "base.goals")
    journal.accept("t/a/1")
    with full_at(0), pytest.raises(OSError, match=FULL):
        journal.accept("t/b/1")
    journal.accept("t/c/1")
    assert GoalJournal(tmp_path / "base.goals").before == {"t/a/1", "t/c/1"}


def test_a_long_list_of_goals_goes_on_after_its_rewrite_failed(tmp_path: Path) -> None:
    journal = GoalJournal(tmp_path / "base.goals")
    (tmp_path / "base.goals").write_text("".join(f"t/{number}/1\n" for number in range(COMPACT_AFTER)))
    journal = GoalJournal(tmp_path / "base.goals")
    with full_at(0), pytest.raises(OSError, match=FULL):
        journal.accept("t/late/1")
    journal.accept("t/late/2")
    assert "t/late/2" in GoalJournal(tmp_path / "base.goals").before


def test_a_start_on_a_full_disk_remembers_what_was_written_before(tmp_path: Path) -> None:
    Journal(tmp_path / "held.jsonl").write(HELD)
    GoalJournal(tmp_path / "base.goals").accept("t/a/1")
    with full_at(0):
        assert Journal(tmp_path / "held.jsonl").remembered.held == HELD.held
        assert GoalJournal(tmp_path / "base.goals").before == {"t/a/1"}


class Id(str):
    """A goal's id of which one can tell whether anybody still has it."""

    __slots__ = ("__weakref__",)


def test_ids_that_the_next_rewrite_leaves_out_are_not_kept_in_memory_until_then(tmp_path: Path) -> None:
    journal = GoalJournal(tmp_path / "base.goals")
    first = Id("t/a/1")
    kept = weakref.ref(first)
    journal.accept(first)
    del first
    for number in range(KEPT):
        journal.accept(f"t/{number}/1")
    gc.collect()
    assert kept() is None
