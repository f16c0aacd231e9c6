"""One process of the system: run this module with the process's settings as one JSON document.

``executive.system.processes`` starts these. Each plays one role until it is told to end
or its parent is gone.
"""

from __future__ import annotations

import logging
import os
import signal
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from types import FrameType
from typing import Final

from tandem.executive.config.process_settings import REFUSED, UNKEPT, WAIT, RefusalError, WorkerSettings
from tandem.executive.ledger.port import LedgerError, LedgerLockedError
from tandem.executive.system import playing
from tandem.executive.system.quiet_screen import end_unheard
from tandem.executive.telemetry.logs import formatter
from tandem.skills.ports.sources import DocumentError
from tandem.skills.wire.threads import few_threads

SWITCH_INTERVAL: Final = 0.0005
"""Seconds after which a thread that computes lets another go on."""


@dataclass(eq=False)
class Ending:
    """Whether the process should end: it was told to, or its parent is gone."""

    told: bool = False
    parent: int = field(default_factory=os.getppid)

    def __call__(self) -> bool:
        """Say so."""
        return self.told or os.getppid() != self.parent

    def listen(self) -> None:
        """End on SIGTERM and SIGINT."""
        signal.signal(signal.SIGTERM, self._tell)
        signal.signal(signal.SIGINT, self._tell)

    def _tell(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002 - as signal calls it
        self.told = True


def main(argv: list[str]) -> int:
    """Play the role; return the process's exit code."""
    if argv[0] == WAIT:
        # A spare: what the role needs is loaded before it is needed. The end of the pipe is its parent's end.
        playing.load_ahead(argv[1])
        argv = [sys.stdin.readline()]
        if not argv[0]:
            return 0
    settings = WorkerSettings.model_validate_json(argv[0])
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(formatter(settings.log_format, settings.called))
    logging.basicConfig(level=logging.DEBUG if settings.verbose else logging.INFO, handlers=[handler])
    # zenoh's callbacks wait until the loop's thread lets them go on. At Python's 5 ms a message, a loop
    # that is busy would hear 200 of them in a second.
    sys.setswitchinterval(SWITCH_INTERVAL)
    ending = Ending() if settings.parent is None else Ending(parent=settings.parent)
    ending.listen()
    return ended(partial(playing.play, settings, ending), settings.called)


def ended(work: Callable[[], None], called: str) -> int:
    """Do a process's work; return its exit code. Only a mistake of the program leaves a trace in the log."""
    log = logging.getLogger(__name__)
    try:
        work()
    except (RefusalError, LedgerLockedError) as refusal:
        log.error("%s", refusal)  # noqa: TRY400 - no fault of the program
        return REFUSED
    except LedgerError as error:
        log.error("%s", error)  # noqa: TRY400 - the disk's fault
        return UNKEPT
    except DocumentError as error:
        log.error("%s", error)  # noqa: TRY400 - a mistake in somebody's file
        return 1
    except Exception:
        log.exception("%s failed with an unexpected error", called)
        return 1
    return 0


def run(words: list[str] | None = None) -> None:
    """The entry point; ``words``: of the command line, unless given its own."""
    few_threads(os.environ)
    code = main(sys.argv[1:] if words is None else words)
    logging.shutdown()
    end_unheard()
    sys.exit(code)


if __name__ == "__main__":
    run()
