"""``tandem keys``: an authority of one's own, and keys for those who may use the bus."""

from __future__ import annotations

import datetime as dt
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.security.role import Role

if TYPE_CHECKING:
    from tandem.executive.security.holders import Holder

DEFAULT_FOLDER: Final = Path("keys")
Folder = Annotated[Path, typer.Option("--folder", metavar="DIR", help="Where the keys are.")]
Name = Annotated[str, typer.Argument(metavar="NAME", help="Of the person, the program or the robot.")]


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(help="Who may use the bus, and as what.", no_args_is_help=True)
    group.command("init")(init)
    group.command("new")(new)
    group.command("list")(list_keys)
    group.command("revoke")(revoke)
    app.add_typer(group, name="keys")


def init(folder: Folder = DEFAULT_FOLDER) -> None:
    """Make an authority of one's own, which certifies the keys."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    with _said():
        authority.begin(folder, _now())
    typer.echo(f"{folder / 'ca.pem'}: everybody gets it; {folder / 'ca.key'}: nobody does")


def new(
    name: Name,
    role: Annotated[Role, typer.Option("--role", help="What the holder may do.")],
    days: Annotated[int, typer.Option("--days", min=1, max=3650, help="How long it holds.")] = 365,
    host: Annotated[
        list[str] | None,
        typer.Option("--host", help="A robot's: where its router is reached; again for more."),
    ] = None,
    folder: Folder = DEFAULT_FOLDER,
) -> None:
    """Make a key and its certificate; for a robot one for each of its parts."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    wanted = authority.Wanted(role, name, days, tuple(host or ()))
    with _said():
        made = authority.issue(folder, wanted, _now())
    for holder in made:
        typer.echo(f"{holder.common_name}: {folder / holder.stem}.pem, {folder / holder.stem}.key")


def list_keys(folder: Folder = DEFAULT_FOLDER) -> None:
    """List who has been given a key, and whether it holds."""
    from tandem.executive.security.holders import read_holders  # noqa: PLC0415

    with _said():
        known = read_holders(folder)
    for holder in known.holders:
        typer.echo(f"{holder.common_name:40} {_state(holder)}")
    if not known.holders:
        typer.echo("no key yet; make one with `tandem keys new --role operator NAME`")


def revoke(name: Name, folder: Folder = DEFAULT_FOLDER) -> None:
    """Take back what a name's keys allow; the router hears of it within a second."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    with _said():
        gone = authority.revoke(folder, name)
    for holder in gone:
        typer.echo(f"{holder.common_name} is revoked")


def _state(holder: Holder) -> str:
    until = dt.datetime.fromtimestamp(holder.expires_at, dt.UTC).date()
    if holder.revoked:
        return "revoked"
    return f"expired on {until}" if holder.expires_at < _now().timestamp() else f"until {until}"


def _now() -> dt.datetime:
    return dt.datetime.now(dt.UTC)


@contextmanager
def _said() -> Iterator[None]:
    from tandem.executive.security.holders import KeysError  # noqa: PLC0415

    try:
        yield
    except KeysError as error:
        raise CommandError(str(error)) from error
