"""Whom the hardware waits for, faster than real time."""

from __future__ import annotations

import gc
from types import SimpleNamespace
from typing import cast

from tandem.sim.pace import Followers, run_paced
from tandem.sim.station import Station
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.wire.loop import FOLLOW, FOLLOWS, Followed
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.wire.zenoh_bus import ZenohBus


class Counting(ForwardingBus):
    """A bus whose waker counts how often it is waited for."""

    def __init__(self, inner: MemoryBus) -> None:
        super().__init__(inner)
        self.waker, self.waits = self, 0

    def wait(self, timeout: float) -> None:  # noqa: ARG002 - as a waker is called
        self.waits += 1


def test_it_waits_for_who_follows_and_for_nobody_who_only_listens() -> None:
    bus = Counting(MemoryBus())
    followers = Followers(cast("ZenohBus", bus))
    for name in ("process/recorder", "process/base", f"{FOLLOWS}base"):
        bus.announce(name)
    FOLLOW.publish(bus, Followed(follower="base", tick=3))
    followers.wait_for(3)
    assert bus.waits == 0
    followers.wait_for(4)
    assert bus.waits > 0


def test_what_the_hardware_is_made_of_is_not_looked_through_by_the_collector() -> None:
    """A collection of all takes 30 ms of the process, and a stop that comes then waits for it."""
    station = SimpleNamespace(model=SimpleNamespace(description=SimpleNamespace(period=0.01)))
    try:
        run_paced(cast("Station", station), (), 1.0, lambda: True)
        assert gc.get_freeze_count() > 1000
    finally:
        gc.unfreeze()
