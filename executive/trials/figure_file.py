"""The file of figures that a campaign, an experiment or a benchmark writes with ``--report``.

``python -m benchmarks.figures`` copies its summary into the pages of ``docs/``, so that no figure there is
typed by hand, and each names its command, commit, date and machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import JsonValue

from tandem.executive.trials.provenance import Provenance
from tandem.skills.ports.message import Message


class Figures(Message):
    """What a command found out."""

    format: Literal["tandem-figures/1"] = "tandem-figures/1"
    made: Provenance
    summary: tuple[str, ...]
    """The lines that the command printed in the end."""
    result: dict[str, JsonValue]
    """All of it; its form is the command's."""


def write_figures(path: Path, made: Provenance, summary: tuple[str, ...], result: Message) -> None:
    """Write the file; its folder is made.

    Args:
        path: where.
        made: where the result comes from.
        summary: the lines that the command printed in the end.
        result: all of it.
    """
    figures = Figures(
        made=made,
        summary=summary,
        result=result.model_dump(mode="json"),
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(figures.model_dump_json(indent=1) + "\n", encoding="utf-8")
