"""How much one client may ask for: a rate of requests, and a number of open ones."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Bounds:
    """What one client may do."""

    rate: float = 100.0
    """Requests in a second of the host, in the long run."""
    burst: float = 300.0
    """Requests that may come at once."""
    open: int = 50
    """Requests of a named client that have not ended. Without names the queue's own bound holds."""
