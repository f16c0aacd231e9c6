"""The bus: how nodes talk. One contract, two buses: in memory (lockstep) and zenoh (processes)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

from tandem.skills.ports.lease import Lease
from tandem.skills.ports.message import MAX_REQUEST_BYTES

if TYPE_CHECKING:
    from tandem.skills.ports.hearing import Ear


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
    """One query that waits for its answer. Answer once; unanswered, it ends empty when dropped.

    Only ``tandem.skills.ports.serving`` reads these: whether a query may do anything is decided there.
    """

    @property
    def key(self) -> str:
        """The key served here that is asked, relative to ``<site>/<robot>``; never a selector.

        Empty when the desk's own key and the selector both have wildcards.
        """
        ...

    @property
    def selector(self) -> str:
        """What was asked, perhaps with wildcards; as long as it begins so, without ``<site>/<robot>``."""
        ...

    @property
    def size(self) -> int:
        """Bytes that were sent along."""
        ...

    @property
    def payload(self) -> bytes:
        """What was sent along; empty when it was more than the desk takes."""
        ...

    def covers(self, key: str) -> bool:
        """Say whether the selector stands for the key."""
        ...

    def reply(self, payload: bytes) -> None:
        """Answer under ``key``; a second answer is ignored."""
        ...

    def reply_each(self, answers: Mapping[str, bytes]) -> None:
        """Answer a selector under each key that it covers, and end."""
        ...

    def refuse(self, payload: bytes) -> None:
        """Answer with an error; ignored after an answer."""
        ...

    def end(self) -> None:
        """End without an answer."""
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

    def refusal(self) -> bytes | None:
        """Return the error that was answered, or None."""
        ...

    def done(self) -> bool:
        """Say whether no (further) answer will come; done without an answer means "not known"."""
        ...


class Commons(Protocol):
    """What all robots of a site share: keys are relative to ``<site>``, and begin with ``world/``.

    Only messages: nothing is asked or served there, so that no robot waits for another.
    """

    @property
    def ear(self) -> Ear:
        """What this process checks what it hears by."""
        ...

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed, of whatever robot."""
        ...

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on; of each key ``depth`` are kept."""
        ...

    def lease(self) -> Lease | None:
        """Return None: nobody commands another robot."""
        ...


class Bus(Protocol):
    """Keys are relative to ``<site>/<robot>``; ``*`` stands for one part of a key, ``**`` for any number."""

    @property
    def ear(self) -> Ear:
        """What this process checks what it hears by; ``Latest`` and ``Heard`` do it."""
        ...

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed; nobody need listen, and a reader that is slow is not waited for."""
        ...

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on.

        Of each key ``depth`` are kept; then the oldest of that key go.
        """
        ...

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Query the process that serves the key. ``timeout`` is in seconds of the host's monotonic clock."""
        ...

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression. Of each key a bounded number waits; more end unanswered.

        Of a query with more than ``limit`` bytes only the size is kept. For ``skills.ports.serving`` alone.
        """
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

    def goes_on(self, name: str) -> bool:
        """Say whether one name is among those. Who asks after few names need not hear of all the others."""
        ...

    def lease(self) -> Lease | None:
        """Return the lease of this process's role; its commands carry it. None while it holds none."""
        ...
