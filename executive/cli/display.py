"""Whether a window can be shown here: pybullet ends its process, with X11's words, where it can't."""

from __future__ import annotations

import re
import socket
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Final

from tandem.executive.cli.errors import CommandError

_DISPLAY: Final = re.compile(r"(?:unix|(?P<host>[^:]*)):(?P<number>\d+)(?:\.\d+)?")
_SOCKETS: Final = Path("/tmp/.X11-unix")  # noqa: S108 - where X11 has its sockets
_FIRST_PORT: Final = 6000
"""Of display 0, by the X protocol."""
WITHIN: Final = 2.0
"""Seconds in which an X server on another host must take a connection."""


def require_display(environment: Mapping[str, str]) -> None:
    """Return when an X server takes connections.

    Raises:
        CommandError: for no DISPLAY, or one that nothing answers at.
    """
    if sys.platform != "linux":
        return
    name = environment.get("DISPLAY", "")
    advice = "leave out --gui, or run with a display (`ssh -X`, or `xvfb-run tandem ...`)"
    if not name:
        raise CommandError(f"--gui needs a display, and DISPLAY is not set; {advice}")
    found = _DISPLAY.fullmatch(name)
    if found is None or not _answers(found["host"] or "", int(found["number"])):
        raise CommandError(f"--gui needs a display, and nothing answers at DISPLAY={name}; {advice}")


def _answers(host: str, number: int) -> bool:
    if host:
        try:
            socket.create_connection((host, _FIRST_PORT + number), WITHIN).close()
        except (OSError, OverflowError):
            return False
        return True
    path = str(_SOCKETS / f"X{number}")
    return any(_takes(address) for address in (path, f"\0{path}"))


def _takes(address: str) -> bool:
    """Say whether a Unix socket takes connections; one that begins with a zero has no file."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        probe.settimeout(WITHIN)
        try:
            probe.connect(address)
        except OSError:
            return False
        return True
