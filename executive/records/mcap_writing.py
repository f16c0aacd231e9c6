"""Writes one MCAP file: what ``mcap_file`` reads, and what Foxglove knows by itself.

``flush`` ends the chunk: after a kill -9 all that was flushed can be read back (``recovering``).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import IO, Final

from mcap.writer import CompressionType, Writer

from tandem.executive.records.mcap_file import BOOT, FACTS, NANO, OURS, packed
from tandem.executive.records.recording import LAYOUT, Attachment, Facts, Recorded
from tandem.skills.ports.message import RobotTime

CHUNK_BYTES: Final = 1024 * 1024
"""Uncompressed: about two seconds of a robot with a hundred messages a second of 4 kB."""


@dataclass(frozen=True)
class Schema:
    """What a channel's messages look like."""

    name: str
    encoding: str
    """``jsonschema`` or ``protobuf``."""
    data: bytes


SchemaOf = Callable[[str], Schema | None]
"""Returns the schema of a key's messages; None for a key that nobody declares."""


@dataclass(eq=False)
class McapFile:
    """One file at work.

    Args:
        file: written to; its owner closes it.
        facts: what it is of.
        begin: from when on it is whole (``Span.begin``).
        schema_of: for keys.

    Raises:
        OSError: from every method, when the disk does not take it.
    """

    file: IO[bytes]
    facts: Facts
    begin: float
    schema_of: SchemaOf
    messages: int = 0
    """Messages of ours that were written."""
    _writer: Writer = field(init=False)
    _channels: dict[tuple[str, str], int] = field(default_factory=dict)
    _schemas: dict[str, int] = field(default_factory=dict)
    _boot: tuple[str, float] | None = None

    def __post_init__(self) -> None:
        self._writer = Writer(self.file, chunk_size=CHUNK_BYTES, compression=CompressionType.ZSTD)
        self._writer.start(profile="", library=f"tandem {self.facts.release}")
        told = {"layout": str(LAYOUT), "facts": self.facts.model_dump_json(), "begin": repr(self.begin)}
        self._writer.add_metadata(FACTS, told)

    def put(self, message: Recorded) -> None:
        """Write a message of the bus."""
        kind = "json" if message.encoding == "json" else "bytes"
        channel = self._channels.get((message.key, kind))
        if channel is None:
            schema = self.schema_of(message.key) if kind == "json" else None
            how = "json" if kind == "json" else "application/octet-stream"
            channel = self._channel(message.key, how, schema, {OURS: kind})
        self._add(channel, message, message.payload)
        self.messages += 1

    def show(
        self, topic: str, schema: Schema, data: bytes, when: Recorded, metadata: dict[str, str] | None = None
    ) -> None:
        """Write what Foxglove draws, at the time of the message that it was made of."""
        channel = self._channels.get((topic, "protobuf"))
        if channel is None:
            channel = self._channel(topic, "protobuf", schema, metadata or {})
        self._add(channel, when, data)

    def attach(self, attachment: Attachment) -> None:
        """Write a document beside the messages."""
        at = max(0, round(attachment.at * NANO))
        self._writer.flush()
        data, media = packed(attachment.data, attachment.media)
        self._writer.add_attachment(at, at, attachment.name, media, data)

    def flush(self) -> None:
        """Hand what was written to the system."""
        self._writer.flush()

    def finish(self) -> None:
        """Write the index at the end."""
        self._writer.finish()
        self.file.flush()

    def _channel(self, topic: str, encoding: str, schema: Schema | None, metadata: dict[str, str]) -> int:
        number = 0
        if schema is not None:
            number = self._schemas.get(schema.name, 0)
            if not number:
                number = self._writer.register_schema(schema.name, schema.encoding, schema.data)
                self._schemas[schema.name] = number
        made = self._writer.register_channel(topic, encoding, number, metadata)
        kind = encoding if encoding == "protobuf" else metadata.get(OURS, "")
        self._channels[topic, kind] = made
        return made

    def _add(self, channel: int, when: Recorded, data: bytes) -> None:
        offset = _offset(when.at, when.stamp)
        boot = ("" if when.stamp is None else when.stamp.boot, offset)
        if boot != self._boot:
            self._boot = boot
            self._writer.flush()
            self._writer.add_metadata(BOOT, {"boot": boot[0], "offset": repr(offset)})
        time = 0 if when.stamp is None else max(0, round(when.stamp.seconds * NANO))
        self._writer.add_message(channel, time, data, when.host)


def _offset(at: float, stamp: RobotTime | None) -> float:
    """Return what to add to a robot time of this boot to get ``at``."""
    return round(at if stamp is None else at - stamp.seconds, 6)
