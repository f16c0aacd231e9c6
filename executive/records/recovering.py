"""Mends a record that was cut: what can be read is written into another file, whole."""

from __future__ import annotations

import os
from pathlib import Path
from typing import IO, Final

from tandem.executive.records.lines_file import LINES, read_lines, write_lines
from tandem.executive.records.recording import GZIP, MCAP, RecordError, Span

RECOVERED: Final = "recovered"
"""Put before the suffix of the new file's name."""


def recovered_name(path: Path) -> Path:
    """Return where the mended file goes unless somebody says."""
    suffix = "".join(path.suffixes[-2:]) if path.name.endswith(LINES) else path.suffix
    return path.with_name(f"{path.name.removesuffix(suffix)}.{RECOVERED}{suffix}")


def recover(path: Path, target: Path) -> int:
    """Write what can be read of ``path`` into ``target``; return how many messages of ours that is.

    Raises:
        RecordError: when it is no record, nothing of it can be read, or the target is there already.
        OSError: when the target can't be written.
    """
    if target.exists():
        raise RecordError(target, "no such file yet", "one", "name another with --output, or remove it")
    with path.open("rb") as file:
        first = file.read(len(MCAP))
    if first == MCAP:
        return _recover_mcap(path, target)
    if first.startswith(GZIP):
        read = read_lines(path)
        end = max((each.at for each in read.messages), default=read.span.begin)
        return write_lines(target, read.facts, Span(read.span.begin, end), read.attachments, read.messages)
    raise RecordError(path, "a record of Tandem", "another kind of file", "there is nothing to recover")


def _recover_mcap(path: Path, target: Path) -> int:
    from mcap.exceptions import McapError  # noqa: PLC0415 - of the extra `record`

    from tandem.executive.records.mcap_copy import copy_records  # noqa: PLC0415

    part = target.with_name(f".{target.name}.part")
    try:
        with path.open("rb") as source, part.open("wb") as made:
            count = copy_records(source, made)
            _to_disk(made)
        if not count:
            raise RecordError(path, "at least one whole chunk", "none", "nothing of it can be recovered")
        part.replace(target)
    except McapError as error:
        raise RecordError(path, "an MCAP file", str(error), "nothing of it can be recovered") from error
    finally:
        part.unlink(missing_ok=True)
    return count


def _to_disk(file: IO[bytes]) -> None:
    file.flush()
    os.fsync(file.fileno())
