"""Options that several commands share."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Final

import typer

from executive.cli.errors import CommandError
from executive.options import DEFAULT_ENDPOINT, BusOptions

Connect = Annotated[
    str, typer.Option("--connect", metavar="ENDPOINT", help="The router, such as tcp/127.0.0.1:7447.")
]
SiteKey = Annotated[str, typer.Option("--site-key", help="First part of every key.")]
Robot = Annotated[str, typer.Option("--robot", help="Second part of every key.")]
Keys = Annotated[
    Path | None,
    typer.Option(
        "--keys", metavar="DIR", envvar="TANDEM_KEYS", help="Folder of keys, for a router with TLS."
    ),
]
As = Annotated[
    str, typer.Option("--as", metavar="NAME", envvar="TANDEM_AS", help="Whose key of that folder is shown.")
]
Output = Annotated[Path | None, typer.Option("--output", "-o", help="A file, instead of standard output.")]
SiteFile = Annotated[str, typer.Option("--site", metavar="NAME|FILE", help="The site file.")]


TLS: Final = "tls/"
"""How an endpoint with TLS begins."""
_PART: Final = re.compile(r"[A-Za-z0-9_.-]+")
ENDPOINT: Final = re.compile(r"(tcp|tls|udp|quic|ws)/[^/\s]+:\d{1,5}|(unixsock-stream|serial|unixpipe)/\S+")


def bus_options(
    connect: str, site_key: str, robot: str, keys: Path | None = None, holder: str = ""
) -> BusOptions:
    """Return them as one, checked.

    Raises:
        CommandError: for an endpoint that is none, for what is no part of a key, and for keys that don't fit.
    """
    if ENDPOINT.fullmatch(connect) is None:
        raise CommandError(
            f"--connect: an endpoint such as {DEFAULT_ENDPOINT} was expected; found {connect!r}"
        )
    for option, value in (("--site-key", site_key), ("--robot", robot)):
        if _PART.fullmatch(value) is None:
            raise CommandError(
                f"{option}: one part of a key was expected: letters, digits, - _ . only; found {value!r}"
            )
    if holder and keys is None:
        raise CommandError("--as names a key; --keys with its folder was expected too")
    if keys is not None and not connect.startswith(TLS):
        if connect != DEFAULT_ENDPOINT:
            raise CommandError(f"--keys: an endpoint {TLS}HOST:PORT was expected with it; found {connect!r}")
        connect = connect.replace("tcp/", TLS)
    return BusOptions(endpoint=connect, site=site_key, robot=robot, keys=keys, holder=holder)
