"""The black box's own file: gzip of JSON lines, written with the standard library alone.

The first line says what the file is (``{"tandem": "record", "layout": 1, "facts": {...}, "span": [a, b]}``),
the last how many messages it has (``{"end": n}``). Between them stand, in the order in which they were heard:

- ``{"boot": "name"}``: the boot of the robot time of all that follows; ``null`` before the clock was heard;
- ``[key, at, seconds, host, payload]``: a message; ``seconds`` is its robot time, ``host`` nanoseconds since
  1970, the payload text; one that is no UTF-8 is in base64, with ``"bytes"`` or ``"jpeg"`` as a sixth part;
- ``{"attachment": name, "at": at, "media": type, "data": text}``.
"""

from __future__ import annotations

import base64
import gzip
import json
import math
import os
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Final, cast

from pydantic import ValidationError

from tandem.executive.records.recording import (
    LAYOUT,
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

LINES: Final = ".jsonl.gz"
LEVEL: Final = 1
"""Of gzip: 6 takes five times as long for a file that is a fifth smaller."""
_KIND: Final = "record"


def write_lines(
    path: Path, facts: Facts, span: Span, attachments: Iterable[Attachment], messages: Iterable[Recorded]
) -> int:
    """Write a record whole or not at all; return its messages' number.

    Raises:
        OSError: when it can't be written; nothing is left of it then.
    """
    part = path.with_name(f".{path.name}.part")
    try:
        with part.open("wb") as raw:
            with gzip.GzipFile(fileobj=raw, mode="wb", compresslevel=LEVEL, mtime=0) as file:
                count = _write(file, facts, span, attachments, messages)
            raw.flush()
            os.fsync(raw.fileno())
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
    return count


def _write(
    file: gzip.GzipFile,
    facts: Facts,
    span: Span,
    attachments: Iterable[Attachment],
    messages: Iterable[Recorded],
) -> int:
    def line(value: object) -> None:
        file.write(json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode() + b"\n")

    told = facts.model_dump(mode="json")
    line({"tandem": _KIND, "layout": LAYOUT, "facts": told, "span": [span.begin, span.end]})
    for each in attachments:
        about = {"attachment": each.name, "at": each.at, "media": each.media}
        line({**about, "data": each.data.decode("utf-8", "replace")})
    boot: str | None = None
    count = 0
    for message in messages:
        stamp = message.stamp
        if (None if stamp is None else stamp.boot) != boot:
            boot = None if stamp is None else stamp.boot
            line({"boot": boot})
        line(_row(message))
        count += 1
    line({"end": count})
    return count


def _row(message: Recorded) -> list[object]:
    seconds = None if message.stamp is None else message.stamp.seconds
    head: list[object] = [message.key, message.at, seconds, message.host]
    if message.encoding == "json":
        try:
            return [*head, message.payload.decode()]
        except UnicodeDecodeError:
            return [*head, base64.b64encode(message.payload).decode(), "bytes"]
    return [*head, base64.b64encode(message.payload).decode(), message.encoding]


@dataclass
class Read:
    """What could be read of a file, and whether that is all."""

    facts: Facts
    span: Span
    attachments: list[Attachment] = field(default_factory=list)
    messages: list[Recorded] = field(default_factory=list)
    whole: bool = False


class LinesRecording:
    """A black box's file, held in memory; implements ``Recording``.

    Raises:
        RecordError: for one that can't be used.
    """

    def __init__(self, path: Path) -> None:
        read = read_lines(path)
        if not read.whole:
            raise RecordError(
                path,
                "a record with its last line",
                f"one that was cut after {len(read.messages)} messages",
                f"`tandem log recover {path}` keeps what can be read",
            )
        self.path, self.facts, self.span = path, read.facts, read.span
        self.attachments = tuple(read.attachments)
        self._messages = tuple(each for each in read.messages if each.encoding != "jpeg")
        self._pictures = tuple(each for each in read.messages if each.encoding == "jpeg")

    def messages(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the messages between two moments."""
        return (each for each in self._messages if since <= each.at <= until)

    def pictures(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the pictures between two moments."""
        return (each for each in self._pictures if since <= each.at <= until)

    def known(self, at: float) -> dict[str, Recorded]:
        """Return the last message of each key up to and with a moment."""
        last: dict[str, Recorded] = {}
        for message in self.messages(until=at):
            last.pop(message.key, None)
            last[message.key] = message  # the newest stands last
        return last

    def boots(self) -> tuple[BootSpan, ...]:
        """Return the boots whose time it has."""
        found: dict[str, BootSpan] = {}
        for message in self.messages(self.span.begin):
            if (stamp := message.stamp) is not None:
                known = found.get(stamp.boot)
                begin, offset = (
                    (stamp.seconds, message.at - stamp.seconds)
                    if known is None
                    else (known.begin, known.offset)
                )
                found[stamp.boot] = BootSpan(stamp.boot, begin, stamp.seconds, offset)
        return tuple(found.values())

    def grow(self) -> None:
        """Do nothing: it is whole."""

    def close(self) -> None:
        """Keep nothing open: the file was read whole."""


def read_lines(path: Path) -> Read:
    """Return what can be read of a file, up to where it was cut.

    Raises:
        RecordError: for one that is no record of ours, or of a newer release.
    """
    with path.open("rb") as raw, gzip.GzipFile(fileobj=raw) as file:
        lines = _lines(cast("IO[bytes]", file))
        read = _begun(path, next(lines, b""))
        try:
            _fill(read, lines)
        except (ValueError, KeyError, TypeError, IndexError) as error:
            raise RecordError(
                path,
                "lines of a record",
                f"another kind of line ({error})",
                "the file was changed; nothing mends it",
            ) from error
    return read


def read_facts(path: Path) -> Facts:
    """Return what a file is of, out of its first line.

    Raises:
        RecordError: for one that is no record of ours, or of a newer release.
    """
    with path.open("rb") as raw, gzip.GzipFile(fileobj=raw) as file:
        return _begun(path, next(_lines(cast("IO[bytes]", file)), b"")).facts


def _lines(file: IO[bytes]) -> Iterator[bytes]:
    """Yield the whole lines; a file that was cut ends where it was."""
    try:
        for line in file:
            if line.endswith(b"\n"):
                yield line
    except (EOFError, zlib.error, gzip.BadGzipFile):
        return


def _begun(path: Path, line: bytes) -> Read:
    try:
        head = read_json(line)
    except ValueError:
        head = None
    if not isinstance(head, dict) or head.get("tandem") != _KIND:
        check_layout(path, None, "")
    facts = head.get("facts")
    release = str(facts.get("release", "")) if isinstance(facts, dict) else ""
    check_layout(path, head.get("layout"), release)
    try:
        begin, end = head["span"]
        return Read(read_leniently(Facts, json.dumps(facts).encode()), _span(finite(begin), finite(end)))
    except (ValidationError, KeyError, TypeError, ValueError) as error:
        raise RecordError(
            path, "facts of a record in its first line", str(error).partition("\n")[0], "the file was changed"
        ) from error


def _span(begin: float, end: float) -> Span:
    if begin > end:
        raise ValueError(f"a span from {begin} to {end}")
    return Span(begin, end)


def _fill(read: Read, lines: Iterator[bytes]) -> None:
    boot: str | None = None
    for line in lines:
        value = read_json(line)
        if isinstance(value, list):
            read.messages.append(_recorded(value, boot))
        elif "boot" in value:
            boot = None if value["boot"] is None else _text(value["boot"])
        elif "attachment" in value:
            name, data, media = (_text(value[part]) for part in ("attachment", "data", "media"))
            read.attachments.append(Attachment(name, finite(value["at"]), data.encode(), media))
        elif "end" in value:
            read.whole = value["end"] == len(read.messages)


def _recorded(row: list[object], boot: str | None) -> Recorded:
    key, at, seconds, host, payload, *more = row
    if not isinstance(host, int):  # nanoseconds have more digits than a float keeps
        raise TypeError(f"expected nanoseconds, found {host!r}")
    stamp = None if boot is None or seconds is None else RobotTime(boot=boot, seconds=finite(seconds))
    about = (_text(key), finite(at), stamp, host)
    if not more:
        return Recorded(*about, _text(payload).encode())
    encoding: Encoding = "jpeg" if more[0] == "jpeg" else "bytes"
    return Recorded(*about, base64.b64decode(_text(payload)), encoding)


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"expected text, found {value!r}")
    return value
