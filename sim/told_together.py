"""The hardware's bus, on which what is told steadily goes out together, with the tick that it belongs to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tandem.skills.ports.delivery import paced
from tandem.skills.ports.forwarding_bus import ForwardingBus

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Bus


class ToldTogether(ForwardingBus):
    """Holds back what wakes nobody until something comes that does, and keeps the order.

    Joint states, odometry, hands and wrists are read by the clock's tick that follows them. Sent each when it
    is measured, they go in two or three packets, and each packet wakes two threads of every process that
    hears any of them; sent one after the other, they share the clock's.

    Args:
        bus: what is passed on to.
    """

    def __init__(self, bus: Bus) -> None:
        super().__init__(bus)
        self._held: list[tuple[str, bytes]] = []

    def publish(self, key: str, payload: bytes) -> None:
        """Send it, after what was held back; or hold it back, if it wakes nobody."""
        self._held.append((key, payload))
        if paced(key):
            return
        held, self._held = self._held, []
        for each in held:
            super().publish(*each)
