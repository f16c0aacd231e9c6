"""A file of lines that are added one by one: whole after a crash, and whole after a write that failed."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

from tandem.skills.synced_file import replace_file

_CLOSED: Final = -1


class JournalFile:
    """Adds lines to a file, and rewrites it when it has become long.

    A full disk costs the call that met it and nothing else: what was in the file stays as it was, and the
    next call tries again.

    Args:
        path: where it is, or is to be; its folder must exist.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = _CLOSED

    def lines(self) -> list[str]:
        """Return the whole lines that the file has; none, where there is no file.

        Raises:
            OSError: when it can't be read.
        """
        try:
            text = self._path.read_text(encoding="utf-8", errors="replace")
        except FileNotFoundError:
            return []
        return text[: text.rfind("\n") + 1].splitlines()

    def append(self, line: str, *, synced: bool = True) -> None:
        """Add a line; if ``synced``, it is on the disk when the call returns.

        Raises:
            OSError: when it can't be written; then the file is as it was.
        """
        if self._file == _CLOSED:
            self._file = _open(self._path)
        size = os.fstat(self._file).st_size
        try:
            self._write(f"{line}\n".encode())
            if synced:
                os.fdatasync(self._file)
        except OSError:
            os.ftruncate(self._file, size)  # half a line would swallow the beginning of the next one
            raise

    def _write(self, document: bytes) -> None:
        written = os.write(self._file, document)
        if written < len(document):  # as a disk does that is full in the middle of it
            raise OSError(f"{self._path}: {written} of {len(document)} bytes could be written")

    def rewrite(self, lines: list[str]) -> None:
        """Have the file hold these lines alone.

        Raises:
            OSError: when it can't be written; then the file is as it was.
        """
        replace_file(self._path, "".join(f"{line}\n" for line in lines))
        self.close()  # what is open is the old file

    def close(self) -> None:
        """Close the file. Closing twice is allowed."""
        if self._file != _CLOSED:
            os.close(self._file)
            self._file = _CLOSED


def _open(path: Path) -> int:
    """Open a file for appending; a line that a crash tore is cut off, or the next one would continue it."""
    file = os.open(path, os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC, 0o644)
    whole = path.read_bytes().rfind(b"\n") + 1
    if whole < os.fstat(file).st_size:
        os.ftruncate(file, whole)
    return file
