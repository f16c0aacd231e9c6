"""Recordings of earlier releases are replayed by this one. A release adds its files, and changes none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.records.known import Known
from tandem.executive.records.moments import moments
from tandem.executive.records.player import Player
from tandem.executive.records.recording import open_recording
from tandem.skills.ports.keys import DESCRIPTION, Nothing
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.tasks import TASK_KINDS, TaskState

FILES = sorted((Path(__file__).parent / "data").iterdir())


def test_there_is_a_file_of_each_kind() -> None:
    assert {"".join(path.suffixes[-1:]) for path in FILES} == {".gz", ".mcap"}
    assert sum(path.stat().st_size for path in FILES if "0.1.0" in path.name) < 400_000


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_what_happened_in_it_is_told(path: Path) -> None:
    record = open_recording(path)
    assert [each.words for each in moments(record)][:3] == [
        "wait-0001 accepted: wait",
        "wait-0001 started",
        "wait-0001 FAILED: GRASP_EMPTY: closed on nothing",
    ]
    record.close()


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_message_of_it_is_read(path: Path) -> None:
    record = open_recording(path)
    player = Player(record)
    player.seek(record.span.begin)
    player.play(record.span.end)
    known: Known = player.known()
    assert known.statuses()[0].state is TaskState.FAILED
    assert known.tree().root.children
    answer = DESCRIPTION.query(player.bus, Nothing()), TASK_KINDS.query(player.bus, Nothing())
    player.step()
    robot, kinds = (each.poll() or b"" for each in answer)
    assert RobotDescription.model_validate_json(robot).hands
    assert "fetch" in {each.name for each in TASK_KINDS.decode_answer(kinds).kinds}
    record.close()
