"""Loopback ports that are free: each test that starts processes takes its own."""

from __future__ import annotations

import socket


def free_endpoint() -> str:
    """Return a zenoh endpoint on a loopback port that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f"tcp/127.0.0.1:{probe.getsockname()[1]}"


def free_pair() -> int:
    """Return a loopback port that is free as the one after it is."""
    while True:
        with socket.socket() as one, socket.socket() as next_one:
            one.bind(("127.0.0.1", 0))
            port = int(one.getsockname()[1])
            try:
                next_one.bind(("127.0.0.1", port + 1))
            except OSError:
                continue
            return port
