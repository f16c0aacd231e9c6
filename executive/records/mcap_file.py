"""MCAP, as ``tandem up --record`` writes it: our messages as JSON under their keys, and what Foxglove draws.

``log_time`` is robot time, ``publish_time`` the host's, both in nanoseconds. A metadata record ``tandem``
says what the file is. One called ``boot`` stands where the robot time of another boot begins. It says what to
add to a robot time of that boot to get ``at`` (``recording.Recorded``).
"""

from __future__ import annotations

import gzip
import math
import struct
import zlib
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO, Final

from tandem.executive.config.extras import RECORD, words_on
from tandem.executive.records.recording import (
    MCAP,
    Attachment,
    BootSpan,
    Encoding,
    Facts,
    Recorded,
    RecordError,
    Span,
    check_layout,
    finite,
)
from tandem.skills.ports.message import RobotTime, read_leniently
from tandem.skills.ports.plain_json import read_json

try:
    from mcap.exceptions import McapError
    from mcap.reader import SeekingReader
    from mcap.records import Channel, Chunk, ChunkIndex, McapRecord, Message, MetadataIndex
    from mcap.stream_reader import StreamReader, breakup_chunk
    from zstandard import ZstdError
except ModuleNotFoundError as error:
    raise ModuleNotFoundError(
        words_on(RECORD, "what reads an .mcap file") or str(error), name="mcap"
    ) from error

FACTS: Final = "tandem"
"""Metadata: ``layout``, ``facts`` (a ``Facts`` as JSON) and ``begin`` (the span's)."""
BOOT: Final = "boot"
"""Metadata: the ``boot`` of what follows (empty: none heard yet), and ``offset`` in seconds."""
OURS: Final = "tandem"
"""In a channel's metadata: ``json`` or ``bytes`` for what was put on the bus, ``jpeg`` for pictures."""
PUBLISHED: Final = ("json", "bytes")
PACKED: Final = "+gzip"
"""At the end of an attachment's type: MCAP compresses messages, not these."""
NANO: Final = 1_000_000_000
"""Nanoseconds of a second: MCAP's times are whole numbers of them."""
DAMAGED: Final = (
    McapError, ZstdError, OSError, EOFError, zlib.error, struct.error, ValueError, LookupError, MemoryError,
    StopIteration,
)  # fmt: skip
"""How readers of MCAP, of zstd and of gzip (its BadGzipFile is an OSError) say that bytes are not as they
were written."""
_PICTURE_DATA: Final = 2
"""Number of the field ``data`` in foxglove's CompressedImage."""
_LENGTH_DELIMITED: Final = 2
"""Protobuf's wire type of text, bytes and messages: their length comes first."""
_WIDTHS: Final = {1: 8, 5: 4}
"""Bytes of the wire types of a fixed width: they are passed over."""


@dataclass(frozen=True)
class Boot:
    """From where in the file on which boot counts."""

    place: int
    name: str
    offset: float


@dataclass(frozen=True)
class Part:
    """A chunk: where it is, from when to when its messages are, and of which channels."""

    place: int
    boot: Boot
    begin: float
    end: float
    channels: frozenset[int] | None
    """None: not known yet, it may have any."""


class McapRecording:
    """An MCAP file of ours; implements ``Recording``.

    Raises:
        RecordError: for one that can't be used.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        _require_whole(path)
        self._file: IO[bytes] = path.open("rb")
        with closed_unless_read(path, self._file):
            self._read_index()

    def _read_index(self) -> None:
        self._reader = SeekingReader(self._file)
        summary = self._reader.get_summary()
        if summary is None:
            advice = f"`tandem log recover {self.path}` makes one"
            raise RecordError(self.path, "a summary at its end", "none", advice)
        self.facts, begin = facts_in(self.path, self._metadata(FACTS))
        self._channels = summary.channels
        self._parts = _parts(summary.chunk_indexes, self._boots(summary.metadata_indexes))
        self.attachments = tuple(
            Attachment(each.name, each.log_time / NANO, *unpacked(each.data, each.media_type))
            for each in self._reader.iter_attachments()
        )
        self.span = Span(begin, max((each.end for each in self._parts), default=begin))

    def messages(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the messages between two moments."""
        return (each for each in self._read(since, until, pictures=False) if each.encoding != "jpeg")

    def pictures(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the pictures between two moments."""
        return (each for each in self._read(since, until, pictures=True) if each.encoding == "jpeg")

    def known(self, at: float) -> dict[str, Recorded]:
        """Return the last message of each key up to and with a moment: from the chunks that have them."""
        wanted = {number for number, each in self._channels.items() if each.metadata.get(OURS) in PUBLISHED}
        found: list[tuple[int, int, Recorded]] = []
        for part in reversed(self._parts):
            mine = wanted if part.channels is None else wanted & part.channels
            if part.begin > at or not mine:
                continue
            last: dict[int, tuple[int, int, Recorded]] = {}
            latest = at if math.isinf(at) else round((at - part.boot.offset) * NANO)
            for number, message in enumerate(self._chunk(part)):
                if message.channel_id in mine and message.log_time <= latest:
                    read = _recorded(message, self._channels[message.channel_id], part.boot)
                    if read is not None:
                        last[message.channel_id] = (part.place, number, read)
            wanted -= last.keys()
            found += last.values()
        ordered = [each for _, _, each in sorted(found, key=lambda each: each[:2])]
        by_key = {each.key: each for each in ordered}  # of a key that had JSON and bytes, the later one
        return {each.key: each for each in ordered if by_key[each.key] is each}

    def boots(self) -> tuple[BootSpan, ...]:
        """Return the boots whose time it has."""
        found: dict[str, BootSpan] = {}
        for part in self._parts:
            boot = part.boot
            if boot.name and part.end >= self.span.begin:
                first = BootSpan(boot.name, max(part.begin, self.span.begin) - boot.offset, 0.0, boot.offset)
                known = found.get(boot.name, first)
                found[boot.name] = replace(known, end=max(known.end, part.end - boot.offset))
        return tuple(found.values())

    def grow(self) -> None:
        """Do nothing: it is whole."""

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _read(self, since: float, until: float, *, pictures: bool) -> Iterator[Recorded]:
        for part in self._parts:
            if part.end < since or part.begin > until:
                continue
            for message in self._chunk(part):
                channel = self._channels[message.channel_id]
                if (channel.metadata.get(OURS) == "jpeg") is not pictures:
                    continue
                read = _recorded(message, channel, part.boot)
                if read is not None and since <= read.at <= until:
                    yield read

    def _chunk(self, part: Part) -> Iterable[Message]:
        return (each for each in self._records(part.place) if isinstance(each, Message))

    def _records(self, place: int) -> list[McapRecord]:
        """Return what stands in a chunk."""
        try:
            self._file.seek(place)
            chunk = next(StreamReader(self._file, skip_magic=True, emit_chunks=True).records)
            if isinstance(chunk, Chunk):
                return breakup_chunk(chunk, validate_crc=True)
        except DAMAGED as error:
            raise damaged(self.path, error) from error
        raise damaged(self.path, ValueError("another record where a chunk should be"))

    def _metadata(self, name: str) -> dict[str, str]:
        return next((each.metadata for each in self._reader.iter_metadata() if each.name == name), {})

    def _boots(self, indexes: Iterable[MetadataIndex]) -> list[Boot]:
        places = [each.offset for each in indexes]
        told = zip(places, self._reader.iter_metadata(), strict=True)
        return [
            Boot(place, each.metadata["boot"], float(each.metadata["offset"]))
            for place, each in told
            if each.name == BOOT
        ]


@contextmanager
def closed_unless_read(path: Path, file: IO[bytes]) -> Iterator[None]:
    """Close the file and say what is wrong with it when it can't be read."""
    try:
        yield
    except RecordError:
        file.close()
        raise
    except DAMAGED as error:
        file.close()
        raise damaged(path, error) from error


def damaged(path: Path, error: BaseException) -> RecordError:
    """Return what to say of a file whose bytes are not what was written."""
    found = str(error).partition("\n")[0] or type(error).__name__
    return RecordError(path, "an MCAP file as it was written", found, f"try `tandem log recover {path}`")


def _require_whole(path: Path) -> None:
    with path.open("rb") as file:
        file.seek(0, 2)
        size = file.tell()
        file.seek(max(0, size - len(MCAP)))
        if size > len(MCAP) and file.read() == MCAP:
            return
    raise RecordError(
        path,
        "a file with its end",
        "one that was cut, or that is still written",
        f"`tandem log recover {path}` writes what can be read into another file",
    )


def facts_in(path: Path, told: dict[str, str]) -> tuple[Facts, float]:
    """Return what a file is of and the begin of its span, out of its metadata; RecordError without them."""
    layout = told.get("layout", "")
    written = told.get("facts", "")
    try:
        release = str(read_json(written).get("release", "")) if written else ""
        check_layout(path, int(layout) if layout.isdecimal() else None, release)
        return read_leniently(Facts, written.encode()), finite(told["begin"])
    except RecordError:
        raise
    except (KeyError, AttributeError, ValueError) as error:
        found = str(error).partition("\n")[0]
        raise RecordError(path, "facts of a record in its metadata", found, "the file was changed") from error


def _parts(indexes: Iterable[ChunkIndex], boots: list[Boot]) -> tuple[Part, ...]:
    places = [each.place for each in boots]

    def part(index: ChunkIndex) -> Part:
        boot = boots[bisect_right(places, index.chunk_start_offset) - 1]
        begin, end = index.message_start_time, index.message_end_time
        return part_at(
            index.chunk_start_offset, boot, (begin, end), frozenset(index.message_index_offsets) or None
        )

    found = [part(index) for index in indexes]
    return tuple(sorted(found, key=lambda each: each.place))


def part_at(place: int, boot: Boot, times: tuple[int, int], channels: frozenset[int] | None) -> Part:
    """Return a chunk of a boot; ``times``: of its first and last message, in nanoseconds of the robot."""
    begin, end = (round(boot.offset + time / NANO, 9) for time in times)
    return Part(place, boot, begin, end, channels)


def _recorded(message: Message, channel: Channel, boot: Boot) -> Recorded | None:
    """Return a message of ours; None for what only Foxglove draws."""
    kind = channel.metadata.get(OURS, "")
    if kind not in {"json", "bytes", "jpeg"}:
        return None
    seconds = round(message.log_time / NANO, 9)
    stamp = RobotTime(boot=boot.name, seconds=seconds) if boot.name else None
    encoding: Encoding = "json" if kind == "json" else "bytes" if kind == "bytes" else "jpeg"
    payload = picture_in(message.data) if kind == "jpeg" else message.data
    key = channel.metadata.get("key", channel.topic)
    return Recorded(key, round(boot.offset + seconds, 9), stamp, message.publish_time, payload, encoding)


def packed(data: bytes, media: str) -> tuple[bytes, str]:
    """Return an attachment as it stands in a file: compressed if that is worth it, which its type says."""
    small = gzip.compress(data, mtime=0)
    return (small, f"{media}{PACKED}") if len(small) < len(data) else (data, media)


def unpacked(data: bytes, media: str) -> tuple[bytes, str]:
    """Return an attachment as it was, and its type."""
    if not media.endswith(PACKED):
        return data, media
    return gzip.decompress(data), media.removesuffix(PACKED)


def picture_in(message: bytes) -> bytes:
    """Return the field ``data`` of foxglove's CompressedImage (protobuf), which has no other bytes."""
    place = 0
    while place < len(message):
        tag, place = _varint(message, place)
        kind = tag & 7
        if kind == _LENGTH_DELIMITED:
            length, place = _varint(message, place)
            if tag >> 3 == _PICTURE_DATA:
                return message[place : place + length]
            place += length
        elif kind in _WIDTHS:
            place += _WIDTHS[kind]
        else:
            _, place = _varint(message, place)
    return b""


def _varint(data: bytes, place: int) -> tuple[int, int]:
    value = shift = 0
    while True:
        byte = data[place]
        place += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:  # noqa: PLR2004 - the last one has no high bit
            return value, place
        shift += 7
