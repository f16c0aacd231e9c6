"""A question at the terminal before something is done that can hurt."""

from __future__ import annotations

import sys

import typer

from tandem.executive.cli.errors import CommandError


def confirm(warning: str, question: str) -> None:
    """Go on only if somebody says yes.

    Args:
        warning: what he has to know before.
        question: answered with yes or no.

    Raises:
        CommandError: when nobody is at a terminal.
        Abort: for any answer but yes.
    """
    if not sys.stdin.isatty():
        raise CommandError(f"{warning} Confirm with --yes.")
    typer.echo(warning, err=True)
    typer.confirm(question, abort=True, err=True)
