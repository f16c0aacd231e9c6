"""What the ``tandem`` command ends with. docs/interface.md has the same table, which a test compares."""

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
        ExitCode.OK: "all went as asked",
        ExitCode.TASK_FAILED: "a task failed or was cancelled, a process died, or a run missed its aim",
        ExitCode.BAD_INPUT: "an argument, a file or a request is wrong; the message says where",
        ExitCode.NOBODY_THERE: "no router, robot or executive answers within three seconds",
        ExitCode.REFUSED: "refused: a second executive, sim or router for this robot, an endpoint or ledger "
        "in use, or a key that does not allow what was asked",
        ExitCode.UNKEPT: "the ledger can't be opened or written; nothing that was acknowledged is lost by it",
        ExitCode.BUG: "a mistake in the program; its trace is in the log (`--log FILE`, or `-v`)",
        ExitCode.INTERRUPTED: "interrupted with Ctrl-C; the processes that it had started have been stopped",
    }
)
