"""Every ear of a process counts the strays that it meets, under the name at which it hears."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import pytest
import zenoh

from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.ports.keys import CLOCK, Latest
from tandem.skills.wire.configs import client_config, router_config
from tandem.skills.wire.foreign_session import ForeignSession
from tandem.skills.wire.strays import Strays
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint

WITHIN = 20.0
"""Seconds, on a machine that others use, too."""


def gathers(bus: ZenohBus, _: str) -> Callable[[], object]:
    return bus.gather(("hw/clock",), depth=8).close


def listens(bus: ZenohBus, _: str) -> Callable[[], object]:
    return Latest(bus, CLOCK).close


def is_foreign(bus: ZenohBus, endpoint: str) -> Callable[[], object]:
    session = ForeignSession(endpoint, bus.waker, bus.strays)
    session.hear("strays/r2/hw/clock", 8)
    return session.close


def beats(bus: ZenohBus, _: str) -> Callable[[], object]:
    bus.awake()
    return lambda: None


@pytest.mark.parametrize(
    ("ear", "heard_at"),
    [
        (gathers, "hw/clock"),
        (listens, "hw/clock"),
        (is_foreign, "strays/r2/hw/clock"),
        (beats, "beat/*"),
    ],
)
def test_what_is_put_on_a_wildcard_and_deletions_are_counted(
    ear: Callable[[ZenohBus, str], Callable[[], object]], heard_at: str
) -> None:
    endpoint, pause = free_endpoint(), threading.Event()
    router = open_session(router_config(endpoint), endpoint)
    bus = ZenohBus(endpoint, "strays/r2")
    stranger: zenoh.Session = open_session(client_config(endpoint, 2.0, None), endpoint)
    close = ear(bus, endpoint)
    until = time.monotonic() + WITHIN
    while (heard_at, Reason.STRAY) not in bus.ear.refused and time.monotonic() < until:
        stranger.put("strays/**", b"{}")
        stranger.delete("strays/r2/hw/clock")
        pause.wait(0.05)
        bus.beat()
    assert bus.ear.refused.get((heard_at, Reason.STRAY), 0) > 0
    close()
    bus.close()
    stranger.close()  # type: ignore[no-untyped-call]
    router.close()


def test_two_sessions_of_a_process_may_note_at_once() -> None:
    strays, ear = Strays(), Ear()
    threads = [threading.Thread(target=lambda: [strays.note("a") for _ in range(20_000)]) for _ in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    strays.tell(ear)
    assert ear.refused == {("a", Reason.STRAY): 80_000}
