"""A recording under way: MCAP files one after the other, bounded in size and age, flushed once a second.

When the disk does not take it, recording stops and says so; nothing else stops.
"""

from __future__ import annotations

import logging
import re
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import IO, Final, Protocol

from tandem.executive.records.mcap_writing import McapFile, SchemaOf
from tandem.executive.records.recording import Attachment, Facts, Recorded
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.records import RecordingState

FLUSH_EVERY: Final = 1.0
"""Host seconds: what kill -9 costs at the most."""
DAY: Final = 86_400.0
NAME: Final = re.compile(r"\d{8}T\d{6}Z(-\d+)?\.mcap")
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
    ) -> None:
        self._folder, self._facts, self._clocks, self._bounds = folder, facts, clocks, bounds
        self._schema_of, self._tell, self._shows, self._opens = schema_of, tell, shows, opens
        self._last: dict[str, Recorded] = {}
        self._attachments: dict[str, Attachment] = {}
        self._stream: IO[bytes] | None = None
        self._file: McapFile | None = None
        self._path: Path | None = None
        self._opened_at = self._flushed_at = 0.0
        self._stopped = False

    @property
    def path(self) -> Path | None:
        """The file that is written; None before the first message, and once recording has stopped."""
        return self._path

    def take(self, messages: Iterable[Recorded]) -> None:
        """Write messages."""
        if self._stopped:
            return
        try:
            for message in messages:
                self._write(message)
            self._look_after()
        except OSError as error:
            self._stop(error)

    def also(self, write: Callable[[McapFile], None]) -> None:
        """Have something else written into the file, such as a picture."""
        if self._file is None or self._stopped:
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
        if self._file is None or self._stopped:
            return
        try:
            self._file.attach(attachment)
        except OSError as error:
            self._stop(error)

    def close(self) -> None:
        """End the file. Closing twice is allowed."""
        if self._file is None or self._stopped:
            return
        try:
            self._finish()
        except OSError as error:
            self._stop(error)

    def _write(self, message: Recorded) -> None:
        if self._file is None:
            self._open(message.at)
        assert self._file is not None
        self._file.put(message)
        if self._shows is not None:
            self._shows(self._file, message)
        self._last.pop(message.key, None)
        self._last[message.key] = message

    def _look_after(self) -> None:
        now = self._clocks.monotonic()
        if self._file is None or self._stream is None or now - self._flushed_at < FLUSH_EVERY:
            return
        self._flushed_at = now
        self._file.flush()
        too_large = self._stream.tell() >= self._bounds.file_bytes
        if too_large or now - self._opened_at >= self._bounds.file_seconds:
            self._finish()

    def _open(self, begin: float) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._let_go()
        path = self._free()
        self._stream = self._opens(path)
        self._path = path
        self._opened_at = self._flushed_at = self._clocks.monotonic()
        self._file = McapFile(self._stream, self._facts, begin, self._schema_of)
        for attachment in self._attachments.values():
            self._file.attach(attachment)
        for message in self._last.values():
            self._file.put(message)
        self._file.flush()
        self._tell(RecordingState(recording=True, file=str(path)))

    def _finish(self) -> None:
        assert self._file is not None
        assert self._stream is not None
        self._file.finish()
        self._stream.close()
        self._file = self._stream = None

    def _stop(self, error: OSError) -> None:
        self._stopped = True
        path, reason = self._path, error.strerror or str(error)
        _LOG.error("recording stopped: %s: %s", path or self._folder, reason)
        if self._stream is not None:
            with suppress(OSError):
                self._stream.close()
        self._file = self._stream = self._path = None
        self._tell(RecordingState(recording=False, file=str(path or ""), reason=reason))

    def _free(self) -> Path:
        stem = f"{datetime.fromtimestamp(self._clocks.utc(), UTC):%Y%m%dT%H%M%SZ}"
        path, number = self._folder / f"{stem}.mcap", 1
        while path.exists():
            number += 1
            path = self._folder / f"{stem}-{number}.mcap"
        return path

    def _let_go(self) -> None:
        """Remove the oldest recordings, so that the next one has its place."""
        paths = sorted(each for each in self._folder.iterdir() if NAME.fullmatch(each.name))
        sizes = {each: each.stat() for each in paths}
        total = sum(each.st_size for each in sizes.values()) + self._bounds.file_bytes
        oldest = self._clocks.utc() - self._bounds.folder_days * DAY
        for path in paths:
            if total <= self._bounds.folder_bytes and sizes[path].st_mtime >= oldest:
                break
            total -= sizes[path].st_size
            path.unlink(missing_ok=True)
