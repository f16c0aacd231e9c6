"""Records of one task: which there are, and what was known at a moment of one on this host.

A moment is told as it was told then: the record is played into the page's own ``Feed``. A recording may still
be written. Of it only those chunks are read that have what was said last before the moment.
"""

from __future__ import annotations

import asyncio
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from pydantic import JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.executive.records.lines_file import LINES
from tandem.executive.records.player import Player
from tandem.executive.records.recording import BootSpan, Recording, open_recording
from tandem.executive.web.feed import LASER_EVERY, Feed
from tandem.executive.web.viewers import Update, merge
from tandem.skills.ports.keys import DESCRIPTION
from tandem.skills.ports.message import read_leniently
from tandem.skills.ports.records import BlackBox, RecordingFile, Records
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.tasks import TaskStatus

LARGEST: Final = 64 * 1024 * 1024
"""Bytes of a black box that is read; one has 3 to 6 MB. It is held whole, unlike a recording."""
NEAR: Final = 1.0
"""Robot seconds by which a record may end before the moment that was asked for, or begin after it. The clock
is heard all the time, and a recording that is written is flushed once a second."""
HELD: Final = 3
"""Records that are kept open: a slider goes to and fro between two recordings and a black box at the most."""
SHOWN: Final = (
    "tree", "nodes", "board", "gates", "world", "scene", "occupied", "pose", "joints", "lasers", "people",
    "plan", "hands", "now", "robots",
)  # fmt: skip
"""Parts of an update that tell of a moment; tasks, stop, reflexes and pulse have other views."""


class UnreadableError(Exception):
    """A moment that can't be told; the message says why and what to do."""


@dataclass(frozen=True)
class Asked:
    """A moment that is asked for."""

    seconds: float
    """The robot's own time."""
    boot: str = ""
    """Of which boot of the robot; empty: the last one that has it."""


class Kept:
    """Asks the recorder, and reads the records; the last ones that were read stay open."""

    def __init__(self) -> None:
        self._held: dict[Path, Recording] = {}
        self._reading = asyncio.Lock()

    async def of(self, client: AsyncClient, status: TaskStatus) -> dict[str, JsonValue]:
        """Return the records in which a task is, newest first; ClientError when no recorder answers."""
        found = await client.records(status.task)
        return {
            "boxes": [_box(each) for each in reversed(found.boxes)],
            "recordings": [_recording(each) for each in reversed(found.recordings) if _has(each, status)],
        }

    async def moment(self, client: AsyncClient, status: TaskStatus, asked: Asked) -> dict[str, JsonValue]:
        """Return what was known at a moment of a task: out of a recording that has it, else of a black box.

        Raises:
            UnreadableError: when there is none that this host can read, or none has the moment.
        """
        found = await client.records(status.task)
        async with self._reading:
            return await asyncio.to_thread(self._read, tuple(_paths(found, status)), status.task, asked)

    def close(self) -> None:
        """Close what is open."""
        while self._held:
            self._held.popitem()[1].close()

    def _read(self, paths: tuple[Path, ...], task: str, asked: Asked) -> dict[str, JsonValue]:
        why: list[str] = []
        for path in paths:
            try:
                record = self._record(path)
            except (DocumentError, UnreadableError, ModuleNotFoundError, OSError) as error:
                why.append(str(error))
                continue
            boot, words = _boot_with(record, asked)
            if boot is not None:
                return _told(record, asked.seconds + boot.offset)
            why.append(f"nothing was recorded at {asked.seconds:.1f} s{words}")
        raise UnreadableError("; ".join(dict.fromkeys(why)) or f"no record has {task}")

    def _record(self, path: Path) -> Recording:
        """Return what is in a file by now."""
        known = self._held.pop(path, None)
        if known is None:
            if not path.is_file():
                raise UnreadableError(
                    f"{path} is on the robot's computer; run `tandem replay {path} --web` there"
                )
            known = _opened(path)
        else:
            known.grow()
        self._held[path] = known
        while len(self._held) > HELD:
            self._held.pop(next(iter(self._held))).close()
        return known


def _opened(path: Path) -> Recording:
    if not path.name.endswith(LINES):
        from tandem.executive.records.mcap_growing import GrowingRecording  # noqa: PLC0415 - extra `record`

        return GrowingRecording(path)
    if path.stat().st_size > LARGEST:
        raise UnreadableError(f"{path} is too large to be read here; run `tandem replay {path} --web`")
    return open_recording(path)


def _paths(found: Records, status: TaskStatus) -> Iterator[Path]:
    """Yield the files that may have a task: recordings, which have more, first; the newest of each first."""
    yield from (Path(each.file) for each in reversed(found.recordings) if _has(each, status))
    yield from (Path(each.file) for each in reversed(found.boxes))


def _boot_with(record: Recording, asked: Asked) -> tuple[BootSpan | None, str]:
    """Return the boot that has a moment, or None with the words that say where the record lies from it."""
    boots = [each for each in record.boots() if asked.boot in {"", each.boot}]
    for boot in reversed(boots):
        if boot.begin - NEAR <= asked.seconds <= boot.end + NEAR:
            return boot, ""
    if not boots:
        return None, f"; {record.path.name} has nothing of that start of the robot"
    last = boots[-1]
    if asked.seconds > last.end:
        return None, f"; {record.path.name} ends {asked.seconds - last.end:.0f} s before"
    return None, f"; {record.path.name} begins {last.begin - asked.seconds:.0f} s later"


def _told(record: Recording, at: float) -> dict[str, JsonValue]:
    """Return what was known at a moment of a record, as the page was told it then."""
    player = Player(record)
    feed = Feed(player.bus, lambda: 0.0, player.bus, record.facts.robot)
    described = next((each.data for each in record.attachments if each.name == DESCRIPTION.key), None)
    if described is not None:
        feed.describe(read_leniently(RobotDescription, described))
    player.seek(at)
    update: Update = {}
    for _ in range(LASER_EVERY):
        merge(update, feed.poll())
    feed.close()
    stamp = player.known().stamp
    return {
        "file": str(record.path),
        "stamp": None if stamp is None else stamp.model_dump(mode="json"),
        "shown": {part: update[part] for part in SHOWN if part in update},
    }


def _box(box: BlackBox) -> JsonValue:
    causes: list[JsonValue] = [
        {"words": each.words, "stamp": None if each.stamp is None else each.stamp.model_dump(mode="json")}
        for each in box.causes
    ]
    return {"file": box.file, "size": box.size, "causes": causes, "command": _command(box.file)}


def _recording(recording: RecordingFile) -> JsonValue:
    return {"file": recording.file, "size": recording.size, "command": _command(recording.file)}


def _command(file: str) -> str:
    return f"tandem replay {shlex.quote(file)} --web"


def _has(recording: RecordingFile, status: TaskStatus) -> bool:
    """Say whether it was written while the task was under way."""
    ended = status.ended_at
    return recording.written >= status.accepted_at and (ended is None or recording.began <= ended)
