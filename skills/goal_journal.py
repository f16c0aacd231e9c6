"""Which goals a process of skills has accepted, on disk: so that an id starts once, also after a restart.

One id a line, synced before the goal starts. A line torn by a crash is an id that nothing was started for.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

from skills.synced_file import replace_file

KEPT: Final = 512
"""Ids of before that are remembered: none that old is sent again."""
COMPACT_AFTER: Final = 4096
"""Lines after which the file is rewritten."""


class GoalJournal:
    """The file of one process; the servers in it share it.

    Args:
        path: where it is, or is to be; its folder must exist.

    Raises:
        OSError: when it can't be read or written.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._ids = dict.fromkeys(_ids(path))
        self.before = frozenset(self._ids)
        """The ids that were accepted before this start."""
        self._lines = 0
        self._compact()

    def accept(self, goal_id: str) -> None:
        """Keep an id; it is on the disk when the call returns."""
        self._ids[goal_id] = None
        if self._lines >= COMPACT_AFTER:
            self._compact()
            return
        os.write(self._file, f"{goal_id}\n".encode())
        os.fdatasync(self._file)
        self._lines += 1

    def close(self) -> None:
        """Close the file. Closing twice is allowed."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    _file: int = -1

    def _compact(self) -> None:
        self.close()
        self._ids = dict.fromkeys(list(self._ids)[-KEPT:])
        replace_file(self._path, "".join(f"{goal_id}\n" for goal_id in self._ids))
        self._file = os.open(self._path, os.O_WRONLY | os.O_APPEND | os.O_CLOEXEC)
        self._lines = len(self._ids)


def _ids(path: Path) -> list[str]:
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return []
    whole = text[: text.rfind("\n") + 1]
    return whole.splitlines()
