"""What happened in a record, when, and the part of it in which a task ran."""

from __future__ import annotations

from pathlib import Path

import pytest
from mocked_fetch import FACTS, MockedFetch

from tandem.executive.records.cutting import cut
from tandem.executive.records.exporting import counts, exported
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.moments import at_of, moments, span_of
from tandem.executive.records.recording import Recorded, RecordError, Recording, Span, open_recording
from tandem.executive.records.tape import Tape
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TaskState, TaskStatus


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """A task that fails, and a stop after it."""
    system = MockedFetch(tmp_path_factory.mktemp("boxes"))
    system.fail()
    system.stop()
    (path,) = system.black_boxes()
    return open_recording(path)


def test_what_happened_stands_in_order(record: Recording) -> None:
    found = moments(record)
    assert [each.kind for each in found] == ["accepted", "started", "failed", "stop"]
    assert found[2].words == "wait-0001 FAILED: GRASP_EMPTY: closed on nothing"
    assert [each.at for each in found] == sorted(each.at for each in found)


def test_a_cut_begins_with_what_was_known(record: Recording, tmp_path: Path) -> None:
    span = span_of(record, "wait-0001")
    assert span is not None
    target = tmp_path / "part.jsonl.gz"
    cut(record, target, span)
    part = open_recording(target)
    whole, own = Tape(record), Tape(part)
    whole.go(span.end)
    own.go(span.end)
    assert own.known() == whole.known()
    assert part.span == span
    assert len(list(part.messages())) < len(list(record.messages()))


@pytest.mark.parametrize("part", [Span(1e6, 2e6), Span(-5.0, -1.0), Span(2.0, 1.0)])
def test_nothing_lies_outside(record: Recording, part: Span, tmp_path: Path) -> None:
    with pytest.raises(RecordError, match="tandem log info"):
        cut(record, tmp_path / "part.jsonl.gz", part)


def test_what_is_no_message_is_passed_over(record: Recording, tmp_path: Path) -> None:
    """A recorder keeps what was on the bus, whoever put it there."""
    odd = [
        Recorded(each.key, each.at, each.stamp, each.host, payload)
        for each in record.messages()
        for payload in (b"{", b"[7]", each.payload)
    ]
    path = tmp_path / "odd.jsonl.gz"
    write_lines(path, record.facts, record.span, record.attachments, odd)
    known = Tape(open_recording(path))
    known.go(record.span.end)
    assert moments(open_recording(path)) == moments(record)
    assert known.known().statuses()
    broken = [Recorded(each.key, each.at, each.stamp, each.host, b"{") for each in record.messages()]
    write_lines(path, record.facts, record.span, (), broken)
    silent = Tape(open_recording(path))
    silent.go(record.span.end)
    assert (silent.known().statuses(), silent.known().alive(), silent.known().tree().task) == (
        (),
        frozenset(),
        "",
    )


def test_no_span_of_a_task_that_is_not_there(record: Recording) -> None:
    assert span_of(record, "fetch-0099") is None


@pytest.mark.parametrize(
    ("begin", "expected"), [(0.0, (30.0, 40.0)), (35.0, (35.0, 40.0)), (10.0, (30.0, 40.0))]
)
def test_the_part_of_a_task_begins_with_its_start(
    begin: float, expected: tuple[float, float], tmp_path: Path
) -> None:
    def told(at: float, state: TaskState, started: float | None) -> Recorded:
        since = None if started is None else RobotTime(boot="a", seconds=started)
        status = TaskStatus(task="t-1", kind="wait", request={}, state=state, accepted_at=0.0, started=since)
        stamp = RobotTime(boot="a", seconds=at)
        return Recorded("task/t-1/status", at, stamp, 0, status.model_dump_json().encode())

    messages = [
        told(1.0, TaskState.QUEUED, None),
        told(30.0, TaskState.RUNNING, 30.0),
        told(40.0, TaskState.SUCCEEDED, 30.0),
        told(50.0, TaskState.SUCCEEDED, 30.0),
    ]
    path = tmp_path / "queued.jsonl.gz"
    write_lines(path, FACTS, Span(begin, 60.0), (), messages)
    assert span_of(open_recording(path), "t-1") == Span(*expected)


def test_the_lines_of_a_key(record: Recording) -> None:
    lines = list(exported(record, "hw/stop/*"))
    assert len(lines) == 1
    assert '"key":"hw/stop/state"' in lines[0]
    assert '"message":{"stopped":true,' in lines[0]
    assert sum(each.messages for each in counts(record)) == len(list(exported(record)))


def test_a_robot_time_is_of_the_last_boot_that_has_it(tmp_path: Path) -> None:
    def heard(at: float, boot: str, seconds: float) -> Recorded:
        return Recorded("k", at, RobotTime(boot=boot, seconds=seconds), 0, b"{}")

    messages = [heard(5.0, "a", 5.0), heard(20.0, "a", 20.0), heard(21.0, "b", 1.0), heard(28.0, "b", 8.0)]
    path = tmp_path / "two.jsonl.gz"
    write_lines(path, FACTS, Span(5.0, 28.0), (), messages)
    record = open_recording(path)
    assert [at_of(record, seconds) for seconds in (6.0, 15.0, 1.0, 99.0)] == [26.0, 15.0, 21.0, 28.0]
