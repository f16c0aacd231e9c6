"""The bus over zenoh: between processes, through a router.

zenoh's callbacks only enqueue and wake the one loop; everything else happens in the loop's own thread.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

import zenoh

from tandem.skills.ports.bus import Desk, Inbox, Pending
from tandem.skills.ports.delivery import KEPT, LARGE, Delivery, delivery_of, passing
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.lease import Lease
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.ports.refusals import REFUSALS, RefusalTeller
from tandem.skills.wire.beats import BEAT, SELDOM, SELDOM_EVERY, Beats, key_of
from tandem.skills.wire.configs import client_config
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.direct import direct
from tandem.skills.wire.kept_states import AT_ONCE, Kept
from tandem.skills.wire.keyed_queue import KeyedQueue
from tandem.skills.wire.pulse import SILENT_AFTER, Pulse
from tandem.skills.wire.strays import Strays, hear
from tandem.skills.wire.subscriptions import Subscriptions
from tandem.skills.wire.zenoh_ends import Waker, ZenohDesk, ZenohPending, ZenohRequest

DEFAULT_ENDPOINT: Final = "tcp/127.0.0.1:7447"
PROCESS: Final = "process/"
"""Before the name of a process that is ready, among the names that it announces."""
NO_ROOM: Final = "zenoh can't start on this host"
PUBLISHERS: Final = 256
"""Keys whose publisher stays declared: a process has a few dozen. The one used longest ago goes first."""


@dataclass(frozen=True)
class Means:
    """What zenoh does for one way of delivery."""

    congestion: zenoh.CongestionControl
    priority: zenoh.Priority


_SMALL: Final = Means(zenoh.CongestionControl.DROP, zenoh.Priority.DATA)
MEANS: Final[Mapping[Delivery, Means]] = {
    Delivery.CONTROL: _SMALL,
    Delivery.STATE: _SMALL,
    Delivery.BULK: Means(zenoh.CongestionControl.BLOCK_FIRST, zenoh.Priority.DATA_LOW),
}
"""Nothing here blocks. ``DROP`` gives up after 1 ms without room on the way out. Nothing is sent as zenoh's
``express`` either: each such message takes a batch of its own, and a burst of 500 then fills the queue and
loses half of itself; without it, messages that wait share a batch, and one alone goes at once. A picture is
four times as large as that: with ``BLOCK_FIRST`` one is passed on beside the publisher's own thread, and
those that come before it is through are dropped."""


class BusError(ConnectionError):
    """The bus can't be reached; the message says what was tried."""


class HostError(BusError):
    """It is this host that has no room for zenoh."""


def open_session(config: zenoh.Config, endpoint: str) -> zenoh.Session:
    """Open a session.

    Raises:
        BusError: naming the endpoint.
    """
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        raise BusError(f"no zenoh router answers at {endpoint}; is `tandem up` running there?") from error
    except BaseException as error:
        # A panic of zenoh's is no Exception. It needs some ten files and seven threads.
        if type(error).__name__ != "PanicException":
            raise
        limits = f"{NO_ROOM}; `ulimit -a` shows this shell's limits of open files and processes"
        raise HostError(f"{limits} ({error})") from error


class RouterSession:
    """A session that passes on what others say.

    Raises:
        BusError: when it can't listen.
    """

    def __init__(self, config: zenoh.Config, endpoints: Sequence[str]) -> None:
        self._session = open_session(config, ", ".join(endpoints))

    def close(self) -> None:
        """End it; its clients look for another."""
        self._session.close()  # type: ignore[no-untyped-call]


class ZenohBus:
    """One process's end; implements ``skills.ports.bus.Bus``. Close it, or the process hangs at its exit.

    Args:
        endpoint: the router's, such as ``tcp/127.0.0.1:7447``.
        prefix: ``<site>/<robot>``, put before every key.
        patience: seconds in which the router must answer.
        waker: told when something has arrived; one of its own unless given.
        credentials: for a router that speaks TLS.
        silent_after: host seconds without a beat after which a process is said not to go on.
        pictures: see ``configs.client_config``.
        seldom: hear who goes on once a second instead of ten times; for a ``silent_after`` of some seconds.

    Raises:
        BusError: when it does not.
    """

    def __init__(
        self,
        endpoint: str,
        prefix: str,
        *,
        patience: float = 2.0,
        waker: Waker | None = None,
        credentials: Credentials | None = None,
        silent_after: float = SILENT_AFTER,
        pictures: bool = False,
        seldom: bool = False,
    ) -> None:
        self.waker = waker or Waker()
        self.ear = Ear(time.monotonic)
        self._refusals = RefusalTeller(self.ear)
        self._kept = Kept(time.monotonic)
        self._kept_desk: Desk | None = None
        self._prefix = prefix
        self._session = open_session(
            client_config(endpoint, patience, credentials, pictures=pictures), endpoint
        )
        self.strays = Strays()
        """Counts what is no message, for all that this process hears."""
        self._subscriptions = Subscriptions(self._session, prefix, self.waker, self.strays)
        self._publishers: dict[tuple[str, Delivery], zenoh.Publisher] = {}
        self._tokens: list[zenoh.LivelinessToken] = []
        self._names: dict[str, None] = {}
        self._own: list[str] = []
        self._claims: dict[str, zenoh.LivelinessToken] = {}
        self.held: Lease | None = None
        """This process's lease, once it is granted."""
        self._pulse = Pulse(time.monotonic, silent_after)
        self._beats = Beats(self._session, prefix, self._pulse, self.strays, seldom=seldom)
        self._beaten = 0
        self._liveliness = self._session.liveliness().declare_subscriber(
            f"{prefix}/alive/**", direct(self._on_liveliness), history=True
        )

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        # What is larger than the way out goes as pictures do, whatever it is.
        how = Delivery.BULK if len(payload) > LARGE else delivery_of(key)
        if delivery_of(key) is Delivery.STATE:
            self._keep(key, payload)
        self._send(key, payload, how)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        return self._subscriptions.add(key, depth)

    def gather(self, keys: Sequence[str], *, depth: int, of_site: Sequence[str] = ()) -> Gathered:
        """Receive what is put on any of several key expressions, in the order in which it arrives.

        ``of_site`` are relative to ``<site>``: what all its robots share.

        It wakes nobody: who gathers looks now and then. Of each key ``depth`` are kept until they are taken.
        """
        site = self._prefix.partition("/")[0]
        return Gathered(self._session, {self._prefix: keys, site: of_site}, depth, self.strays)

    def commons(self) -> ZenohCommons:
        """Return the end, on the same session, of what all robots of the site share."""
        site = self._prefix.partition("/")[0]
        return ZenohCommons(
            self._session, site, self.ear, Subscriptions(self._session, site, self.waker, self.strays)
        )

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Query the process that serves the key."""
        pending = ZenohPending(self.waker)
        self._session.get(
            f"{self._prefix}/{key}",
            direct(pending.take, pending.end),
            payload=payload,
            timeout=timeout,
            express=True,
            # The answer goes the same way: neither waits for who does not read.
            congestion_control=zenoh.CongestionControl.DROP,
        )
        return pending

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer queries on the key expression."""
        desk, prefix = ZenohDesk(), f"{self._prefix}/"

        def asked(query: zenoh.Query) -> None:
            whole = str(query.key_expr)
            selector = whole.removeprefix(prefix)
            own = next((each for each in (key, selector) if "*" not in each), "")
            # All selectors share one queue: they are no keys, and whoever makes them up gets no more room.
            line = "" if "*" in selector else selector
            if not desk.waiting.has_room(line):
                query.drop()  # type: ignore[no-untyped-call]
                return
            size = 0 if query.payload is None else len(query.payload)
            body = b"" if query.payload is None or size > limit else query.payload.to_bytes()
            desk.waiting.put(line, ZenohRequest(own, selector, size, body, prefix, query))
            self.waker.wake()

        desk.queryable = self._session.declare_queryable(f"{self._prefix}/{key}", direct(asked))
        return desk

    def listened(self, key: str) -> bool:
        """Say whether anybody subscribes to the key."""
        status = self._publisher(key, delivery_of(key)).matching_status
        # zenoh's type hints promise a bool, its library gives an object that holds one.
        return bool(getattr(status, "matching", status))

    def announce(self, name: str) -> None:
        """Show that this process is alive as ``name`` until its session ends; twice is once."""
        if name in self._own:
            return
        self._tokens.append(self._session.liveliness().declare_token(f"{self._prefix}/alive/{name}"))
        self._own.append(name)

    def beat(self) -> None:
        """Show that this process goes on, and tell what it refused; called once a turn by its loop alone."""
        if self._pulse.turn():
            self._beat()
            self._beats.rest()
            self.strays.tell(self.ear)
            refused = self._refusals.due(_process(self._own), time.monotonic())
            if refused is not None:
                REFUSALS.publish(self, refused)
            for key, payload in self._kept.due():
                self._send(key, payload, delivery_of(key))
            self._answer_kept()

    def alive(self) -> frozenset[str]:
        """Return the names that are announced now."""
        return frozenset(self._names)

    def awake(self) -> frozenset[str]:
        """Return those of them whose process goes on."""
        self._beats.hear_all()
        return self._pulse.awake(self.alive())

    def goes_on(self, name: str) -> bool:
        """Say whether a name is announced and its process goes on: of the others nothing need be heard."""
        if name not in self._names:
            return False
        self._beats.hear(name)
        return bool(self._pulse.awake((name,)))

    def lease(self) -> Lease | None:
        """Return what this process holds."""
        return self.held

    def claim(self, key: str) -> None:
        """Show a claim until it is withdrawn or the session ends. ``skills.wire.presence`` says what for."""
        self._claims[key] = self._session.liveliness().declare_token(f"{self._prefix}/{key}")

    def withdraw(self, key: str) -> None:
        """Take a claim back. One that is not shown is none."""
        token = self._claims.pop(key, None)
        if token is not None:
            token.undeclare()  # type: ignore[no-untyped-call]

    def claims(self, key: str, *, timeout: float) -> frozenset[str]:
        """Ask the router for the claims under a key expression; blocks for at most ``timeout`` seconds."""
        replies = self._session.liveliness().get(f"{self._prefix}/{key}", timeout=timeout)
        start = len(self._prefix) + 1
        return frozenset(str(reply.ok.key_expr)[start:] for reply in replies if reply.ok is not None)

    def neighbours(self, *, timeout: float) -> frozenset[str]:
        """Return the other ``<site>/<robot>`` with processes at the router, within ``timeout`` seconds."""
        replies = self._session.liveliness().get("*/*/alive/process/**", timeout=timeout)
        keys = (str(reply.ok.key_expr) for reply in replies if reply.ok is not None)
        return frozenset("/".join(key.split("/")[:2]) for key in keys) - {self._prefix}

    def close(self) -> None:
        """End the session. Closing twice is allowed."""
        if not self._session.is_closed():
            self._session.close()  # type: ignore[no-untyped-call]

    def _keep(self, key: str, payload: bytes) -> None:
        self._kept.note(key, payload)
        if self._kept_desk is None:
            self._kept_desk = self.serve(f"{KEPT}**")

    def _answer_kept(self) -> None:
        """Answer who asks what was said last, under the key of each; a wildcard gets all that match."""
        asked = [] if self._kept_desk is None else self._kept_desk.drain()
        for request in asked[:AT_ONCE]:
            known = {f"{KEPT}{key}": payload for key, payload in self._kept.latest.items()}
            request.reply_each({key: payload for key, payload in known.items() if request.covers(key)})
        for request in asked[AT_ONCE:]:
            request.end()

    def _send(self, key: str, payload: bytes, how: Delivery) -> None:
        if passing(key):
            means = MEANS[how]
            self._session.put(
                f"{self._prefix}/{key}",
                payload,
                congestion_control=means.congestion,
                priority=means.priority,
            )
        else:
            self._publisher(key, how).put(payload)

    def _publisher(self, key: str, how: Delivery) -> zenoh.Publisher:
        publisher = self._publishers.pop((key, how), None)
        if publisher is None:
            means = MEANS[how]
            publisher = self._session.declare_publisher(
                f"{self._prefix}/{key}",
                congestion_control=means.congestion,
                priority=means.priority,
            )
        self._publishers[(key, how)] = publisher  # the one used last stands last
        if len(self._publishers) > PUBLISHERS:
            self._publishers.pop(next(iter(self._publishers))).undeclare()  # type: ignore[no-untyped-call]
        return publisher

    def _on_liveliness(self, sample: zenoh.Sample) -> None:
        name = str(sample.key_expr)[len(self._prefix) + len("/alive/") :]
        if sample.kind == zenoh.SampleKind.PUT:
            self._names[name] = None
        else:
            self._names.pop(name, None)
            self._pulse.forget(name)
            self._beats.forget(name)
        self.waker.wake()

    def _beat(self) -> None:
        if not self._own:
            return  # nobody asks after a process without a name
        key, names = key_of(_process(self._own)), "\n".join(self._own)
        self._publisher(key, Delivery.CONTROL).put(names)
        if self._beaten % SELDOM_EVERY == 0:
            self._publisher(f"{key}/{SELDOM}", Delivery.CONTROL).put(names)
        if self.listened(BEAT):
            self._publisher(BEAT, Delivery.CONTROL).put(names)
        self._beaten += 1


@dataclass(frozen=True)
class Arrival:
    """One message, and when it arrived."""

    key: str
    payload: bytes
    monotonic: int
    """Nanoseconds of the host's monotonic clock."""


class Gathered:
    """What was put on several key expressions, in one order; see ``ZenohBus.gather``.

    Args:
        session: it ends with its owner.
        keys: expressions, by what is put before each; a message that two of them stand for comes twice.
        depth: how many of each key are kept.
        strays: counts what is no message.
    """

    def __init__(
        self, session: zenoh.Session, keys: Mapping[str, Sequence[str]], depth: int, strays: Strays
    ) -> None:
        self._waiting: KeyedQueue[Arrival] = KeyedQueue(depth, "oldest goes")

        def take(start: int, whole: str, sample: zenoh.Sample) -> None:
            key = whole[start:]
            self._waiting.put(key, Arrival(key, sample.payload.to_bytes(), time.monotonic_ns()))

        self._subscribers = [
            hear(session, f"{prefix}/{key}", strays, key, partial(take, len(prefix) + 1))
            for prefix, of_it in keys.items()
            for key in of_it
        ]

    def drain(self) -> list[Arrival]:
        """Take all that has arrived."""
        return self._waiting.drain()

    def close(self) -> None:
        """End the subscriptions. Closing twice is allowed."""
        while self._subscribers:
            self._subscribers.pop().undeclare()  # type: ignore[no-untyped-call]


class ZenohCommons:
    """What all robots of a site share; implements ``skills.ports.bus.Commons`` on a process's session.

    Args:
        session: it ends with its owner.
        site: put before every key.
        ear: of the process.
        subscriptions: on keys of the site.
    """

    def __init__(self, session: zenoh.Session, site: str, ear: Ear, subscriptions: Subscriptions) -> None:
        self._session, self._site = session, site
        self._subscriptions = subscriptions
        self.ear = ear
        self._publishers: dict[str, zenoh.Publisher] = {}

    def publish(self, key: str, payload: bytes) -> None:
        """Send to all who subscribed."""
        publisher = self._publishers.get(key)
        if publisher is None:
            means = MEANS[delivery_of(key)]
            publisher = self._session.declare_publisher(
                f"{self._site}/{key}",
                congestion_control=means.congestion,
                priority=means.priority,
            )
            self._publishers[key] = publisher
        publisher.put(payload)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive what is put on the key expression from now on."""
        return self._subscriptions.add(key, depth)

    def lease(self) -> Lease | None:
        """Return None: nobody commands another robot."""
        return None


def _process(names: Sequence[str]) -> str:
    """Return the name of the process that is announced by these names."""
    told = [name.removeprefix(PROCESS) for name in names if name.startswith(PROCESS)]
    return next(iter((*told, *names)), "")


def wait_until(bus: ZenohBus, condition: Pending, timeout: float) -> bytes | None:
    """Block until a query is answered or ended, at most ``timeout`` seconds. For commands, not for nodes."""
    deadline = time.monotonic() + timeout
    while not condition.done() and condition.poll() is None and time.monotonic() < deadline:
        bus.waker.wait(max(0.0, deadline - time.monotonic()))
    return condition.poll()
