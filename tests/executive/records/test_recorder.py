"""What goes wrong becomes a black box, and what was published is what is read back."""

from __future__ import annotations

import errno
import io
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import pytest
from mocked_fetch import FACTS, MockedFetch

from tandem.executive.records.boxes import Boxes
from tandem.executive.records.ears import HEARD, Said, Stamper
from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.known import ALIVE
from tandem.executive.records.recording import Recorded, Recording, Span, open_recording
from tandem.executive.records.recording_sink import AGAIN_EVERY, SPACE, Bounds, RecordingSink
from tandem.executive.records.ring import BLOCK, Ring
from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.ports.match import matches
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.records import TASK_RECORDS, AskRecords, RecordingState
from tandem.skills.ports.tasks import TaskState
from tandem.skills.wire.clocks import SteppedClocks


def said(record: Recording) -> list[tuple[str, bytes]]:
    return [(each.key, each.payload) for each in record.messages() if each.key != ALIVE]


def published(system: MockedFetch) -> list[tuple[str, bytes]]:
    return [(key, data) for key, data in system.published if any(matches(each, key) for each in HEARD)]


def contains(whole: list[tuple[str, bytes]], part: list[tuple[str, bytes]]) -> bool:
    """Say whether a part stands somewhere in the whole, without a gap."""
    last = len(whole) - len(part)
    return len(part) > 100 and any(whole[at : at + len(part)] == part for at in range(last + 1))


def sink(folder: Path, told: list[RecordingState], **more: object) -> RecordingSink:
    clocks = SteppedClocks()
    return RecordingSink(
        folder,
        FACTS,
        clocks,
        schema_of=JsonSchemas().of,
        tell=told.append,
        **more,  # type: ignore[arg-type]
    )


def test_a_recording_of_a_fetch_says_what_was_published(tmp_path: Path) -> None:
    told: list[RecordingState] = []
    recording = sink(tmp_path / "run", told)
    system = MockedFetch(tmp_path / "boxes", recording)
    task = system.fetch()
    assert system.state(task) is TaskState.SUCCEEDED
    system.step(10)
    system.recorder.close()
    record = open_recording(Path(told[0].file))
    assert said(record) == published(system)
    names = {each.name for each in record.attachments}
    assert {f"tree/{task}", "hw/description", "task/site", "task/info", "task/kinds"} <= names
    assert f"task/timeline/{task}" in names
    assert system.black_boxes() == ()


def test_a_task_that_fails_leaves_a_black_box_that_says_what_was_published(tmp_path: Path) -> None:
    system = MockedFetch(tmp_path)
    task = system.fail()
    assert system.state(task) is TaskState.FAILED
    (path,) = system.black_boxes()
    record = open_recording(path)
    heard = [(each.key, each.payload) for each in record.messages() if each.at > record.span.begin]
    assert contains(published(system), [each for each in heard if each[0] != ALIVE])
    (cause,) = record.facts.causes
    assert (cause.kind, cause.task) == ("task", task)
    assert "GRASP_EMPTY: closed on nothing" in cause.words
    assert cause.at <= record.span.end <= cause.at + 2.2


def test_the_minute_is_bounded_and_what_was_known_before_it_is_there(tmp_path: Path) -> None:
    system = MockedFetch(tmp_path)
    task = system.fail()
    system.step(600, seconds=0.2)
    system.stop()
    path = system.black_boxes()[-1]
    record = open_recording(path)
    assert record.span.end - record.span.begin == pytest.approx(60.0, abs=0.5)
    before = [each for each in record.messages() if each.at < record.span.begin]
    assert f"task/{task}/status" in {each.key for each in before}
    assert len({each.key for each in before}) == len(before)


def test_a_stop_and_a_death_close_together_are_one_file(tmp_path: Path) -> None:
    system = MockedFetch(tmp_path)
    arm = system.hub.endpoint()
    arm.announce("process/arm_left")
    system.step(20)
    arm.close()
    system.stop()
    (path,) = system.black_boxes()
    causes = open_recording(path).facts.causes
    assert [each.kind for each in causes] == ["stop", "death"]
    assert causes[0].words == "anna set the stop: a test"
    assert causes[1].words == "the arm_left process is gone"


def test_a_stop_that_stays_is_told_once(tmp_path: Path) -> None:
    system = MockedFetch(tmp_path)
    system.stop()
    assert len(system.black_boxes()) == 1
    system.stop()
    assert len(system.black_boxes()) == 1


def test_who_asks_learns_which_file_is_of_which_task(tmp_path: Path) -> None:
    system = MockedFetch(tmp_path)
    task = system.fail()
    (path,) = system.black_boxes()
    asked = [TASK_RECORDS.query(system.bus, AskRecords(task=name)) for name in (task, "other")]
    system.step(20)
    of_task, of_other = (TASK_RECORDS.decode_answer(each.poll() or b"").boxes for each in asked)
    assert [each.file for each in of_task] == [str(path)]
    assert of_other == ()


@pytest.mark.parametrize(("bounds", "kept"), [({"files": 2}, 2), ({"most": 1}, 1)])
def test_old_black_boxes_go(bounds: dict[str, int], kept: int, tmp_path: Path) -> None:
    boxes = Boxes(tmp_path, **bounds)
    paths = [boxes.keep(float(each), FACTS, Span(0.0, 0.0), (), ()) for each in range(4)]
    assert list(boxes.paths()) == paths[-kept:]


class FullDisk(io.BytesIO):
    """A file on a disk with room for so many bytes."""

    room = 50_000

    def write(self, data: object) -> int:
        if self.tell() + len(data) > self.room:  # type: ignore[arg-type]
            raise OSError(errno.ENOSPC, "No space left on device")
        return super().write(data)  # type: ignore[arg-type]


def test_on_a_full_disk_recording_stops_and_says_so_and_the_task_goes_on(tmp_path: Path) -> None:
    told: list[RecordingState] = []
    recording = sink(tmp_path, told, opens=lambda _: FullDisk())
    system = MockedFetch(tmp_path / "boxes", recording)
    assert system.state(system.fetch()) is TaskState.SUCCEEDED
    system.recorder.close()
    assert [each.recording for each in told] == [True, False]
    assert told[-1].reason == "No space left on device"


class NoSpace(FullDisk):
    """Has room for nothing."""

    room = 0


@dataclass
class Disk:
    """Takes a recording, or does not."""

    folder: Path
    full: bool = False
    free: int = 0

    def __post_init__(self) -> None:
        self.told: list[RecordingState] = []
        self.clocks = SteppedClocks()
        self.sink = RecordingSink(
            self.folder, FACTS, self.clocks, schema_of=JsonSchemas().of, tell=self.told.append,
            opens=self.open, free=lambda _: self.free,
        )  # fmt: skip

    def open(self, path: Path) -> IO[bytes]:
        path.touch()
        return NoSpace() if self.full else path.open("wb")

    def says(self, key: str, at: float) -> None:
        """Have a message recorded, and wait as long as the recorder does between two looks."""
        self.sink.take([Recorded(key, at, RobotTime(boot="a", seconds=at), 0, b"{}")])
        self.clocks.advance(AGAIN_EVERY)


def test_recording_goes_on_with_what_is_known_once_there_is_space(tmp_path: Path) -> None:
    disk = Disk(tmp_path, full=True)
    disk.says("hw/one", 1.0)
    disk.says("hw/two", 2.0)
    assert [each.reason for each in disk.told] == ["No space left on device"] * 2, "for who came meanwhile"
    assert list(tmp_path.iterdir()) == [], "a file that could not be begun is taken away"
    disk.full = False
    disk.says("hw/three", 3.0)
    assert not disk.told[-1].recording, "a disk that is nearly full would be full again at once"
    disk.free = SPACE
    disk.says("hw/four", 4.0)
    disk.says("hw/five", 5.0)
    disk.sink.close()
    assert [each.recording for each in disk.told[-2:]] == [False, True]
    record = open_recording(Path(disk.told[-1].file))
    assert [each.key for each in record.messages()] == ["hw/one", "hw/two", "hw/three", "hw/four", "hw/five"]
    assert record.span.begin == 4.0


def test_a_black_box_that_can_not_be_written_harms_nobody(tmp_path: Path) -> None:
    (tmp_path / "boxes").write_text("in the way")
    system = MockedFetch(tmp_path / "boxes")
    assert system.state(system.fail()) is TaskState.FAILED
    assert system.black_boxes() == ()


def moments(count: int, key: str = "hw/clock") -> list[Recorded]:
    return [
        Recorded(key, float(each), RobotTime(boot="a", seconds=float(each)), each * 10**9, b"x" * 100)
        for each in range(count)
    ]


def test_a_new_file_begins_with_what_is_known(tmp_path: Path) -> None:
    told: list[RecordingState] = []
    clocks = SteppedClocks()
    recording = RecordingSink(
        tmp_path,
        FACTS,
        clocks,
        schema_of=JsonSchemas().of,
        tell=told.append,
        bounds=Bounds(file_seconds=5.0),
    )
    recording.take([Recorded("hw/stop/state", 0.0, None, 0, b"{}")])
    for message in moments(9):
        clocks.advance(1.0)
        recording.take([message])
    recording.close()
    first, second = (open_recording(Path(each.file)) for each in told)
    assert [each.key for each in second.messages()][:2] == ["hw/stop/state", "hw/clock"]
    assert second.span.begin == first.span.end + 1.0


def test_old_recordings_go(tmp_path: Path) -> None:
    told: list[RecordingState] = []
    bounds = Bounds(file_bytes=1, folder_bytes=1500)
    clocks = SteppedClocks()
    recording = RecordingSink(
        tmp_path, FACTS, clocks, schema_of=JsonSchemas().of, tell=told.append, bounds=bounds
    )
    for message in moments(10):
        clocks.advance(2.0)
        recording.take([message])
    recording.close()
    assert len(told) > 3
    assert sum(each.stat().st_size for each in tmp_path.iterdir()) < 4000
    assert Path(told[-1].file).exists()


@pytest.mark.parametrize(
    ("ring", "left"),
    [(lambda: Ring(seconds=10.0), 11), (lambda: Ring(most=5 * 400), 4)],
    ids=["seconds", "bytes"],
)
def test_the_ring_is_bounded(ring: Callable[[], Ring], left: int) -> None:
    made = ring()
    for message in moments(100):
        made.add(message)
    assert len(made.messages()) == left + 1  # and the last one from before
    assert made.span.end == 99.0


def test_the_ring_packs_what_it_holds_and_returns_it_as_it_was() -> None:
    ring, said = Ring(seconds=1e9), [*moments(3 * BLOCK + 7)]
    for message in said:
        ring.add(message)
    assert ring.messages() == said
    assert len(ring.kept().blocks) == 2  # the oldest is open, for what goes next
    assert len(ring.kept().blocks[0]) < sum(len(each.payload) for each in said[:BLOCK])


def test_the_ring_lets_go_of_one_message_at_a_time_out_of_what_it_packed() -> None:
    ring = Ring(seconds=1.5 * BLOCK)
    for message in moments(3 * BLOCK):
        ring.add(message)
    assert ring.span == Span(1.5 * BLOCK - 1.0, 3.0 * BLOCK - 1.0)


def test_the_ring_keeps_a_minute_of_both_clocks() -> None:
    """At ten times real time a minute of the robot is six seconds of the host: the host's minute counts."""
    ring = Ring(seconds=10.0)
    for message in moments(100):
        ring.add(Recorded(message.key, message.at, message.stamp, message.host // 10, b""))
    assert ring.span.begin == 0.0


@pytest.mark.parametrize(
    "clock", [b"[" * 100_000, b'{"stamp":' * 50_000, b"9" * 50_000, b"\xff", b"{}", b'{"stamp": {"boot": 1}}']
)
def test_what_is_no_clock_is_recorded_and_ends_nothing(clock: bytes) -> None:
    """A hundred thousand brackets on ``hw/clock`` ended the recorder."""
    ear = Ear()
    stamper = Stamper(ear)
    stamper.stamped([Said("hw/clock", b'{"stamp": {"boot": "b", "seconds": 1.0}}', 0)], 0)
    (told,) = stamper.stamped([Said("hw/clock", clock, 0)], 0)
    assert told.payload == clock
    assert stamper.stamp == RobotTime(boot="b", seconds=1.0)
    assert ear.refused == {("hw/clock", Reason.MALFORMED): 1}
