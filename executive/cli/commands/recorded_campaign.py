"""``--record-to`` of campaigns: their runs as recordings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.config.extras import RECORD, words_on

if TYPE_CHECKING:
    from tandem.executive.trials.campaigns.recording import Runs

RecordTo = Annotated[
    Path | None,
    typer.Option(
        "--record-to", metavar="DIR", help="Record each run as MCAP, in a folder of its own in this one."
    ),
]
RecordPictures = Annotated[
    bool,
    typer.Option(
        "--record-pictures/--no-record-pictures", help="With --record-to: also the cameras' pictures."
    ),
]


def recorded_runs(campaign: str, scenario: str, seed: int, folder: Path | None, *, pictures: bool) -> Runs:
    """Return what makes the systems of a campaign's runs: recorded ones, if a folder is named."""
    from tandem.executive.trials.campaigns.recording import UNRECORDED, RecordedRuns  # noqa: PLC0415
    from tandem.executive.trials.provenance import checkout  # noqa: PLC0415

    if folder is None:
        return UNRECORDED
    lacks = words_on(RECORD, "a recording")
    if lacks:
        raise CommandError(lacks)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CommandError(f"--record-to {folder}: {error.strerror}") from error
    return RecordedRuns(folder, campaign, scenario, seed, checkout()[0], pictures)
