"""A bus that stands before another one and passes everything on: the base of every wrapper."""

from __future__ import annotations

from tandem.skills.ports.bus import Bus, Desk, Inbox, Pending
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.lease import Lease
from tandem.skills.ports.message import MAX_REQUEST_BYTES


class ForwardingBus:
    """A ``Bus`` that does what the inner bus does. A wrapper overrides what it changes, and nothing else.

    Args:
        inner: the bus that everything is passed on to.
    """

    def __init__(self, inner: Bus) -> None:
        self._inner = inner

    @property
    def ear(self) -> Ear:
        """What this process checks what it hears by."""
        return self._inner.ear

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        self._inner.publish(key, payload)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        return self._inner.subscribe(key, depth=depth)

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Query the process that serves the key."""
        return self._inner.query(key, payload, timeout=timeout)

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression."""
        return self._inner.serve(key, limit=limit)

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        return self._inner.listened(key)

    def announce(self, name: str) -> None:
        """Show that this process is alive as ``name``."""
        self._inner.announce(name)

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        return self._inner.alive()

    def awake(self) -> frozenset[str]:
        """Return those of them whose process goes on."""
        return self._inner.awake()

    def goes_on(self, name: str) -> bool:
        """Say whether one name is among those."""
        return self._inner.goes_on(name)

    def lease(self) -> Lease | None:
        """Return the lease of this process's role."""
        return self._inner.lease()
