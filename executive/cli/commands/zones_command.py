"""``tandem zones``: where which hand gets to, drawn from the robot's description; no robot is needed."""

from __future__ import annotations

import sys
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from tandem.executive.cli.errors import CommandError


class ZonesFormat(StrEnum):
    """How they are drawn."""

    UNICODE = "unicode"
    SVG = "svg"
    PNG = "png"


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("zones")(draw)


def draw(
    *,
    height: Annotated[
        float, typer.Option("--height", min=0.0, max=2.0, help="Height of the table, in m.")
    ] = 0.71,
    torso: Annotated[
        float | None,
        typer.Option(
            "--torso", min=0.0, max=1.0, help="Height of the torso, in m. Default: its home position."
        ),
    ] = None,
    form: Annotated[ZonesFormat, typer.Option("--format", "-f")] = ZonesFormat.UNICODE,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="Write to this file instead of standard output."),
    ] = None,
) -> None:
    """Draw where the left hand, the right hand, both or neither can grasp. Takes a few seconds."""
    from tandem.executive.render.zones import png_zones, svg_zones, unicode_zones  # noqa: PLC0415
    from tandem.sim.robots.registry import robot_model  # noqa: PLC0415
    from tandem.sim.starts import ROBOT  # noqa: PLC0415
    from tandem.skills.bimanual.zones import ZonesAsk, zones  # noqa: PLC0415

    found = zones(ZonesAsk(robot_model(ROBOT).description.model_dump_json(), height, torso))
    if form is ZonesFormat.PNG:
        content = png_zones(found)
    else:
        content = (svg_zones if form is ZonesFormat.SVG else unicode_zones)(found).encode() + b"\n"
    if output is not None:
        try:
            output.write_bytes(content)
        except OSError as error:
            raise CommandError(f"--output {output}: cannot write: {error.strerror}") from error
        typer.echo(f"{output}: {len(content)} bytes")
    elif form is ZonesFormat.PNG and sys.stdout.isatty():
        raise CommandError("png is binary; give a file with --output")
    else:
        sys.stdout.buffer.write(content)
        sys.stdout.flush()
