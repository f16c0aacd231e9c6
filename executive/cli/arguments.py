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
Output = Annotated[Path | None, typer.Option("--output", "-o", help="A file, instead of standard output.")]
SiteFile = Annotated[str, typer.Option("--site", metavar="NAME|FILE", help="The site file.")]


_PART: Final = re.compile(r"[A-Za-z0-9_.-]+")
_ENDPOINT: Final = re.compile(r"(tcp|tls|udp|quic|ws)/[^/\s]+:\d{1,5}|(unixsock-stream|serial|unixpipe)/\S+")


def bus_options(connect: str, site_key: str, robot: str) -> BusOptions:
    """Return them as one, checked.

    Raises:
        CommandError: for an endpoint that is none, and for what is no part of a key.
    """
    if _ENDPOINT.fullmatch(connect) is None:
        raise CommandError(
            f"--connect: an endpoint such as {DEFAULT_ENDPOINT} was expected; found {connect!r}"
        )
    for option, value in (("--site-key", site_key), ("--robot", robot)):
        if _PART.fullmatch(value) is None:
            raise CommandError(
                f"{option}: one part of a key was expected: letters, digits, - _ . only; found {value!r}"
            )
    return BusOptions(endpoint=connect, site=site_key, robot=robot)
