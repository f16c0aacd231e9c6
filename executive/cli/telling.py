"""How a series of runs ends: its summary on the screen, and in the file of ``--report``."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

if TYPE_CHECKING:
    from tandem.skills.ports.message import Message


def told(console: Console, report: Path | None, summary: Sequence[str], result: Message) -> None:
    """Print the summary, and write it with the whole result if a report was asked for."""
    for line in summary:
        console.print(line, style="red" if line.startswith("WRONG") else None, markup=False)
    if report is not None:
        from tandem.executive.trials.figure_file import write_figures  # noqa: PLC0415 - few need it
        from tandem.executive.trials.provenance import provenance  # noqa: PLC0415 - as above

        write_figures(report, provenance(sys.argv, time.time()), tuple(summary), result)
