"""Whether a router can listen at an endpoint, found out before anything is started."""

from __future__ import annotations

import errno
import re
import socket
from typing import Final

from tandem.executive.config.addresses import LAST_PORT

_HOST_AND_PORT: Final = re.compile(r"(?:tcp|tls|ws)/\[?(?P<host>[^\]/\s]+?)\]?:(?P<port>\d{1,5})")


class TakenError(RuntimeError):
    """Another program listens there; the message names the endpoint, and what to do."""


class EndpointError(ValueError):
    """Nothing can listen there; the message says why."""


def require_vacant(endpoint: str) -> bool:
    """Return True where a router can listen, False where that can't be told before it tries.

    Args:
        endpoint: such as tcp/127.0.0.1:7447; tls and ws, too.

    Raises:
        TakenError: when another program listens there.
        EndpointError: when this host has no such address, or does not let us listen there.
    """
    found = _HOST_AND_PORT.fullmatch(endpoint)
    if found is None:
        return False
    if int(found["port"]) > LAST_PORT:  # some C libraries would take its lower 16 bits
        raise EndpointError(f"{endpoint}: expected a port up to {LAST_PORT}")
    try:
        addresses = socket.getaddrinfo(
            found["host"], int(found["port"]), type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )
    except (OSError, OverflowError) as error:
        raise EndpointError(f"{endpoint}: not an address of this host: {error}") from error
    for family, kind, protocol, _, address in addresses:
        with socket.socket(family, kind, protocol) as probe:
            # As zenoh listens: a port whose last connections have not run out yet is free.
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind(address)
                probe.listen(1)
            except OSError as error:
                raise _said(endpoint, error) from error
    return True


def _said(endpoint: str, error: OSError) -> TakenError | EndpointError:
    if error.errno == errno.EADDRINUSE:
        return TakenError(
            f"another program already listens on {endpoint}; stop it, or choose another endpoint "
            "with --connect tcp/127.0.0.1:7448"
        )
    return EndpointError(f"{endpoint}: cannot listen on this address: {error.strerror}")
