"""``tandem plugins``: what other packages add, and what is wrong with it."""

from __future__ import annotations

from typing import Annotated

import typer

from tandem.executive.cli.arguments import Json
from tandem.executive.cli.exit_codes import ExitCode


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("plugins")(plugins)


def plugins(
    *,
    within: Annotated[
        float, typer.Option("--within", min=0.1, max=600.0, help="Seconds that the import of one may take.")
    ] = 10.0,
    as_json: Json = False,
) -> None:
    """List the installed plug-ins, and try to load each. Exits 1 if one can't be loaded."""
    from tandem.executive.system.plugin_probe import Fared, probe  # noqa: PLC0415

    fared = probe(within=within)
    if as_json:
        from pydantic import TypeAdapter  # noqa: PLC0415

        typer.echo(TypeAdapter(tuple[Fared, ...]).dump_json(fared, indent=2).decode())
    elif not fared:
        typer.echo("no plug-ins are installed")
    else:
        from rich.console import Console  # noqa: PLC0415
        from rich.table import Table  # noqa: PLC0415
        from rich.text import Text  # noqa: PLC0415

        table = Table("group", "name", "package", box=None)
        table.add_column("state", overflow="fold")
        for each in fared:
            state = Text(each.error or "ok", style="red" if each.error else "")
            table.add_row(each.group.value, each.name, f"{each.package} {each.version}", state)
        Console(soft_wrap=True).print(table)
    raise typer.Exit(ExitCode.TASK_FAILED if any(each.error for each in fared) else ExitCode.OK)
