"""Reads an MCAP file while it is written: what has been flushed so far, at the most a second ago.

Its index comes with its end. Until then the records are walked through from head to head: of a chunk only the
times are read, and of what follows it the channels.
"""

from __future__ import annotations

import struct
from io import BytesIO
from pathlib import Path
from typing import Final

from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Attachment as McapAttachment
from mcap.records import Channel, Metadata

from tandem.executive.records.mcap_file import (
    BOOT,
    FACTS,
    NANO,
    Boot,
    McapRecording,
    Part,
    closed_unless_read,
    facts_in,
    part_at,
    unpacked,
)
from tandem.executive.records.recording import MCAP, Attachment, Span

_HEAD: Final = struct.Struct("<BQ")
"""Of a record: its kind, and the bytes that follow."""
_TIMES: Final = struct.Struct("<QQ")
"""What a chunk begins with."""
_CHANNEL: Final = struct.Struct("<H")
"""What the index of a chunk's messages of one channel begins with."""


class GrowingRecording(McapRecording):
    """A file of ours that is written; implements ``Recording``. It may be at its end meanwhile.

    Raises:
        RecordError: for one that can't be used.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file = path.open("rb")
        self._place = len(MCAP)
        self._parts = ()
        self._channels = {}
        self.attachments = ()
        self._boot = Boot(0, "", 0.0)
        self._told: dict[str, str] = {}
        self._head: int | None = None
        """Where the chunk begins whose channels are read."""
        self._of_chunk: set[int] = set()
        with closed_unless_read(path, self._file):
            self._scan()
            self.facts, begin = facts_in(path, self._told)
        self.span = Span(begin, begin)
        self.grow()

    def grow(self) -> None:
        """Take in what has been written since."""
        self._scan()
        self.span = Span(self.span.begin, max((each.end for each in self._parts), default=self.span.begin))

    def _scan(self) -> None:
        self._file.seek(0, 2)
        size = self._file.tell()
        parts = list(self._parts)
        while self._place + _HEAD.size <= size:
            self._file.seek(self._place)
            kind, length = _HEAD.unpack(self._file.read(_HEAD.size))
            if self._place + _HEAD.size + length > size or kind == Opcode.DATA_END:
                break
            self._take(kind, length, parts)
            self._place += _HEAD.size + length
        self._parts = tuple(parts)

    def _take(self, kind: int, length: int, parts: list[Part]) -> None:
        if kind == Opcode.MESSAGE_INDEX:
            self._index(_CHANNEL.unpack(self._file.read(_CHANNEL.size))[0])
            return
        if self._head is not None:  # all its channels have come
            last = parts[-1]
            parts[-1] = Part(last.place, last.boot, last.begin, last.end, frozenset(self._of_chunk))
            self._head = None
        if kind == Opcode.CHUNK:
            times = _TIMES.unpack(self._file.read(_TIMES.size))
            self._head, self._of_chunk = self._place, set()
            parts.append(part_at(self._place, self._boot, times, None))
        elif kind == Opcode.METADATA:
            told = Metadata.read(self._body(length))
            if told.name == BOOT:
                self._boot = Boot(self._place, told.metadata["boot"], float(told.metadata["offset"]))
            elif told.name == FACTS:
                self._told = told.metadata
        elif kind == Opcode.ATTACHMENT:
            read = McapAttachment.read(self._body(length))
            data = unpacked(read.data, read.media_type)
            self.attachments = (*self.attachments, Attachment(read.name, read.log_time / NANO, *data))

    def _index(self, channel: int) -> None:
        if self._head is None:
            return
        self._of_chunk.add(channel)
        if channel not in self._channels:  # it is described in the first chunk that has it
            found = [each for each in self._records(self._head) if isinstance(each, Channel)]
            self._channels |= {each.id: each for each in found}

    def _body(self, length: int) -> ReadDataStream:
        return ReadDataStream(BytesIO(self._file.read(length)))
