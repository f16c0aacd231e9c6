"""Replay shows what live showed: what the page would have told at ten moments is told again."""

from __future__ import annotations

from pathlib import Path

from mocked_fetch import FACTS, MockedFetch
from pydantic import JsonValue

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.player import Player
from tandem.executive.records.recording import open_recording
from tandem.executive.records.recording_sink import RecordingSink
from tandem.executive.web.feed import Feed
from tandem.skills.ports.records import RecordingState
from tandem.skills.wire.clocks import SteppedClocks

OF_THE_VIEWER = {"now"}
"""How long the page has heard nothing is about the page."""


def shown(feed: Feed) -> dict[str, JsonValue]:
    for _ in range(40):
        feed.poll()
    return {name: value for name, value in feed.whole().items() if name not in OF_THE_VIEWER}


def test_what_is_replayed_at_ten_moments_is_what_was_live(tmp_path: Path) -> None:
    told: list[RecordingState] = []
    sink = RecordingSink(
        tmp_path / "run", FACTS, SteppedClocks(), schema_of=JsonSchemas().of, tell=told.append
    )
    system = MockedFetch(tmp_path / "boxes", sink)
    live = Feed(system.hub.endpoint(), system.clocks.monotonic)
    system.bus.announce("executive")
    system.step(5)
    task = system.ask({"task": "fetch", "item": 29}).task
    seen: list[tuple[float, dict[str, JsonValue]]] = []
    for _ in range(10):
        system.step(41)
        at = system.clocks.robot()
        assert at is not None
        seen.append((at.seconds, shown(live)))
    assert system.executive.book.find(task) is not None
    system.step(20)
    system.recorder.close()
    record = open_recording(Path(told[0].file))
    for at_seconds, expected in reversed(seen):  # each time anew, and from the newest back
        player = Player(record)
        feed = Feed(player.bus, system.clocks.monotonic)
        player.seek(at_seconds)
        assert shown(feed) == expected, at_seconds
    record.close()
