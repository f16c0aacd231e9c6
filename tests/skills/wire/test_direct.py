"""What runs in zenoh's own threads, which Python has not made."""

from __future__ import annotations

import threading
from typing import Final

import zenoh

from tandem.skills.wire.configs import client_config, router_config
from tandem.skills.wire.direct import direct
from tandem.skills.wire.zenoh_bus import RouterSession
from tests.fakes.ports import free_endpoint

MESSAGES: Final = 8
"""More than zenoh has receiving threads."""


def test_the_receiving_thread_keeps_its_state_from_message_to_message() -> None:
    endpoint, own, counts, done = free_endpoint(), threading.local(), list[int](), threading.Event()

    def take(_: zenoh.Sample) -> None:
        own.count = getattr(own, "count", 0) + 1
        counts.append(own.count)
        if len(counts) == MESSAGES:
            done.set()

    router = RouterSession(router_config(endpoint), (endpoint,))
    hears, tells = (zenoh.open(client_config(endpoint)) for _ in range(2))
    try:
        hears.declare_subscriber("lab/tiago/hw/clock", direct(take))
        while not done.wait(0.01):
            tells.put("lab/tiago/hw/clock", b"")
    finally:
        for session in (hears, tells):
            session.close()  # type: ignore[no-untyped-call]
        router.close()
    assert max(counts) > 1
