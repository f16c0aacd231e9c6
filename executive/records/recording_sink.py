"""A recording under way: MCAP files one after the other, bounded in size and age, flushed once a second.

When the disk does not take it, recording stops and says so; nothing else stops. Once there is space it goes
on, in a new file that begins with what is known by then.
"""

from __future__ import annotations

import logging
import shutil
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Final, Protocol

from tandem.executive.records.dated import oldest_first, stamp_of
from tandem.executive.records.mcap_writing import McapFile, SchemaOf
from tandem.executive.records.recording import Attachment, Facts, Recorded
from tandem.executive.records.recordings import NAME
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.records import RecordingState

FLUSH_EVERY: Final = 1.0
"""Host seconds: what kill -9 costs at the most."""
AGAIN_EVERY: Final = 10.0
"""Host seconds between two looks whether there is space again. Each says anew that nothing is recorded, so
that who has come meanwhile learns of it."""
SPACE: Final = 64 * 1024 * 1024
"""Bytes that must be free for recording to go on: two minutes of a robot with pictures. With less it would
stop at once, and each time leave a file."""
DAY: Final = 86_400.0
_LOG = logging.getLogger(__name__)


@dataclass(frozen=True)
class Bounds:
    """How much is kept."""

    file_bytes: int = 256 * 1024 * 1024
    """Size at which the next file begins: about ten minutes of a robot with pictures."""
    file_seconds: float = 1800.0
    """Host seconds after which the next file begins."""
    folder_bytes: int = 8 * 1024 * 1024 * 1024
    """Bytes of all recordings of the folder; the oldest go."""
    folder_days: float = 14.0
    """Days after which a recording goes."""


def free_at(folder: Path) -> int:
    """Return the bytes that are free where a folder is, or will be.

    Raises:
        OSError: when that can't be told.
    """
    there = next(each for each in (folder, *folder.absolute().parents) if each.exists())
    return shutil.disk_usage(there).free


class Shows(Protocol):
    """Adds to a file what a viewer draws by itself."""

    def learn(self, attachment: Attachment) -> None:
        """Learn of the robot."""
        ...

    def __call__(self, file: McapFile, message: Recorded) -> None:
        """Write what is drawn of a message."""
        ...


class RecordingSink:
    """Writes what it is given; implements ``recorder.Sink``.

    Args:
        folder: where the files go.
        facts: what they are of.
        clocks: the host's.
        schema_of: of our messages.
        tell: takes how it stands, whenever that changes.
        shows: adds what Foxglove draws.
        bounds: how much is kept.
        opens: opens a file for writing.
        free: tells how many bytes are free at the folder.
    """

    def __init__(
        self,
        folder: Path,
        facts: Facts,
        clocks: Clocks,
        *,
        schema_of: SchemaOf,
        tell: Callable[[RecordingState], None],
        shows: Shows | None = None,
        bounds: Bounds = Bounds(),
        opens: Callable[[Path], IO[bytes]] = lambda path: path.open("xb"),
        free: Callable[[Path], int] = free_at,
    ) -> None:
        self._folder, self._facts, self._clocks, self._bounds = folder, facts, clocks, bounds
        self._schema_of, self._tell, self._shows, self._opens = schema_of, tell, shows, opens
        self._free_bytes = free
        self._last: dict[str, Recorded] = {}
        self._attachments: dict[str, Attachment] = {}
        self._stream: IO[bytes] | None = None
        self._file: McapFile | None = None
        self._path: Path | None = None
        self._opened_at = self._flushed_at = 0.0
        self._stopped: RecordingState | None = None
        """What was said when recording stopped; None: it has not."""
        self._looked_at = 0.0

    @property
    def path(self) -> Path | None:
        """The file that is written; None before the first message, and once recording has stopped."""
        return self._path

    def take(self, messages: Iterable[Recorded]) -> None:
        """Write messages."""
        if self._stopped is not None and not self._may_go_on():
            for message in messages:
                self._keep(message)
            return
        rest = iter(messages)
        try:
            for message in rest:
                self._keep(message)
                self._write(message)
            self._look_after()
        except OSError as error:
            self._stop(error)
            for message in rest:
                self._keep(message)

    def also(self, write: Callable[[McapFile], None]) -> None:
        """Have something else written into the file, such as a picture."""
        if self._file is None:
            return
        try:
            write(self._file)
        except OSError as error:
            self._stop(error)

    def attach(self, attachment: Attachment) -> None:
        """Write a document beside the messages."""
        self._attachments[attachment.name] = attachment
        if self._shows is not None:
            self._shows.learn(attachment)
        if self._file is None:
            return
        try:
            self._file.attach(attachment)
        except OSError as error:
            self._stop(error)

    def close(self) -> None:
        """End the file. Closing twice is allowed."""
        if self._file is None:
            return
        try:
            self._finish()
        except OSError as error:
            self._stop(error)

    def _keep(self, message: Recorded) -> None:
        """Know it as the last of its key, with which the next file begins."""
        self._last.pop(message.key, None)
        self._last[message.key] = message

    def _write(self, message: Recorded) -> None:
        if self._file is None:
            self._open(message)
            return
        self._file.put(message)
        if self._shows is not None:
            self._shows(self._file, message)

    def _look_after(self) -> None:
        now = self._clocks.monotonic()
        if self._file is None or self._stream is None or now - self._flushed_at < FLUSH_EVERY:
            return
        self._flushed_at = now
        self._file.flush()
        too_large = self._stream.tell() >= self._bounds.file_bytes
        if too_large or now - self._opened_at >= self._bounds.file_seconds:
            self._finish()

    def _open(self, first: Recorded) -> None:
        """Begin a file with what is known, of which ``first`` is the newest."""
        self._folder.mkdir(parents=True, exist_ok=True)
        self._let_go()
        path, self._path = self._free(), None
        try:
            self._begin(path, first)
        except OSError:
            self._close_stream()
            path.unlink(missing_ok=True)  # there is nothing in it
            raise
        if self._stopped is not None:
            _LOG.info("recording again: %s", path)
        self._path, self._stopped = path, None
        self._tell(RecordingState(recording=True, file=str(path)))

    def _begin(self, path: Path, first: Recorded) -> None:
        self._stream = self._opens(path)
        self._opened_at = self._flushed_at = self._clocks.monotonic()
        self._file = McapFile(self._stream, self._facts, first.at, self._schema_of)
        for attachment in self._attachments.values():
            self._file.attach(attachment)
        for message in self._last.values():
            self._file.put(message)
        if self._shows is not None:
            self._shows(self._file, first)
        self._file.flush()

    def _may_go_on(self) -> bool:
        """Say whether to try again, now and then, after recording has stopped."""
        now = self._clocks.monotonic()
        if self._stopped is None or now - self._looked_at < AGAIN_EVERY:
            return False
        self._looked_at = now
        self._tell(self._stopped)
        try:
            return self._free_bytes(self._folder) >= SPACE
        except OSError:
            return False

    def _finish(self) -> None:
        assert self._file is not None
        assert self._stream is not None
        self._file.finish()
        self._stream.close()
        self._file = self._stream = None

    def _stop(self, error: OSError) -> None:
        path, reason = self._path, error.strerror or str(error)
        self._close_stream()
        self._path, self._looked_at = None, self._clocks.monotonic()
        if self._stopped is not None and self._stopped.reason == reason:
            return  # it has been said
        _LOG.error("recording stopped: %s: %s; it goes on once there is space", path or self._folder, reason)
        self._stopped = RecordingState(recording=False, file=str(path or ""), reason=reason)
        self._tell(self._stopped)

    def _close_stream(self) -> None:
        """Let go of a file that can't be ended."""
        if self._stream is not None:
            with suppress(OSError):
                self._stream.close()
        self._file = self._stream = None

    def _free(self) -> Path:
        stem = stamp_of(self._clocks.utc())
        path, number = self._folder / f"{stem}.mcap", 1
        while path.exists():
            number += 1
            path = self._folder / f"{stem}-{number}.mcap"
        return path

    def _let_go(self) -> None:
        """Remove the oldest recordings, so that the next one has its place."""
        paths = (each for each in self._folder.iterdir() if NAME.fullmatch(each.name))
        ages = oldest_first(paths, self._clocks.utc())
        sizes = {each: each.stat().st_size for each in ages}
        total = sum(sizes.values()) + self._bounds.file_bytes
        for path, age in ages.items():
            if total <= self._bounds.folder_bytes and age <= self._bounds.folder_days * DAY:
                break
            total -= sizes[path]
            path.unlink(missing_ok=True)
