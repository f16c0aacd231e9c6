"""A bus whose ends all close together: what nodes have opened does not outlive them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from tandem.skills.ports.bus import Bus, Desk, Inbox, Pending
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.lease import Lease
from tandem.skills.ports.message import MAX_REQUEST_BYTES

Taken = TypeVar("Taken")


@dataclass(eq=False)
class _End(Generic[Taken]):
    """A subscription or a desk that is noted until it is closed."""

    take: Callable[[], list[Taken]]
    shut: Callable[[], None]
    open_ends: dict[int, Callable[[], None]]
    """Closes each end that is open, by its identity."""

    def drain(self) -> list[Taken]:
        """Take all that has arrived."""
        return self.take()

    def close(self) -> None:
        """End it. Closing twice is allowed."""
        self.open_ends.pop(id(self), None)
        self.shut()


class ScopedBus:
    """Another bus; ``close`` ends the subscriptions and desks that were opened through it.

    A node closes its own, but not those of the skills that it serves, nor those of what these are made of.

    Args:
        bus: what it stands before. What was announced stays announced.
    """

    def __init__(self, bus: Bus) -> None:
        self._bus = bus
        self._open: dict[int, Callable[[], None]] = {}

    @property
    def ear(self) -> Ear:
        """What this process checks what it hears by."""
        return self._bus.ear

    def lease(self) -> Lease | None:
        """Return what this process's commands carry."""
        return self._bus.lease()

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        self._bus.publish(key, payload)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        inbox = self._bus.subscribe(key, depth=depth)
        end = _End(inbox.drain, inbox.close, self._open)
        self._open[id(end)] = end.close
        return end

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Ask whoever serves the key."""
        return self._bus.query(key, payload, timeout=timeout)

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression."""
        desk = self._bus.serve(key, limit=limit)
        end = _End(desk.drain, desk.close, self._open)
        self._open[id(end)] = end.close
        return end

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        return self._bus.listened(key)

    def announce(self, name: str) -> None:
        """Show that this process is alive as ``name``."""
        self._bus.announce(name)

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        return self._bus.alive()

    def awake(self) -> frozenset[str]:
        """Return those of them whose process goes on."""
        return self._bus.awake()

    def close(self) -> None:
        """End all that is open. Closing twice is allowed."""
        for close in tuple(self._open.values()):
            close()
