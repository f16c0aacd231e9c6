"""A bus whose ends all close together: what nodes have opened does not outlive them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from tandem.skills.ports.bus import Bus, Desk, Inbox
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.ports.message import MAX_REQUEST_BYTES

Taken = TypeVar("Taken")


@dataclass(eq=False)
class _End(Generic[Taken]):
    """A subscription or a desk that is noted until it is closed."""

    drain: Callable[[], list[Taken]]
    """Takes all that has arrived: the inner end's own, as a process drains a hundred in each turn."""
    shut: Callable[[], None]
    open_ends: dict[int, Callable[[], None]]
    """Closes each end that is open, by its identity."""

    def close(self) -> None:
        """End it. Closing twice is allowed."""
        self.open_ends.pop(id(self), None)
        self.shut()


class ScopedBus(ForwardingBus):
    """Another bus; ``close`` ends the subscriptions and desks that were opened through it.

    A node closes its own, but not those of the skills that it serves, nor those of what these are made of.

    Args:
        bus: what it stands before. What was announced stays announced.
    """

    def __init__(self, bus: Bus) -> None:
        super().__init__(bus)
        self._open: dict[int, Callable[[], None]] = {}

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        inbox = super().subscribe(key, depth=depth)
        end = _End(inbox.drain, inbox.close, self._open)
        self._open[id(end)] = end.close
        return end

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression."""
        desk = super().serve(key, limit=limit)
        end = _End(desk.drain, desk.close, self._open)
        self._open[id(end)] = end.close
        return end

    def close(self) -> None:
        """End all that is open. Closing twice is allowed."""
        for close in tuple(self._open.values()):
            close()
