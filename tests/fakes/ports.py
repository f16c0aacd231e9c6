"""Loopback ports that are free: each test that starts processes takes its own."""

from __future__ import annotations

import socket


def free_endpoint() -> str:
    """Return a zenoh endpoint on a loopback port that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f"tcp/127.0.0.1:{probe.getsockname()[1]}"
