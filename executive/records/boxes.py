"""The folder of the black boxes: a bounded number of files and of bytes; the oldest go first."""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.records.dated import STAMP, oldest_first, stamp_of
from tandem.executive.records.lines_file import LINES, read_facts, write_lines
from tandem.executive.records.recording import Attachment, Facts, Recorded, RecordError, Span
from tandem.skills.ports.records import BlackBox

FOLDER: Final = "records"
"""Beside the ledger, in the folder of ``--data``."""
FILES: Final = 20
"""Black boxes that are kept."""
BYTES: Final = 200 * 1024 * 1024
"""Bytes of all of them; one of a robot with two arms has 3 to 6 MB."""
_NAME: Final = re.compile(rf"{STAMP}-.*{re.escape(LINES)}")
_UNFIT: Final = re.compile(r"[^A-Za-z0-9_.-]+")


@dataclass(frozen=True)
class Boxes:
    """The folder.

    Args:
        folder: made when the first is written.
        files: how many are kept.
        most: bytes of all together.
    """

    folder: Path
    files: int = FILES
    most: int = BYTES

    def paths(self) -> tuple[Path, ...]:
        """Return the files in the order of their names."""
        try:
            return tuple(sorted(each for each in self.folder.iterdir() if _NAME.fullmatch(each.name)))
        except OSError:
            return ()

    def known(self, task: str = "") -> tuple[BlackBox, ...]:
        """Return what is kept, by their names; of a task only. A file that can't be read is left out."""
        found: list[BlackBox] = []
        for path in self.paths():
            with suppress(RecordError, OSError):
                facts, size = read_facts(path), path.stat().st_size
                if not task or any(cause.task == task for cause in facts.causes):
                    found.append(BlackBox(file=str(path), size=size, began=facts.began, causes=facts.causes))
        return tuple(found)

    def keep(
        self,
        utc: float,
        facts: Facts,
        span: Span,
        attachments: Iterable[Attachment],
        messages: Iterable[Recorded],
    ) -> Path:
        """Write one and let the oldest go; return its path.

        Args:
            utc: now, in seconds.
            facts: what it is of, and why it is kept.
            span: from when to when it is whole.
            attachments: beside the messages.
            messages: in the order in which they were heard.

        Raises:
            OSError: when it can't be written; nothing is left of it then.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        path = self._free(f"{stamp_of(utc)}-{_words(facts)}")
        write_lines(path, facts, span, attachments, messages)
        self._bound(path, utc)
        return path

    def _free(self, name: str) -> Path:
        path, number = self.folder / f"{name}{LINES}", 1
        while path.exists():
            number += 1
            path = self.folder / f"{name}-{number}{LINES}"
        return path

    def _bound(self, newest: Path, now: float) -> None:
        paths = [each for each in oldest_first(self.paths(), now) if each != newest]
        sizes = {each: each.stat().st_size for each in (*paths, newest) if each.exists()}
        while paths and (len(paths) >= self.files or sum(sizes.values()) > self.most):
            oldest = paths.pop(0)
            sizes.pop(oldest, None)
            with suppress(OSError):
                oldest.unlink()


def _words(facts: Facts) -> str:
    first = facts.causes[0] if facts.causes else None
    if first is None:
        return "asked"
    words = f"{first.task}-failed" if first.kind == "task" else first.kind
    return _UNFIT.sub("-", words)[:80]
