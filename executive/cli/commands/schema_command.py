"""``tandem schema``: JSON Schemas of all that a client sends or reads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from tandem.executive.cli.errors import CommandError


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("schema")(schema)


def schema(
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            metavar="DIR|FILE",
            help="Folder for one file per message; with asyncapi, a file.",
        ),
    ] = None,
    form: Annotated[
        Literal["jsonschema", "asyncapi"],
        typer.Option("--format", "-f", help="JSON Schemas, or one AsyncAPI 3.0 document."),
    ] = "jsonschema",
) -> None:
    """Print the interface as JSON Schema or AsyncAPI."""
    import json  # noqa: PLC0415

    from tandem.executive.interface.schemas import interface_schema, separate_schemas  # noqa: PLC0415
    from tandem.trees.registry import discover  # noqa: PLC0415

    kinds = discover()
    if form == "asyncapi":
        from tandem.executive.interface.asyncapi import asyncapi  # noqa: PLC0415

        _put(json.dumps(asyncapi(kinds), indent=1), output)
        return
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
        raise CommandError(f"--output {output}: cannot write to this folder: {error.strerror}") from error


def _put(text: str, output: Path | None) -> None:
    """Print a document, or write it to the file named."""
    if output is None:
        typer.echo(text)
        return
    try:
        output.write_text(f"{text}\n", encoding="utf-8")
    except OSError as error:
        raise CommandError(f"--output {output}: cannot write: {error.strerror}") from error
    typer.echo(str(output))
