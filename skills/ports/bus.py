"""The bus: how nodes talk. One contract, two buses: in memory (lockstep) and zenoh (processes)."""

from __future__ import annotations

from typing import Protocol


class Sample(Protocol):
    """One message that arrived."""

    @property
    def key(self) -> str:
        """The key it was put on, relative to ``<site>/<robot>``."""
        ...

    @property
    def payload(self) -> bytes:
        """What was put."""
        ...


class Request(Protocol):
    """One query that waits for its answer. Answer once; unanswered, it ends empty when dropped."""

    @property
    def key(self) -> str:
        """The key that was asked, relative to ``<site>/<robot>``."""
        ...

    @property
    def payload(self) -> bytes:
        """What was sent along."""
        ...

    def reply(self, payload: bytes) -> None:
        """Answer; a second answer is ignored."""
        ...


class Inbox(Protocol):
    """What a subscription received and nobody has read yet, oldest first."""

    def drain(self) -> list[Sample]:
        """Take all that has arrived."""
        ...

    def close(self) -> None:
        """End the subscription. Closing twice is allowed."""
        ...


class Desk(Protocol):
    """Queries that wait at a key served here, oldest first."""

    def drain(self) -> list[Request]:
        """Take all that has arrived."""
        ...

    def close(self) -> None:
        """Stop serving. Closing twice is allowed."""
        ...


class Pending(Protocol):
    """A query under way. It never blocks."""

    def poll(self) -> bytes | None:
        """Return the answer, or None while there is none."""
        ...

    def done(self) -> bool:
        """Say whether no (further) answer will come; done without an answer means "not known"."""
        ...


class Bus(Protocol):
    """Keys are relative to ``<site>/<robot>``; ``*`` stands for one part of a key, ``**`` for any number."""

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed; nobody need listen."""
        ...

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on.

        Of each key ``depth`` are kept; then the oldest of that key go.
        """
        ...

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Ask whoever serves the key. ``timeout`` is in seconds of the host's monotonic clock."""
        ...

    def serve(self, key: str) -> Desk:
        """Answer queries on the key expression. Of each key a bounded number waits; more end unanswered."""
        ...

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        ...

    def announce(self, name: str) -> None:
        """Show that this process is alive as ``name`` until its session ends."""
        ...

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        ...

    def awake(self) -> frozenset[str]:
        """Return those of them whose process goes on; one that hangs is missed within half a second."""
        ...
