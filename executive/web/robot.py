"""The server's ends of the bus: a client that asks, and ears that are open only while somebody looks on."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import NotConnectedError
from tandem.executive.config.run_options import BusOptions
from tandem.executive.security.holders import KeysError
from tandem.executive.security.identity import Identity
from tandem.executive.security.rights import Rights
from tandem.executive.web.viewers import Update
from tandem.skills.ports.bus import Bus, Commons
from tandem.skills.ports.match import matches
from tandem.skills.ports.tasks import by_client
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus

REPLAY: Final = "replay"
"""The role of who looks at a record."""


@dataclass(frozen=True)
class Who:
    """In whose name the page asks."""

    name: str
    """Of a person, for who finds the robot stopped."""
    role: str = "operator"
    """As on the bus: without keys everybody on this host may do everything."""
    rights: Rights | None = None
    """What the key allows; None: everything."""
    remote: bool = False
    """Whether the page's own key asks for them: they have logged in, and are named in what they request."""

    def may_ask(self, key: str) -> bool:
        """Say whether a question at the key is allowed, in the holder's own name or in nobody's."""
        if self.rights is None:
            return True
        own = by_client(self.name, key)
        return any(matches(each, key) or matches(each, own) for each in self.rights.asks)


class Robot(Protocol):
    """What the page's server needs of a robot."""

    @property
    def options(self) -> BusOptions:
        """Where it is."""
        ...

    @property
    def who(self) -> Who:
        """In whose name is asked."""
        ...

    async def client(self) -> AsyncClient:
        """Return the client that asks; NotConnectedError when no router answers."""
        ...

    async def listen(self) -> Ears:
        """Open an end that hears; NotConnectedError when no router answers."""
        ...

    async def close(self) -> None:
        """Leave."""
        ...


@dataclass(frozen=True)
class Ears:
    """An end of the bus, and how it is closed."""

    bus: Bus
    close: Callable[[], None]
    commons: Commons | None = None
    """Where the robots of the site tell where they are."""
    age: Callable[[], float] = time.monotonic
    """Seconds by which what they told grows old."""
    turn: Callable[[], Update] = dict
    """Called before each poll; returns what else is new."""
    over: Callable[[], bool] = lambda: False
    """Says whether what was heard is of no use any more: listen anew."""


class RobotOnZenoh:
    """A robot at a router; implements ``Robot``.

    Args:
        options: where it is, and whose keys are shown.
        who: in whose name is asked.
        identity: whose key is shown; None: no keys.
    """

    def __init__(self, options: BusOptions, who: Who, identity: Identity | None) -> None:
        self._options, self._who, self._identity = options, who, identity
        self._client: AsyncClient | None = None
        self._opening = asyncio.Lock()

    @property
    def options(self) -> BusOptions:
        """Where it is."""
        return self._options

    @property
    def who(self) -> Who:
        """In whose name is asked."""
        return self._who

    async def client(self) -> AsyncClient:
        """Return the client, connected when somebody first asks."""
        async with self._opening:
            if self._client is None:
                where = self._options
                made = AsyncClient(
                    where.endpoint, site=where.site, robot=where.robot, identity=self._identity
                )
                self._client = await made.connect()
        return self._client

    async def listen(self) -> Ears:
        """Open a session that hears; it wakes nobody, who hears it looks twenty times a second."""
        where = self._options
        try:
            shown = None if self._identity is None else self._identity.client()
            bus = await asyncio.to_thread(ZenohBus, where.endpoint, where.prefix, credentials=shown)
        except (BusError, KeysError) as error:
            raise NotConnectedError(str(error)) from error
        return Ears(bus, bus.close, bus.commons())

    async def close(self) -> None:
        """Leave."""
        if self._client is not None:
            client, self._client = self._client, None
            await client.close()
