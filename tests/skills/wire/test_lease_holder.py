"""A process asks again for a lease whose holder has just gone, and gives up before one that is there."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field

import pytest

from tandem.skills.ports.fencing import Grantor
from tandem.skills.ports.lease import Claim
from tandem.skills.ports.serving import Endpoints
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.lease_holder import LeaseHolder
from tandem.skills.wire.presence import Presence, RivalError
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint

FIRST, NEXT = Claim("aa", 1, 10, "host"), Claim("bb", 1, 20, "host")


@dataclass
class Hardware:
    """Grants leases and does nothing else. It works each time a process asks whether to stop."""

    endpoint: str
    grantor: Grantor
    served: Endpoints
    joined: list[ZenohBus] = field(default_factory=list)

    def go_on(self) -> bool:
        self.served.step()
        self.grantor.step()
        return False

    def join(self, claim: Claim) -> tuple[ZenohBus, LeaseHolder]:
        bus = ZenohBus(self.endpoint, "lab/leases")
        self.joined.append(bus)
        return bus, LeaseHolder(bus, ProcessClocks(bus), Presence(bus, "executive", claim))


@pytest.fixture
def hardware() -> Iterator[Hardware]:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    bus = ZenohBus(endpoint, "lab/leases")
    grantor = Grantor(bus, "boot")
    served = Endpoints(bus, time.monotonic, grantor.endpoints())
    made = Hardware(endpoint, grantor, served)
    yield made
    for each in (*made.joined, bus):
        each.close()
    router.close()  # type: ignore[no-untyped-call]


def test_a_lease_is_asked_for_again_while_its_holder_is_only_just_gone(hardware: Hardware) -> None:
    """The hardware spares a holder for a second after the grant, so the first answer is a refusal."""
    first, holder = hardware.join(FIRST)
    holder.acquire(hardware.go_on)
    first.close()
    second, heir = hardware.join(NEXT)
    heir.acquire(hardware.go_on)
    assert second.held is not None
    assert second.held.epoch == 2


def test_a_holder_that_is_there_keeps_its_lease(hardware: Hardware) -> None:
    first, holder = hardware.join(FIRST)
    first.claim(f"claim/executive/{FIRST.text}/in")
    holder.acquire(hardware.go_on)
    second, rival = hardware.join(NEXT)
    with pytest.raises(RivalError, match="process 10 on host"):
        rival.acquire(hardware.go_on)
    assert second.held is None
