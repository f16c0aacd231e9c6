"""What is believed, on disk: what no sensor can restore, and what the camera saw.

Which item is in which hand and what lies in which slot nobody can see again. Where the other items stand
could be seen again, but not while a hand is around one: a keeper that has forgotten it lets the arm through.

One JSON line a change, each a whole picture of it. A change of hands or slots is synced before anybody hears
of it; a sighting is only written, which outlives the process and not the machine. The last line that can be
read counts, so a line torn by a crash loses nothing but itself; opening the journal rewrites it to that one
line, through a file beside it that takes its place. Fields that a newer version added are left out. A journal
of which no line can be read is refused and left as it is: an unknown hand is not an empty one.
"""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Final

from pydantic import ValidationError

from tandem.skills.journal_file import JournalFile
from tandem.skills.ports.message import Count, Message, read_leniently
from tandem.skills.ports.problems import in_words, problems_of
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.world import Box, HeldItem, ItemFact, Placed

COMPACT_AFTER: Final = 1000
"""Lines after which the file is rewritten."""

REMEDY: Final = "move it away, or delete it: the robot then believes its hands to be empty"

_LOG = logging.getLogger(__name__)


class Remembered(Message):
    """All that the journal keeps."""

    written_at: float = 0.0
    """UTC seconds."""
    held: tuple[HeldItem, ...] = ()
    placed: tuple[Placed, ...] = ()
    items: tuple[ItemFact, ...] = ()
    removed: tuple[Count, ...] = ()
    """Items that are no obstacles."""
    clutter: tuple[tuple[str, Box], ...] = ()
    doubles: tuple[ItemFact, ...] = ()
    boot: str = ""
    """Of the hardware: what stood about before another boot is not believed."""
    openings: Count = 0
    """How often the journal has been opened: versions of the facts rise over a new start, too."""


class Journal:
    """The file.

    Args:
        path: where it is, or is to be; its folder must exist.

    Raises:
        OSError: when it can't be read.
        DocumentError: when it has lines, and none of them is one of a journal.
    """

    def __init__(self, path: Path) -> None:
        self._file = JournalFile(path)
        lines = self._file.lines()
        last = _last(path, lines)
        self.remembered = last.model_copy(update={"openings": last.openings + 1})
        self._lines = len(lines)
        try:
            self._compact(self.remembered)
        except OSError:
            _LOG.warning("%s could not be rewritten; it is used as it is", path, exc_info=True)

    def write(self, remembered: Remembered, *, synced: bool = True) -> None:
        """Keep this; if ``synced``, it is on the disk when the call returns.

        Raises:
            OSError: when it can't be written; then what was kept before still is.
        """
        document = remembered.model_copy(update={"openings": self.remembered.openings})
        if self._lines >= COMPACT_AFTER:
            self._compact(document)
        else:
            self._file.append(document.model_dump_json(), synced=synced)
            self._lines += 1
        self.remembered = document

    def _compact(self, document: Remembered) -> None:
        self._file.rewrite([document.model_dump_json()])
        self._lines = 1


def _last(path: Path, lines: list[str]) -> Remembered:
    """Return the last line that can be read; nothing, where there is no line."""
    refused = ""
    for line in reversed(lines):
        try:
            return read_leniently(Remembered, line.encode())
        except ValidationError as error:
            refused = refused or in_words(problems_of(error))
    if refused:
        raise DocumentError(f"{path}: {refused}; {REMEDY}")
    return Remembered()
