"""How a whole system's run ends: its exit code, and in words when it did not end by itself."""

from __future__ import annotations

from collections.abc import Callable

from rich.console import Console

from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.interrupting import ends_once
from tandem.executive.system.free_endpoint import EndpointError
from tandem.executive.system.systems import LedgerFailure, RefusedError, SystemFailure
from tandem.skills.ports.sources import DocumentError


def ended(work: Callable[[Console], ExitCode], *, aside: bool = False) -> ExitCode:
    """Do the work; say in words how it ended when it did not end by itself.

    Args:
        work: says what happens.
        aside: whether that goes to standard error, as standard output is for a document.
    """
    console = Console(stderr=aside, highlight=False, soft_wrap=True)
    try:
        with ends_once():
            return work(console)
    except (DocumentError, EndpointError) as error:
        complain(f"error: {error}")
        return ExitCode.BAD_INPUT
    except RefusedError as error:
        complain(f"refused: {error}")
        return ExitCode.REFUSED
    except LedgerFailure as error:
        complain(f"error: {error}")
        return ExitCode.UNKEPT
    except SystemFailure as error:
        complain(f"error: {error}")
        return ExitCode.TASK_FAILED
    except KeyboardInterrupt:
        console.print("interrupted; all processes are stopped")
        return ExitCode.INTERRUPTED


def complain(words: str, style: str = "red") -> None:
    """Say what is wrong where errors belong, whatever standard output is for."""
    Console(stderr=True, highlight=False, soft_wrap=True).print(words, style=style, markup=False)
