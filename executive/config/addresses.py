"""Hosts and ports as they are written: ``HOST:PORT``, and zenoh's endpoints."""

from __future__ import annotations

import re
from typing import Final

LAST_PORT: Final = 65535
"""Of TCP."""
METRICS_EXAMPLE: Final = "127.0.0.1:9464"
"""9464 is the port by which exporters of OpenTelemetry serve Prometheus."""
_WITH_PORT: Final = re.compile(r"(tcp|tls|udp|quic|ws)/[^/\s]+:(?P<port>\d{1,5})")
_WITHOUT: Final = re.compile(r"(unixsock-stream|serial|unixpipe)/\S+")


def host_and_port(text: str, *, example: str) -> tuple[str, int]:
    """Return them out of ``HOST:PORT``, an address of IPv6 without its brackets.

    Raises:
        ValueError: saying what was expected, with the example.
    """
    host, colon, port = text.rpartition(":")
    if not colon or not host or not port.isdecimal() or int(port) > LAST_PORT:
        raise ValueError(f"expected a host and a port such as {example}; found {text!r}")
    return host.strip("[]"), int(port)


def is_endpoint(text: str) -> bool:
    """Say whether zenoh knows such an endpoint: ``tcp/127.0.0.1:7447``, ``serial//dev/ttyUSB0``."""
    found = _WITH_PORT.fullmatch(text)
    if found is None:
        return _WITHOUT.fullmatch(text) is not None
    return int(found["port"]) <= LAST_PORT
