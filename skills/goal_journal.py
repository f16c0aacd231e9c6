"""Which goals a process of skills has accepted, on disk: so that an id starts once, also after a restart.

One id a line, synced before the goal starts. A line torn by a crash is an id that nothing was started for.
"""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Final

from tandem.skills.journal_file import JournalFile

KEPT: Final = 512
"""Ids of before that are remembered: none that old is sent again."""
COMPACT_AFTER: Final = 4096
"""Lines after which the file is rewritten."""

_LOG = logging.getLogger(__name__)


class GoalJournal:
    """The file of one process; the servers in it share it.

    Args:
        path: where it is, or is to be; its folder must exist.

    Raises:
        OSError: when it can't be read.
    """

    def __init__(self, path: Path) -> None:
        self._file = JournalFile(path)
        self._ids = dict.fromkeys(self._file.lines())
        self.before = frozenset(self._ids)
        """The ids that were accepted before this start."""
        self._lines = len(self._ids)
        try:
            self._compact()
        except OSError:
            _LOG.warning("%s could not be rewritten; it is used as it is", path, exc_info=True)

    def accept(self, goal_id: str) -> None:
        """Keep an id; it is on the disk when the call returns.

        Raises:
            OSError: when it can't be written; then the id is as unknown as before.
        """
        if self._lines >= COMPACT_AFTER:
            self._compact()
        self._file.append(goal_id)
        self._ids[goal_id] = None
        if len(self._ids) > KEPT:
            del self._ids[next(iter(self._ids))]
        self._lines += 1

    def close(self) -> None:
        """Close the file. Closing twice is allowed."""
        self._file.close()

    def _compact(self) -> None:
        kept = list(self._ids)[-KEPT:]  # more of them only after a start
        self._file.rewrite(kept)
        self._ids = dict.fromkeys(kept)
        self._lines = len(kept)
