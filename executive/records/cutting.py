"""Cuts a part out of a record: a record again, of the same kind, that begins with what was known then."""

from __future__ import annotations

import os
from collections.abc import Iterator
from heapq import merge
from pathlib import Path
from typing import Final

from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import MCAP, Recorded, RecordError, Recording, Span
from tandem.executive.records.tape import Tape

LATELY: Final = 1.0
"""Robot seconds: a picture from before a part stands for it if it is no older."""


def cut(record: Recording, target: Path, part: Span) -> int:
    """Write what lies between two moments into another file; return how many messages that is.

    An MCAP file is cut into one with our messages and pictures; what else only Foxglove draws is left out.

    Raises:
        RecordError: when the target is there already, or nothing lies between the moments.
        OSError: when it can't be written.
    """
    if target.exists():
        raise RecordError(target, "no such file yet", "one", "name another with --output, or remove it")
    if part.end < record.span.begin or part.begin > record.span.end or part.begin > part.end:
        expected = f"moments from {record.span.begin:.1f} to {record.span.end:.1f} s"
        found = f"{part.begin:.1f} to {part.end:.1f} s"
        raise RecordError(record.path, expected, found, "`tandem log info` shows what it spans")
    part = Span(record.span.clipped(part.begin), record.span.clipped(part.end))
    attachments = [each for each in record.attachments if each.at <= part.end]
    with record.path.open("rb") as file:
        is_mcap = file.read(len(MCAP)) == MCAP
    if not is_mcap:
        return write_lines(target, record.facts, part, attachments, _within(record, part))
    from tandem.executive.records.foxglove_view import put_picture  # noqa: PLC0415 - of the extra `record`
    from tandem.executive.records.json_schemas import JsonSchemas  # noqa: PLC0415
    from tandem.executive.records.mcap_writing import McapFile  # noqa: PLC0415

    unfinished = target.with_name(f".{target.name}.part")
    try:
        with unfinished.open("wb") as made:
            written = McapFile(made, record.facts, part.begin, JsonSchemas().of)
            for attachment in attachments:
                written.attach(attachment)
            for message in merge(_within(record, part), _pictures(record, part), key=lambda each: each.at):
                if message.encoding == "jpeg":
                    put_picture(written, message.key, message.key.split("/")[2], message.payload, message)
                else:
                    written.put(message)
            written.finish()
            os.fsync(made.fileno())
        unfinished.replace(target)
    finally:
        unfinished.unlink(missing_ok=True)
    return written.messages


def _within(record: Recording, part: Span) -> Iterator[Recorded]:
    """Yield the last message of each key from before the part, then the part."""
    tape = Tape(record)
    before: dict[str, Recorded] = {}
    for message in tape.walk(part.begin):
        if message.at >= part.begin:
            break
        before.pop(message.key, None)
        before[message.key] = message
    yield from before.values()
    yield from record.messages(part.begin, part.end)


def _pictures(record: Recording, part: Span) -> Iterator[Recorded]:
    """Yield the last picture of each camera from shortly before the part, then those of the part."""
    before = {
        each.key: each for each in record.pictures(part.begin - LATELY, part.begin) if each.at < part.begin
    }
    yield from sorted(before.values(), key=lambda each: each.at)
    yield from record.pictures(part.begin, part.end)
