"""Exit codes of the ``tandem`` command. A test compares them with the table in docs/interface.md."""

from __future__ import annotations

from enum import IntEnum
from types import MappingProxyType
from typing import Final


class ExitCode(IntEnum):
    """How a command ended."""

    OK = 0
    TASK_FAILED = 1
    BAD_INPUT = 2
    NOBODY_THERE = 3
    REFUSED = 4
    UNKEPT = 5
    BUG = 70
    INTERRUPTED = 130


MEANINGS: Final = MappingProxyType(
    {
        ExitCode.OK: "success",
        ExitCode.TASK_FAILED: "a task failed or was cancelled, a process died, or a run missed its target",
        ExitCode.BAD_INPUT: "an argument, a file or a request is invalid, or an extra is missing; "
        "the message says which",
        ExitCode.NOBODY_THERE: "no router, robot or executive answered within three seconds",
        ExitCode.REFUSED: "refused: a second executive, sim or router for this robot, an endpoint or ledger "
        "in use, or a key that does not allow the command",
        ExitCode.UNKEPT: "the ledger cannot be opened or written; accepted requests are not lost",
        ExitCode.BUG: "a bug in tandem; the log (`--log FILE`, or `-v`) has the traceback",
        ExitCode.INTERRUPTED: "interrupted with Ctrl-C; all processes it started are stopped",
    }
)
