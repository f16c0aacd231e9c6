"""``tandem log export --lerobot``: records as a data set that LeRobot reads."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.config.extras import LEROBOT, words_on

if TYPE_CHECKING:
    from tandem.executive.records.lerobot.export import Exported


def write_data_set(sources: Sequence[Path], target: Path, fps: int, cameras: tuple[str, ...] | None) -> None:
    """Write a data set, and say what is in it.

    Args:
        sources: records, or folders of them.
        target: the data set's folder, new or empty.
        fps: frames a second.
        cameras: names of the cameras; None: all.
    """
    lacks = words_on(LEROBOT, "a data set")
    if lacks:
        raise CommandError(lacks)
    from tandem.executive.records.lerobot.export import Wanted, export  # noqa: PLC0415

    try:
        made = export(sources, target, Wanted(fps, cameras))
    except OSError as error:
        raise CommandError(f"{error.filename or target}: {error.strerror or error}") from error
    for line in _words(target, made, fps):
        typer.echo(line)


def _words(target: Path, made: Exported, fps: int) -> list[str]:
    names = [name for name, _, _ in made.features.cameras]
    shown = f"pictures of {', '.join(names)}" if names else "no pictures"
    lines = [f"{target}: {made.episodes} episodes, {made.frames} frames at {fps} a second, {shown}"]
    return lines + [f"  left out: {file}: {each.task}: {each.reason}" for file, each in made.left_out]
