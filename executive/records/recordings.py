"""Which recordings are kept, by the names of their files: nothing is opened."""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Final

from tandem.executive.records.dated import STAMP, began_of
from tandem.skills.ports.records import RecordingFile

MOST: Final = 100
"""Files that are told: 8 GB of 256 MB are 32, and a short one for each start."""
NAME: Final = re.compile(rf"{STAMP}(-\d+)?\.mcap")
"""Of a recording's file: when it was begun, and which of those of one second it is."""


def recordings_in(folders: Iterable[Path]) -> tuple[RecordingFile, ...]:
    """Return the newest recordings, oldest first; a folder that can't be read has none."""
    found: list[RecordingFile] = []
    for folder in folders:
        with suppress(OSError):
            found += (each for path in folder.iterdir() if (each := _file(path)) is not None)
    return tuple(sorted(found, key=lambda each: (each.began, each.file))[-MOST:])


def _file(path: Path) -> RecordingFile | None:
    began = began_of(path)
    if began is None or not NAME.fullmatch(path.name):
        return None
    try:
        stat = path.stat()
    except OSError:
        return None  # it has gone meanwhile
    return RecordingFile(file=str(path), size=stat.st_size, began=began, written=stat.st_mtime)
