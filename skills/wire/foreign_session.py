"""A session among others than Tandem's processes: whole keys, attachments, and tokens of their own making."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import zenoh

from tandem.skills.wire.configs import client_config
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.direct import direct
from tandem.skills.wire.keyed_queue import KeyedQueue
from tandem.skills.wire.strays import Strays, hear
from tandem.skills.wire.zenoh_bus import open_session
from tandem.skills.wire.zenoh_ends import Waker


@dataclass(frozen=True)
class ForeignSample:
    """One message: its whole key, and what was put."""

    key: str
    payload: bytes


@dataclass(eq=False)
class ForeignInbox:
    """What has come and nobody has read yet."""

    waiting: KeyedQueue[ForeignSample]

    def drain(self) -> list[ForeignSample]:
        """Take all of it, oldest first."""
        return self.waiting.drain()


class ForeignSession:
    """A client of a router. Close it, or the process hangs at its exit.

    Args:
        endpoint: the router's.
        waker: told when something has come.
        strays: counts what is no message; the process's bus tells of them.
        patience: seconds in which the router must answer.
        credentials: for a router that speaks TLS.

    Raises:
        BusError: when it does not.
    """

    def __init__(
        self,
        endpoint: str,
        waker: Waker,
        strays: Strays,
        *,
        patience: float = 2.0,
        credentials: Credentials | None = None,
    ) -> None:
        self._waker, self._strays = waker, strays
        self._session = open_session(client_config(endpoint, patience, credentials), endpoint)
        self._kept: list[object] = []

    @property
    def zid(self) -> str:
        """The session's id, in hexadecimal."""
        return str(self._session.zid())

    def putter(self, key: str) -> Callable[[bytes, bytes], None]:
        """Return what puts a payload with its attachment on a key."""
        publisher = self._session.declare_publisher(key, express=True)
        self._kept.append(publisher)

        def put(payload: bytes, attachment: bytes) -> None:
            publisher.put(payload, attachment=attachment)

        return put

    def hear(self, expression: str, depth: int) -> ForeignInbox:
        """Receive what is put on a key expression; of each key ``depth`` are kept."""
        inbox = ForeignInbox(KeyedQueue(depth, "oldest goes"))

        def take(key: str, sample: zenoh.Sample) -> None:
            inbox.waiting.put(key, ForeignSample(key, sample.payload.to_bytes()))
            self._waker.wake()

        self._kept.append(hear(self._session, expression, self._strays, expression, take))
        return inbox

    def show(self, token: str) -> None:
        """Show a liveliness token until the session ends."""
        self._kept.append(self._session.liveliness().declare_token(token))

    def watch(self, expression: str) -> Mapping[str, None]:
        """Return the tokens of others, kept up to date while the session lasts."""
        shown: dict[str, None] = {}

        def changed(sample: zenoh.Sample) -> None:
            if sample.kind == zenoh.SampleKind.PUT:
                shown[str(sample.key_expr)] = None
            else:
                shown.pop(str(sample.key_expr), None)

        self._kept.append(
            self._session.liveliness().declare_subscriber(expression, direct(changed), history=True)
        )
        return shown

    def close(self) -> None:
        """End the session. Closing twice is allowed."""
        if not self._session.is_closed():
            self._session.close()  # type: ignore[no-untyped-call]
