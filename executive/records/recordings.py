"""Which recordings are kept, by the names of their files: nothing is opened."""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from tandem.skills.ports.records import RecordingFile

MOST: Final = 100
"""Files that are told: 8 GB of 256 MB are 32, and a short one for each start."""
_NAME: Final = re.compile(r"(\d{8}T\d{6}Z)(-\d+)?\.mcap")


def recordings_in(folders: Iterable[Path]) -> tuple[RecordingFile, ...]:
    """Return the newest recordings, oldest first; a folder that can't be read has none."""
    found: list[RecordingFile] = []
    for folder in folders:
        with suppress(OSError):
            found += (each for path in folder.iterdir() if (each := _file(path)) is not None)
    return tuple(sorted(found, key=lambda each: (each.began, each.file))[-MOST:])


def _file(path: Path) -> RecordingFile | None:
    name = _NAME.fullmatch(path.name)
    try:
        if name is None:
            return None
        began = datetime.strptime(name[1], "%Y%m%dT%H%M%SZ").replace(tzinfo=UTC).timestamp()
        stat = path.stat()
    except (OSError, ValueError):
        return None  # it has gone meanwhile, or has another's name
    return RecordingFile(file=str(path), size=stat.st_size, began=began, written=stat.st_mtime)
