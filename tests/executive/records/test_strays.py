"""What strangers put on the keys that a recorder reads is recorded as it was, counted, and ends nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from mocked_fetch import MockedFetch

from tandem.executive.records.foxglove_view import FoxgloveView
from tandem.executive.records.pictures import Pictures
from tandem.executive.records.recording import Attachment, Recorded
from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.wire.memory import MemoryBus

DEEP = b"[" * 100_000
HOSTILE = (b"", b"\xff", b"{}", b"[]", DEEP, b'{"a":' * 50_000, b"9" * 50_000, b"x" * 3_000_000)
NUMBERS = (b"NaN", b"Infinity", b"1e999", b"1e300")
CLOCKS = tuple(b'{"stamp": {"boot": "b", "seconds": %s}}' % each for each in NUMBERS)


@pytest.mark.parametrize(
    ("key", "payload"),
    [
        *(("hw/clock", each) for each in (*HOSTILE, *CLOCKS)),
        *(("hw/stop/state", each) for each in HOSTILE),
        *(("task/evil-1/status", each) for each in (*HOSTILE, b'{"task": 1, "version": 99}')),
    ],
)
def test_the_recorder_counts_what_it_can_not_read(tmp_path: Path, key: str, payload: bytes) -> None:
    system = MockedFetch(tmp_path)
    system.step(20)
    system.bus.publish(key, payload)
    system.step(20)
    heard = system.end.ear.refused
    assert heard == {(key, Reason.MALFORMED): 1}
    assert system.recorder.newest is not None
    assert system.recorder.newest.stamp == system.clocks.robot()


@pytest.mark.parametrize("payload", HOSTILE)
def test_what_is_no_picture_is_counted(payload: bytes) -> None:
    bus = MemoryBus()
    pictures = Pictures(bus, lambda: 1.0, lambda _: pytest.fail("there is no picture"))
    bus.publish("hw/camera/head/rgbd", payload)
    pictures.step(Recorded("hw/clock", 0.0, None, 0, b"{}", "json"))
    assert bus.ear.refused == {("hw/camera/head/rgbd", Reason.MALFORMED): 1}


@pytest.mark.parametrize("payload", HOSTILE)
def test_what_is_no_description_is_counted_and_draws_nothing(payload: bytes) -> None:
    ear = Ear()
    FoxgloveView(ear).learn(Attachment("hw/description", 0.0, payload))
    assert ear.refused == {("hw/description", Reason.MALFORMED): 1}
