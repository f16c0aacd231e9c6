"""``tandem keys``: an authority of one's own, and keys for those who may use the bus."""

from __future__ import annotations

import datetime as dt
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json
from tandem.executive.cli.errors import CommandError
from tandem.executive.security.role import Role

if TYPE_CHECKING:
    from tandem.executive.security.holders import Holder

DEFAULT_FOLDER: Final = Path("keys")
Folder = Annotated[Path, typer.Option("--folder", metavar="DIR", help="Folder with the keys.")]
Name = Annotated[str, typer.Argument(metavar="NAME", help="Name of the person, program or robot.")]


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(help="Manage who may use the bus, and in which role.", no_args_is_help=True)
    group.command("init")(init)
    group.command("new")(new)
    group.command("list")(list_keys)
    group.command("revoke")(revoke)
    group.command("link")(link)
    app.add_typer(group, name="keys")


def init(folder: Folder = DEFAULT_FOLDER) -> None:
    """Create the certificate authority that signs the keys."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    with _said():
        authority.begin(folder, _now())
    typer.echo(f"{folder / 'ca.pem'}: copy it to every host; {folder / 'ca.key'}: keep it secret")


def new(
    name: Name,
    role: Annotated[Role, typer.Option("--role", help="Role, which decides what the key allows.")],
    days: Annotated[int, typer.Option("--days", min=1, max=3650, help="Days until the key expires.")] = 365,
    host: Annotated[
        list[str] | None,
        typer.Option("--host", help="Address of the robot's router. Repeat for more than one."),
    ] = None,
    folder: Folder = DEFAULT_FOLDER,
) -> None:
    """Create a key and its certificate. For a robot, create one for each of its processes."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    wanted = authority.Wanted(role, name, days, tuple(host or ()))
    with _said():
        made = authority.issue(folder, wanted, _now())
    for holder in made:
        typer.echo(f"{holder.common_name}: {folder / holder.stem}.pem, {folder / holder.stem}.key")


def list_keys(folder: Folder = DEFAULT_FOLDER, *, as_json: Json = False) -> None:
    """List the keys and whether they are valid."""
    from tandem.executive.security.holders import read_holders  # noqa: PLC0415

    with _said():
        known = read_holders(folder)
    if as_json:
        _print(known.holders)
        return
    for holder in known.holders:
        typer.echo(f"{holder.common_name:40} {_state(holder)}")
    if not known.holders:
        typer.echo("no keys yet; create one with `tandem keys new --role operator NAME`")


def revoke(name: Name, folder: Folder = DEFAULT_FOLDER) -> None:
    """Revoke all keys of a name. Takes effect at the router within a second."""
    from tandem.executive.security import authority  # noqa: PLC0415 - loads a library

    with _said():
        gone = authority.revoke(folder, name)
    for holder in gone:
        typer.echo(f"{holder.common_name} is revoked")


def link(
    name: Name,
    page: Annotated[
        str, typer.Option("--page", metavar="ADDRESS", help="Address of the page: https://HOST:PORT.")
    ],
    folder: Folder = DEFAULT_FOLDER,
    *,
    word: Annotated[
        bool, typer.Option("--word", help="Print the word alone, to paste it into the page.")
    ] = False,
) -> None:
    """Create a log-in to a page beyond this host, in the name of a key. It opens once, within ten minutes."""
    from tandem.executive.security.identity import Identity  # noqa: PLC0415 - loads a library
    from tandem.executive.security.links import make  # noqa: PLC0415

    origin = page.rstrip("/")
    if not re.fullmatch(r"https://[^/?#@\s]+", origin):
        raise CommandError(f"--page: expected an address such as https://robot.example:8447; found {page!r}")
    with _said():
        made = make(Identity(folder, name), origin, _now().timestamp())
    typer.echo(made if word else f"{origin}/login#{made}")


def _print(holders: Iterable[Holder]) -> None:
    from tandem.executive.cli.shapes import Key, KeyList, print_json  # noqa: PLC0415

    now = _now().timestamp()
    keys = (
        Key(
            name=each.name,
            role=each.role,
            part=each.part,
            expires_at=each.expires_at,
            revoked=each.revoked,
            valid=not each.revoked and each.expires_at >= now,
        )
        for each in holders
    )
    print_json(KeyList(keys=tuple(keys)))


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
