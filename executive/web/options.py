"""What the page's server was asked for, checked."""

from __future__ import annotations

import ipaddress
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from urllib.parse import urlsplit

from tandem.executive.config.addresses import host_and_port
from tandem.executive.config.run_options import BusOptions

DEFAULT_ADDRESS: Final = "127.0.0.1:8447"
"""This host alone: any other address needs keys. The port is ours, a thousand above that of Zenoh's
router."""
LAST_PORT: Final = 65535
"""The highest that TCP has."""


class AddressError(ValueError):
    """Where the page can't be served; the message says why and what to do."""


@dataclass(frozen=True)
class WebOptions:
    """Where the robot is, and where its page is served."""

    bus: BusOptions
    host: str = "127.0.0.1"
    port: int = 8447
    """0: any that is free."""


@dataclass(frozen=True)
class Secure:
    """What a page needs that is served beyond this host."""

    origin: str
    """The one address at which it may be opened, such as ``https://robot.example:8447``."""
    certificate: Path
    key: Path
    keys: Path
    """Folder with the authority's certificate and the list of holders, by which log-ins are checked."""


def checked_address(text: str, *, secure: bool = False) -> tuple[str, int]:
    """Return host and port out of ``HOST:PORT``, on this host unless it is ``secure``.

    Raises:
        AddressError: for what is none, and for one beyond loopback: who reaches the page may move the robot.
    """
    try:
        host, port = host_and_port(text, example=DEFAULT_ADDRESS)
    except ValueError as error:
        raise AddressError(str(error)) from error
    if not is_loopback(host) and not secure:
        raise AddressError(
            f"{text}: anyone who can reach the page could move the robot; beyond this host it takes keys "
            "(`tandem web --keys DIR --as NAME`, see docs/web.md), or "
            f"serve it at {DEFAULT_ADDRESS} and reach it through a tunnel: "
            f"ssh -L {port}:127.0.0.1:{port} {host if host not in {'0.0.0.0', '::'} else 'ROBOT'}"  # noqa: S104
        )
    return host, port


def shown_at(host: str, port: int) -> str:
    """Return the address that a browser opens for a page on this host."""
    return f"http://[{host}]:{port}/" if ":" in host else f"http://{host}:{port}/"


def addresses_of(at: str, robots: Sequence[str]) -> dict[str, tuple[str, int]]:
    """Return host and port of each robot's page: the first at ``HOST:PORT``, each other at the port after.

    Raises:
        AddressError: for what is no address of this host, and where there are no ports left.
    """
    host, first = checked_address(at)
    if first + len(robots) - 1 > LAST_PORT:
        raise AddressError(
            f"{at}: {len(robots)} robots have a port each, and the highest is {LAST_PORT}; choose a lower one"
        )
    return {robot: (host, first + number if first else 0) for number, robot in enumerate(robots)}


def checked_pages(words: Iterable[str]) -> dict[str, str]:
    """Return the addresses of other robots' pages by robot, out of words such as ``r2=https://r2.example:8447``.

    Raises:
        AddressError: for what is none; a browser is sent there, so that nothing but HTTP is taken.
    """
    found = {}
    for each in words:
        name, _, address = each.partition("=")
        if not name or not _is_page(address):
            raise AddressError(f"expected ROBOT=ADDRESS, as in r2=https://r2.example:8447; found {each!r}")
        found[name] = address
    return found


def _is_page(address: str) -> bool:
    try:
        parts = urlsplit(address)
        port = parts.port
    except ValueError:
        return False
    return (
        parts.scheme in {"http", "https"} and bool(parts.hostname) and port != 0 and "@" not in parts.netloc
    )


def is_loopback(host: str) -> bool:
    """Say whether only this host reaches it."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False
