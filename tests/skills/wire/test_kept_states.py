"""A state is said twice and can be asked for: a reader that missed it hears of it all the same."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest
import zenoh

from tandem.skills.ports.delivery import AGAIN_AFTER, KEPT_KEYS
from tandem.skills.ports.hearing import ORDERED
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.world import WORLD, WorldState
from tandem.skills.wire.configs import client_config, router_config
from tandem.skills.wire.kept_states import AT_ONCE, Kept
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint


def test_a_state_is_said_once_more_when_it_has_not_changed_for_a_second() -> None:
    now = [0.0]
    kept = Kept(lambda: now[0])
    kept.note("world/state", b"1")
    now[0] = AGAIN_AFTER / 2
    kept.note("world/state", b"2")
    now[0] = AGAIN_AFTER
    assert list(kept.due()) == []
    now[0] = AGAIN_AFTER * 1.5
    assert list(kept.due()) == [("world/state", b"2")]
    now[0] = AGAIN_AFTER * 9.0
    assert list(kept.due()) == []


def test_many_states_are_said_again_a_few_at_a_time_and_the_oldest_are_forgotten() -> None:
    now = [0.0]
    kept = Kept(lambda: now[0])
    for number in range(KEPT_KEYS + 2):
        kept.note(f"task/{number}/status", b"")
    now[0] = AGAIN_AFTER
    assert [key for key, _ in kept.due()] == [f"task/{number}/status" for number in range(2, 2 + AT_ONCE)]
    assert len(kept.latest) == KEPT_KEYS


def test_what_was_heard_the_first_time_is_no_news_the_second() -> None:
    hub = MemoryHub()
    teller, bus = MemoryBus(hub), MemoryBus(hub)
    latest = Latest(bus, WORLD)
    assert WORLD.key.startswith(ORDERED)
    state = WorldState(stamp=RobotTime(boot="b", seconds=1.0), version=1)
    for _ in range(2):
        WORLD.publish(teller, state)
    assert latest.take() == [state]
    WORLD.publish(teller, state)
    assert latest.take() == []
    assert bus.ear.total == 0


@dataclass
class Net:
    """One of our processes, and a program that knows zenoh only."""

    bus: ZenohBus
    session: zenoh.Session

    def until(self, condition: Callable[[], bool]) -> bool:
        """Turn the process's loop until it is so."""
        deadline = time.monotonic() + 10.0
        while not (held := condition()) and time.monotonic() < deadline:
            self.bus.beat()
            self.bus.waker.wait(0.02)
        return held

    def ask(self, selector: str) -> dict[str, bytes]:
        """Ask until there is an answer: zenoh needs a moment to say that somebody serves."""
        found: dict[str, bytes] = {}

        def take(reply: zenoh.Reply) -> None:
            if reply.ok is not None:
                found[str(reply.ok.key_expr)] = reply.ok.payload.to_bytes()

        def answered() -> bool:
            done: list[bool] = []
            self.session.get(selector, zenoh.handlers.Callback(take, lambda: done.append(True)), timeout=1.0)
            self.until(lambda: bool(done))
            return bool(found)

        assert self.until(answered)
        return found


@pytest.fixture
def net() -> Iterator[Net]:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    bus, session = ZenohBus(endpoint, "kept/robot"), open_session(client_config(endpoint), endpoint)
    yield Net(bus, session)
    session.close()  # type: ignore[no-untyped-call]
    bus.close()
    router.close()


def test_a_late_reader_asks_for_what_was_said(net: Net) -> None:
    net.bus.publish("world/state", b"first")
    net.bus.publish("world/state", b"last")
    net.bus.publish("skill/base/drive/status", b"done")
    net.bus.publish("hw/clock", b"a stream is not kept")
    assert net.ask("kept/robot/kept/world/state") == {"kept/robot/kept/world/state": b"last"}
    assert net.ask("kept/robot/**") == {
        "kept/robot/kept/world/state": b"last",
        "kept/robot/kept/skill/base/drive/status": b"done",
    }


def test_a_reader_that_missed_a_state_hears_it_again(net: Net) -> None:
    net.bus.publish("world/state", b"missed")
    heard: list[bytes] = []
    with net.session.declare_subscriber(
        "kept/robot/world/state", lambda s: heard.append(s.payload.to_bytes())
    ):
        assert net.until(lambda: bool(heard))
    assert heard == [b"missed"]
