"""The folder where a robot keeps what a restart needs: it is looked at before any process fails over it."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

NOT_OURS: Final = frozenset({"lost+found"})
"""What the root of a disk of its own has beside our files, readable by root alone."""


class DataFolderError(OSError):
    """A folder in which not everything can be kept. The text names what can't be written, and what to do."""


def require_writable(folder: Path) -> None:
    """Make the folder, if there is none, and look whether it and all that it holds can be written.

    What another user's start has left there, such as a log, would end a process in the middle of its work.

    Raises:
        DataFolderError: naming the file or folder that can't be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
        for each in _held(folder):
            _require_ours(each, folder)
    except DataFolderError:
        raise
    except OSError as error:
        raise DataFolderError(not_writable(folder, error)) from error


def not_writable(where: Path, error: OSError) -> str:
    """Return in words that nothing can be kept in a folder, given what bars it: itself, or a file there."""
    return f"{where}: the ledger needs a writable folder: {error.strerror}; choose another one with --data"


def _require_ours(each: Path, folder: Path) -> None:
    is_folder = each.is_dir()
    if os.access(each, os.R_OK | os.W_OK | (os.X_OK if is_folder else 0)):
        return
    try:
        owner = each.stat().st_uid
    except FileNotFoundError:  # a process that still runs there has just removed it
        return
    what = "a folder" if is_folder else "a file"
    raise DataFolderError(
        f"{each}: expected {what} that this user can read and write, found one of user {owner}; give all in "
        f"{folder} to user {os.geteuid()}, or choose another folder with --data"
    )


def _held(folder: Path) -> Iterator[Path]:
    """Return what a folder holds, folders before what is in them."""
    for each in sorted(folder.iterdir()):
        if each.name not in NOT_OURS:
            yield each
            if each.is_dir() and not each.is_symlink() and os.access(each, os.R_OK | os.X_OK):
                yield from _held(each)
