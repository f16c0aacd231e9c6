"""What an endpoint tells about who can reach it."""

from __future__ import annotations


def host_of(endpoint: str) -> str:
    """Return the host of an endpoint such as ``tls/HOST:PORT``."""
    return endpoint.partition("/")[2].rpartition(":")[0].strip("[]")


def is_loopback(endpoint: str) -> bool:
    """Say whether nobody outside this host can reach the endpoint."""
    if endpoint.partition("/")[0] in {"unixsock-stream", "unixpipe"}:
        return True
    host = host_of(endpoint)
    return host in {"localhost", "::1"} or host.startswith("127.")
