"""The link between the hardware and everybody else: it can be cut, and what passes can be spoilt."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.ports.message import MAX_REQUEST_BYTES

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from tandem.skills.ports.bus import Bus, Desk, Inbox, Request, Sample


@dataclass(eq=False)
class _Inbox:
    link: FaultyLink
    inner: Inbox

    def drain(self) -> list[Sample]:
        """Take what has arrived; what came through a cut link is lost."""
        return [sample for sample in self.inner.drain() if not self.link.is_cut(sample.key)]

    def close(self) -> None:
        """End the subscription."""
        self.inner.close()


@dataclass(eq=False)
class _Desk:
    link: FaultyLink
    inner: Desk

    def drain(self) -> list[Request]:
        """Take what was asked; what came through a cut link ends without an answer."""
        return [request for request in self.inner.drain() if not self.link.is_cut(request.key)]

    def close(self) -> None:
        """Stop serving."""
        self.inner.close()


class FaultyLink(ForwardingBus):
    """The hardware's bus. While nothing is wrong it passes everything on.

    Args:
        bus: what is passed on to.
    """

    def __init__(self, bus: Bus) -> None:
        super().__init__(bus)
        self.cut: frozenset[str] = frozenset()
        """Beginnings of keys through which nothing comes, neither way."""
        self.spoils: Mapping[str, Callable[[bytes], bytes]] = {}
        """What becomes of a payload, by key."""

    def is_cut(self, key: str) -> bool:
        """Say whether nothing on the key gets through."""
        return any(key.startswith(start) for start in self.cut)

    def publish(self, key: str, payload: bytes) -> None:
        """Send, unless the link is cut."""
        if self.is_cut(key):
            return
        spoil = self.spoils.get(key)
        super().publish(key, payload if spoil is None else spoil(payload))

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression while the link is whole."""
        return _Inbox(self, super().subscribe(key, depth=depth))

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries while the link is whole."""
        return _Desk(self, super().serve(key, limit=limit))

    def listened(self, key: str) -> bool:
        """Say whether what is put on the key reaches anybody."""
        return not self.is_cut(key) and super().listened(key)
