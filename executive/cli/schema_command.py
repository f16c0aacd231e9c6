"""``tandem schema``: JSON Schemas of all that a client sends or reads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.cli.errors import CommandError


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("schema")(schema)


def schema(
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="DIR", help="A file for each message, here.")
    ] = None,
) -> None:
    """Print the JSON Schemas of the interface as one document, or write one file for each message."""
    import json  # noqa: PLC0415

    from executive.schemas import interface_schema, separate_schemas  # noqa: PLC0415
    from trees.registry import discover  # noqa: PLC0415

    kinds = discover()
    if output is None:
        typer.echo(json.dumps(interface_schema(kinds), indent=2))
        return
    try:
        output.mkdir(parents=True, exist_ok=True)
        for name, document in separate_schemas(kinds).items():
            path = output / f"{name}.schema.json"
            path.write_text(f"{json.dumps(document, indent=2)}\n", encoding="utf-8")
            typer.echo(str(path))
    except OSError as error:
        raise CommandError(f"--output {output}: a writable folder was expected: {error.strerror}") from error
