"""What many listen to in a process arrives once, in the thread that receives; of zenoh a few stand-ins."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import pytest
import zenoh

from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.wire.strays import Strays
from tandem.skills.wire.subscriptions import Subscriptions
from tandem.skills.wire.threads import FEW, VARIABLE, few_threads
from tandem.skills.wire.zenoh_ends import Waker


class Session:
    """Notes who subscribes."""

    def __init__(self) -> None:
        self.heard: dict[str, Any] = {}

    def declare_subscriber(self, key: str, take: zenoh.handlers.Callback[Any]) -> SimpleNamespace:
        assert key not in self.heard
        self.heard[key] = take
        return SimpleNamespace(undeclare=lambda: self.heard.pop(key))

    def put(
        self, key: str, heard: str = "lab/tiago/world/*", kind: zenoh.SampleKind = zenoh.SampleKind.PUT
    ) -> None:
        body = SimpleNamespace(to_bytes=lambda: b"{}")
        self.heard[heard](SimpleNamespace(key_expr=key, payload=body, kind=kind))


@pytest.fixture
def session() -> Session:
    return Session()


@pytest.fixture
def strays() -> Strays:
    return Strays()


@pytest.fixture
def add(session: Session, strays: Strays) -> Callable[[], Any]:
    made = Subscriptions(cast("zenoh.Session", session), "lab/tiago", Waker(), strays)
    return lambda: made.add("world/*", 4)


def test_all_who_listen_get_what_comes(session: Session, add: Callable[[], Any]) -> None:
    first, second = add(), add()
    session.put("lab/tiago/world/state")
    assert [[each.key for each in inbox.drain()] for inbox in (first, second)] == [["world/state"]] * 2


@pytest.mark.parametrize("key", ["**", "lab/**", "lab/tiago/**", "lab/tiago/world/*", "lab/*/world/state"])
def test_what_is_put_on_a_wildcard_is_counted_and_nobodys_message(
    session: Session, add: Callable[[], Any], strays: Strays, key: str
) -> None:
    inbox, ear = add(), Ear()
    session.put(key)
    session.put("lab/tiago/world/state", kind=zenoh.SampleKind.DELETE)
    assert inbox.drain() == []
    strays.tell(ear)
    strays.tell(ear)
    assert ear.refused == {("world/*", Reason.STRAY): 2}


def test_no_callback_has_a_thread_of_its_own(session: Session, add: Callable[[], Any]) -> None:
    add()
    assert not session.heard["lab/tiago/world/*"].indirect


def test_the_last_who_closes_ends_it(session: Session, add: Callable[[], Any]) -> None:
    first, second = add(), add()
    first.close()
    session.put("lab/tiago/world/state")
    assert (first.drain(), len(second.drain())) == ([], 1)
    second.close()
    second.close()
    assert not session.heard
    add()
    assert list(session.heard) == ["lab/tiago/world/*"]


@pytest.mark.parametrize(("before", "after"), [({}, FEW), ({VARIABLE: "(rx: ())"}, "(rx: ())")])
def test_who_says_how_many_threads_has_them(before: dict[str, str], after: str) -> None:
    few_threads(before)
    assert before[VARIABLE] == after


def test_of_a_calm_process_some_ticks_of_the_clock_wake_the_loop_and_all_news_does(session: Session) -> None:
    now = 0.0
    waker = Waker(calm=0.045, monotonic=lambda: now)
    heard = Subscriptions(cast("zenoh.Session", session), "lab/tiago", waker, Strays())
    heard.add("hw/clock", 64)
    heard.add("world/state", 4)
    woken = []
    for tick in range(12):
        now = tick * 0.01
        session.put("lab/tiago/hw/clock", "lab/tiago/hw/clock")
        if tick == 7:
            session.put("lab/tiago/world/state", "lab/tiago/world/state")
        if waker.woken:
            woken.append(tick)
            waker.wait(0.0)
    assert woken == [0, 5, 7, 10]
