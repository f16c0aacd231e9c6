"""Keep what a library prints from C off the screen: it is no message to the user."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

OUTPUTS: Final = (1, 2)
"""Standard output and standard error."""


@contextmanager
def unheard() -> Iterator[None]:
    """Drop what the process prints, from Python or from C, for as long as this lasts. Errors still raise."""
    library = ctypes.CDLL(None)
    _flush(library)
    kept = [os.dup(output) for output in OUTPUTS]
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for output in OUTPUTS:
            os.dup2(nowhere, output)
        yield
    finally:
        _flush(library)
        for output, copy in zip(OUTPUTS, kept, strict=True):
            os.dup2(copy, output)
            os.close(copy)
        os.close(nowhere)


def _flush(library: ctypes.CDLL) -> None:
    sys.stdout.flush()
    sys.stderr.flush()
    library.fflush(None)
