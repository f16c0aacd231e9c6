"""Records of one task: which there are, and what was known at a moment of one on this host.

Only black boxes are read here. They have a minute and a few megabytes; a recording may have hundreds, and
`tandem replay` plays it beside the robot rather than on it.
"""

from __future__ import annotations

import asyncio
import shlex
from pathlib import Path
from typing import Final

from pydantic import JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.executive.records.moments import at_of
from tandem.executive.records.recording import open_recording
from tandem.executive.records.tape import Tape
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.records import BlackBox, RecordingFile
from tandem.skills.ports.tasks import TaskStatus
from tandem.skills.ports.world import ROBOT_POSE, WORLD

LARGEST: Final = 64 * 1024 * 1024
"""Bytes of a black box that is read; one has 3 to 6 MB."""

NEAR: Final = 1.0
"""Robot seconds around the moment that was asked for: the clock is heard all the time."""


class UnreadableError(Exception):
    """A moment that can't be told; the message says why and what to do."""


class Kept:
    """Asks the recorder, and reads the black box that was read last; it is held until another one is."""

    def __init__(self) -> None:
        self._tape: Tape | None = None
        self._reading = asyncio.Lock()

    async def of(self, client: AsyncClient, status: TaskStatus) -> dict[str, JsonValue]:
        """Return the records in which a task is, newest first; ClientError when no recorder answers."""
        found = await client.records(status.task)
        return {
            "boxes": [_box(each) for each in reversed(found.boxes)],
            "recordings": [_recording(each) for each in reversed(found.recordings) if _has(each, status)],
        }

    async def moment(self, client: AsyncClient, task: str, seconds: float) -> dict[str, JsonValue]:
        """Return what was known at a robot time of a task, out of its newest black box.

        Raises:
            UnreadableError: when there is none that this host can read.
            RecordError: for a file that can't be used.
        """
        boxes = (await client.records(task)).boxes
        if not boxes:
            raise UnreadableError(f"no black box has {task}")
        path = Path(boxes[-1].file)
        async with self._reading:
            return await asyncio.to_thread(self._read, path, seconds)

    def _read(self, path: Path, seconds: float) -> dict[str, JsonValue]:
        if self._tape is None or self._tape.record.path != path:
            if not path.is_file():
                raise UnreadableError(
                    f"{path} is on the robot's computer; run `tandem replay {path} --web` there"
                )
            if path.stat().st_size > LARGEST:
                raise UnreadableError(
                    f"{path} is too large to be read here; run `tandem replay {path} --web`"
                )
            self._tape = Tape(open_recording(path))
        tape = self._tape
        tape.go(at_of(tape.record, seconds))
        known = tape.known()
        stamp = known.stamp
        off = None if stamp is None else RobotTime(boot=stamp.boot, seconds=seconds).since(stamp)
        if stamp is None or off is None or abs(off) > NEAR:
            raise UnreadableError(f"nothing was recorded at {seconds:.1f} s{_which(path, off)}")
        world, pose = known.message(WORLD), known.message(ROBOT_POSE)
        return {
            "file": str(path),
            "stamp": stamp.model_dump(mode="json"),
            "tree": known.tree().model_dump(mode="json"),
            "world": None if world is None else world.model_dump(mode="json"),
            "pose": None if pose is None else pose.base_in_map.model_dump(mode="json"),
        }


def _which(path: Path, off: float | None) -> str:
    """Say where a record lies from a moment that lies so many seconds after all that it has."""
    if off is None:
        return ""
    return (
        f"; {path.name} ends {off:.0f} s before" if off > 0.0 else f"; {path.name} begins {-off:.0f} s later"
    )


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
