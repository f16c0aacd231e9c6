"""How much one client may ask for: a rate, and a number of open requests.

A document's size and depth are bounded in ``executive.documents``.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

CLIENTS: Final = 256
"""Clients whose rate is remembered; the one that was silent longest is forgotten first."""


@dataclass(frozen=True)
class Bounds:
    """What one client may do."""

    rate: float = 100.0
    """Requests in a second of the host, in the long run."""
    burst: float = 300.0
    """Requests that may come at once."""
    open: int = 50
    """Requests of a named client that have not ended. Without names the queue's own bound holds."""


@dataclass
class _Bucket:
    tokens: float
    at: float


class Rates:
    """A token bucket for each client: https://en.wikipedia.org/wiki/Token_bucket.

    Args:
        bounds: rate and burst.
        monotonic: the host's monotonic clock, in seconds.
    """

    def __init__(self, bounds: Bounds, monotonic: Callable[[], float]) -> None:
        self._bounds, self._monotonic = bounds, monotonic
        self._buckets: OrderedDict[str, _Bucket] = OrderedDict()

    def take(self, client: str) -> float:
        """Take a token; return 0, or the seconds until there is one."""
        bounds, now = self._bounds, self._monotonic()
        bucket = self._buckets.setdefault(client, _Bucket(bounds.burst, now))
        self._buckets.move_to_end(client)
        if len(self._buckets) > CLIENTS:
            self._buckets.popitem(last=False)
        bucket.tokens = min(bounds.burst, bucket.tokens + (now - bucket.at) * bounds.rate)
        bucket.at = now
        if bucket.tokens < 1.0:
            return (1.0 - bucket.tokens) / bounds.rate
        bucket.tokens -= 1.0
        return 0.0
