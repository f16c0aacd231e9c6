"""The journal gives back what was written, also after a crash in the middle of a line."""

import json
from pathlib import Path

import pytest

from tandem.skills.ports.pose import Pose
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.world import HeldItem, Placed
from tandem.skills.site import load
from tandem.skills.world import journal
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.journal import Journal, Remembered

HELD = Remembered(held=(HeldItem(side="left", item=29, item_in_tool=Pose()),))
PLACED = Remembered(placed=(Placed(item=29, depot="depot", slot=2),))


def facts(folder: Path) -> Remembered:
    """Return what a new start of the keeper finds, but for the count of starts."""
    return Journal(folder / "j").remembered.model_copy(update={"openings": 0})


def test_a_new_journal_remembers_nothing(tmp_path: Path) -> None:
    assert facts(tmp_path) == Remembered()


def test_the_last_line_counts(tmp_path: Path) -> None:
    writing = Journal(tmp_path / "j")
    writing.write(HELD)
    writing.write(PLACED)
    assert facts(tmp_path) == PLACED


def test_a_torn_line_loses_only_itself(tmp_path: Path) -> None:
    Journal(tmp_path / "j").write(HELD)
    with (tmp_path / "j").open("a") as file:
        file.write(PLACED.model_dump_json()[:20])
    assert facts(tmp_path) == HELD


def test_a_long_journal_is_rewritten(tmp_path: Path) -> None:
    writing = Journal(tmp_path / "j")
    for _ in range(journal.COMPACT_AFTER + 5):
        writing.write(PLACED)
    assert len((tmp_path / "j").read_text().splitlines()) < 10


def test_versions_of_the_facts_rise_over_a_new_start(tmp_path: Path) -> None:
    before = Beliefs(load("lab"), Journal(tmp_path / "j").remembered)
    for _ in range(10):
        before.add(29)
    assert Beliefs(load("lab"), Journal(tmp_path / "j").remembered).version > before.version


def test_what_a_newer_version_wrote_is_believed_without_its_new_fields(tmp_path: Path) -> None:
    (tmp_path / "j").write_text(json.dumps(HELD.model_dump(mode="json") | {"new": 1}) + "\n")
    assert facts(tmp_path) == HELD


def test_a_journal_that_cannot_be_read_is_refused_and_left_as_it_is(tmp_path: Path) -> None:
    """A keeper that forgot what a hand holds would let it open over nothing, or the arm through the item."""
    (tmp_path / "j").write_text('{"held": "both"}\n')
    with pytest.raises(DocumentError, match=r"j: held: expected an array, found \"both\"; move it away"):
        Journal(tmp_path / "j")
    assert (tmp_path / "j").read_text() == '{"held": "both"}\n'
