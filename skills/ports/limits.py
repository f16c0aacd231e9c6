"""What an endpoint takes from one sender: bytes, nesting, queries in one step, queries in a second."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tandem.skills.ports.message import MAX_REQUEST_BYTES

SENDERS: Final = 256
"""Senders whose rate is remembered; the one that was silent longest is forgotten first."""
MAX_DEPTH: Final = 16
"""Objects and arrays within each other: the deepest document of ours, a fault with a shape, has 6."""


@dataclass(frozen=True)
class Limits:
    """The limits of one endpoint. The defaults suit small documents whose handler takes less than 1 ms."""

    bytes: int = MAX_REQUEST_BYTES
    """Size of a document; a larger one is refused unread."""
    depth: int = MAX_DEPTH
    """Objects and arrays within each other."""
    per_step: int = 16
    """Queries that one step handles; the others wait for the next. 16 of 1 ms are a tenth of what counts as
    a stalled loop (0.15 s)."""
    rate: float = 100.0
    """Queries of one sender in a second of the host, in the long run."""
    burst: float = 300.0
    """Queries of one sender that may come at once."""


SMALL: Final = Limits()


@dataclass
class _Bucket:
    tokens: float
    at: float


class Rates:
    """A token bucket for each sender: https://en.wikipedia.org/wiki/Token_bucket.

    Args:
        rate: tokens in a second.
        burst: tokens that a bucket holds.
        monotonic: the host's monotonic clock, in seconds.
    """

    def __init__(self, rate: float, burst: float, monotonic: Callable[[], float]) -> None:
        self._rate, self._burst, self._monotonic = rate, burst, monotonic
        self._buckets: OrderedDict[str, _Bucket] = OrderedDict()

    def take(self, sender: str) -> float:
        """Take a token; return 0, or the seconds until there is one."""
        if math.isinf(self._rate):
            return 0.0
        now = self._monotonic()
        bucket = self._buckets.setdefault(sender, _Bucket(self._burst, now))
        self._buckets.move_to_end(sender)
        if len(self._buckets) > SENDERS:
            self._buckets.popitem(last=False)
        bucket.tokens = min(self._burst, bucket.tokens + (now - bucket.at) * self._rate)
        bucket.at = now
        if bucket.tokens < 1.0:
            return (1.0 - bucket.tokens) / self._rate
        bucket.tokens -= 1.0
        return 0.0
