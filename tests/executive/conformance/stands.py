"""A simulated robot in memory behind a driver that may be wrong, and the bench that checks it."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from tandem.executive.conformance.bench import Bench
from tandem.executive.conformance.clause import Clause, Finding
from tandem.executive.conformance.running import run
from tandem.sim.scenario import load_scenario
from tandem.sim.station import Station, StationSettings
from tandem.skills.ports.bus import Bus, Desk, Inbox, Request, Sample
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.ports.lease import Claim
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus, MemoryHub


class Driver:
    """A sound driver: passes everything on. A wrong one overrides what it gets wrong."""

    def begin(self, bus: Bus) -> None:
        """Take the bus, before anything is served."""

    def tells(self, key: str, payload: bytes) -> list[bytes]:
        """Return what is published instead of a message."""
        del key
        return [payload]

    def takes(self, request: Request) -> bytes | None:
        """Return the document that is carried out instead of a request's; None: it has been dealt with."""
        return request.payload

    def answers(self, key: str, payload: bytes) -> bytes:
        """Return what is answered instead."""
        del key
        return payload

    def hears(self, key: str, samples: list[Sample]) -> list[Sample]:
        """Return what is carried out instead of a streamed command's newest messages."""
        del key
        return samples


@dataclass(eq=False)
class _Request:
    driver: Driver
    inner: Request
    payload: bytes

    @property
    def size(self) -> int:
        return len(self.payload)

    def reply(self, payload: bytes) -> None:
        self.inner.reply(self.driver.answers(self.inner.key, payload))

    def __getattr__(self, name: str) -> Any:
        return getattr(self.inner, name)


@dataclass(eq=False)
class _Desk:
    driver: Driver
    inner: Desk

    def drain(self) -> list[Request]:
        taken = [(each, self.driver.takes(each)) for each in self.inner.drain()]
        return [_Request(self.driver, each, payload) for each, payload in taken if payload is not None]

    def close(self) -> None:
        self.inner.close()


@dataclass(eq=False)
class _Inbox:
    driver: Driver
    key: str
    inner: Inbox

    def drain(self) -> list[Sample]:
        return self.driver.hears(self.key, self.inner.drain())

    def close(self) -> None:
        self.inner.close()


class DriversBus(ForwardingBus):
    """The bus of the simulated hardware, behind a driver."""

    def __init__(self, inner: Bus, driver: Driver) -> None:
        super().__init__(inner)
        self._driver = driver
        driver.begin(inner)

    def publish(self, key: str, payload: bytes) -> None:
        for each in self._driver.tells(key, payload):
            super().publish(key, each)

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        return _Inbox(self._driver, key, super().subscribe(key, depth=depth))

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        return _Desk(self._driver, super().serve(key, limit=limit))


@dataclass(eq=False)
class Stand:
    """A robot behind a driver, and the bench that checks it."""

    station: Station
    bench: Bench

    def wait(self) -> None:
        self.station.step()

    def check(self, clauses: Sequence[Clause]) -> list[Finding]:
        """Try the clauses."""
        return list(run(clauses, self.bench, self.wait))


@contextmanager
def stand(scenario: str, driver: Driver | None = None) -> Iterator[Stand]:
    """Put a scenario's robot behind a driver; a sound one unless given."""
    read, hub = load_scenario(scenario), MemoryHub()
    bus = DriversBus(MemoryBus(hub), driver or Driver())
    station = Station(bus, load(read.site), read, StationSettings(boot="stand", seed=1))
    claim = Claim("check", 1, 1, "host")
    bench = Bench(MemoryBus(hub), time.monotonic, claim)  # as the hardware's leases
    try:
        yield Stand(station, bench)
    finally:
        bench.close()
        station.close()
