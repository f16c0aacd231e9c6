"""Log files of a bounded size: those of the processes, and the one that a user asked for."""

from __future__ import annotations

import logging
import os
import shutil
from contextlib import suppress
from logging.handlers import RotatingFileHandler
from pathlib import Path
from typing import Final

PROCESS_LOG_BYTES: Final = 4 * 1024 * 1024
"""Size at which a process's own log begins anew. A trace of the stack has some 4 kB, so a thousand fit; with
the file before it, all roles together stay below 100 MB."""
USER_LOG_BYTES: Final = 32 * 1024 * 1024
"""Size at which the file of ``--log`` begins anew: some three days of one fetch a minute."""
USER_LOGS_KEPT: Final = 4
"""Older files that are kept beside it, as ``FILE.1`` (the newest) to ``FILE.4``."""


def trim(log: Path, limit: int = PROCESS_LOG_BYTES) -> bool:
    """Begin a log anew once it is larger than ``limit`` bytes; what was in it stays as ``<log>.1``.

    The process that writes the log holds it open for appending, so the file is copied and emptied, as
    logrotate's ``copytruncate`` does: a line that is written between the two is lost.
    """
    if log.stat().st_size <= limit:
        return False
    with suppress(OSError):  # as on a full disk, where the bound matters more than the copy
        shutil.copyfile(log, log.with_name(f"{log.name}.1"))
    os.truncate(log, 0)
    return True


class UserLog:
    """The file of ``--log``: lines are appended, and old ones go when it has grown too large.

    Args:
        path: where it is, or is to be; its folder is made.
        limit: bytes of one file.

    Raises:
        OSError: when it can't be written.
    """

    def __init__(self, path: Path, *, limit: int = USER_LOG_BYTES) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = RotatingFileHandler(path, maxBytes=limit, backupCount=USER_LOGS_KEPT, encoding="utf-8")

    def write(self, line: str) -> None:
        """Append a line."""
        self._file.emit(logging.LogRecord("", logging.INFO, "", 0, "%s", (line,), None))

    def close(self) -> None:
        """Close the file. Closing twice is allowed."""
        self._file.close()
