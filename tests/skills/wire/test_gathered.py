"""What is gathered off a robot's bus, and off what all robots of its site share."""

from __future__ import annotations

import threading
import time

from tandem.skills.wire.configs import router_config
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint

WITHIN = 20.0
"""Seconds, on a machine that others use, too."""


def test_other_robots_are_gathered_with_one_s_own_keys_in_one_order() -> None:
    endpoint, pause = free_endpoint(), threading.Event()
    router = open_session(router_config(endpoint), endpoint)
    own, other = ZenohBus(endpoint, "gathered/r2"), ZenohBus(endpoint, "gathered/r3")
    heard = own.gather(("task/*",), depth=8, of_site=("world/robots/*",))
    found: list[tuple[str, bytes]] = []
    until = time.monotonic() + WITHIN
    while len(found) < 2 and time.monotonic() < until:
        if not found:
            other.commons().publish("world/robots/r3", b"here")
        elif found[-1][0].startswith("world"):
            own.publish("task/one", b"mine")
        pause.wait(0.05)
        found += [each for arrival in heard.drain() if (each := (arrival.key, arrival.payload)) not in found]
    assert found == [("world/robots/r3", b"here"), ("task/one", b"mine")]
    heard.close()
    own.close()
    other.close()
    router.close()
