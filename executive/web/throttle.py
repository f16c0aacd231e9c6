"""How often somebody may be wrong at the log-in: each address for itself, and all together."""

from __future__ import annotations

import ipaddress
from collections import deque
from collections.abc import Callable
from typing import Final

TRIES: Final = 10
"""Wrong log-ins of one address in a minute, after which it is heard no more for the rest of it."""
ALL_TRIES: Final = 200
"""Of all addresses: it bounds the work and the memory that somebody with many of them can cause."""
WITHIN: Final = 60.0
"""Host seconds for which a wrong log-in counts."""
HOST_BITS: Final = 64
"""Of an IPv6 address: one computer may choose them as it likes."""


class Throttle:
    """Counts wrong log-ins.

    Args:
        monotonic: seconds of the host.
    """

    def __init__(self, monotonic: Callable[[], float]) -> None:
        self._monotonic = monotonic
        self._wrong: deque[tuple[float, str]] = deque(maxlen=ALL_TRIES)

    def closed_to(self, address: str) -> str:
        """Return why nobody is heard at an address; empty when it is open."""
        now, who = self._monotonic(), _network(address)
        while self._wrong and now - self._wrong[0][0] > WITHIN:
            self._wrong.popleft()
        if sum(each == who for _, each in self._wrong) >= TRIES:
            return "too many wrong log-ins from your address; wait a minute"
        if len(self._wrong) >= ALL_TRIES:
            return "too many wrong log-ins from many addresses; wait a minute"
        return ""

    def note(self, address: str) -> None:
        """Count a wrong log-in."""
        self._wrong.append((self._monotonic(), _network(address)))


def _network(address: str) -> str:
    """Return what counts of an address: of IPv6 its network, of anything that is none the text."""
    try:
        found = ipaddress.ip_address(address)
    except ValueError:
        return address
    if found.version == 6 and found.ipv4_mapped is None:  # noqa: PLR2004
        return str(ipaddress.ip_network((int(found) >> HOST_BITS << HOST_BITS, HOST_BITS)))
    return str(found)
