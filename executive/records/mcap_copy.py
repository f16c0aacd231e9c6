"""Copies an MCAP file record by record, as far as it can be read: nothing of what it holds is understood."""

from __future__ import annotations

from collections.abc import Iterator
from typing import IO

from mcap.records import Attachment, Channel, Header, McapRecord, Message, Metadata, Schema
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, Writer

from tandem.executive.records.mcap_file import DAMAGED, OURS


def copy_records(source: IO[bytes], target: IO[bytes]) -> int:
    """Write all records up to where the source ends or breaks; return how many messages of ours they hold.

    A chunk is written in place with a length that is filled in later, so a file that was cut may end with one
    that has an absurd length: what stands before it is whole.
    """
    writer = Writer(target, compression=CompressionType.ZSTD)
    copy = _Copy(writer)
    for record in _as_far_as_it_goes(source):
        copy.take(record)
    copy.finish()
    return copy.ours


def _as_far_as_it_goes(source: IO[bytes]) -> Iterator[McapRecord]:
    # mcap speaks of a short read in several ways: its own errors, struct's, a length that is absurd.
    try:
        yield from StreamReader(source, record_size_limit=1 << 30, validate_crcs=True).records
    except DAMAGED:
        return


class _Copy:
    def __init__(self, writer: Writer) -> None:
        self._writer, self._started = writer, False
        self._schemas: dict[int, int] = {0: 0}
        self._channels: dict[int, tuple[int, bool]] = {}
        self.ours = 0

    def take(self, record: McapRecord) -> None:
        """Write a record; those of the index are made anew."""
        if isinstance(record, Header):
            self._start(record.profile, record.library)
        elif isinstance(record, Schema) and record.id not in self._schemas:
            made = self._writer.register_schema(record.name, record.encoding, record.data)
            self._schemas[record.id] = made
        elif isinstance(record, Channel) and record.id not in self._channels:
            schema = self._schemas.get(record.schema_id, 0)
            made = self._writer.register_channel(
                record.topic, record.message_encoding, schema, record.metadata
            )
            self._channels[record.id] = (made, record.metadata.get(OURS, "") in {"json", "bytes"})
        elif isinstance(record, Message) and record.channel_id in self._channels:
            channel, ours = self._channels[record.channel_id]
            self.ours += ours
            self._writer.add_message(
                channel, record.log_time, record.data, record.publish_time, record.sequence
            )
        elif isinstance(record, Metadata):
            self._writer.flush()  # what came before it in the file stays before it
            self._writer.add_metadata(record.name, record.metadata)
        elif isinstance(record, Attachment):
            self._writer.flush()
            self._writer.add_attachment(
                record.create_time, record.log_time, record.name, record.media_type, record.data
            )

    def finish(self) -> None:
        """Write the index."""
        if not self._started:
            self._start("", "")
        self._writer.finish()

    def _start(self, profile: str, library: str) -> None:
        if not self._started:
            self._started = True
            self._writer.start(profile, library)
