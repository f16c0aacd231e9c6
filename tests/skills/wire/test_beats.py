"""Whose beats a process hears; of zenoh a few stand-ins."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest
import zenoh

from tandem.skills.wire.beats import UNASKED, Beats
from tandem.skills.wire.pulse import SILENT_AFTER, Pulse
from tandem.skills.wire.strays import Strays


class Session:
    """Hands beats on to who subscribes to them."""

    def __init__(self) -> None:
        self.heard: dict[str, Any] = {}

    def declare_subscriber(self, key: str, take: Any) -> SimpleNamespace:
        assert key not in self.heard
        self.heard[key] = take
        return SimpleNamespace(undeclare=lambda: self.heard.pop(key))

    def beat(self, process: str, *names: str) -> None:
        key = f"lab/tiago/beat/{process}"
        body = SimpleNamespace(to_bytes=lambda: "\n".join(names).encode())
        for expression in {key, "lab/tiago/beat/*"} & self.heard.keys():
            self.heard[expression](SimpleNamespace(key_expr=key, payload=body, kind=zenoh.SampleKind.PUT))


@pytest.fixture
def session() -> Session:
    return Session()


@pytest.fixture
def pulse() -> Pulse:
    return Pulse(lambda: 0.0)


@pytest.fixture
def beats(session: Session, pulse: Pulse) -> Beats:
    return Beats(cast("zenoh.Session", session), "lab/tiago", pulse, Strays())


def test_who_asks_after_one_name_hears_its_process_alone(session: Session, beats: Beats) -> None:
    beats.hear("client")
    session.beat("base", "process/base")
    beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/*"}  # it may be any of them
    session.beat("executive", "client", "process/executive")
    beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/executive"}


def test_a_second_name_is_sought_among_all(session: Session, beats: Beats) -> None:
    for name in ("client", "other"):
        beats.hear(name)
        session.beat("executive", "client")
        beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/*", "lab/tiago/beat/executive"}
    session.beat("bench", "other")
    beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/executive", "lab/tiago/beat/bench"}


def test_a_name_that_has_gone_is_sought_anew(session: Session, beats: Beats) -> None:
    beats.hear("client")
    session.beat("executive", "client")
    beats.hear("client")
    beats.forget("client")
    beats.hear("client")
    session.beat("spare", "client")
    beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/executive", "lab/tiago/beat/spare"}


def test_one_who_asked_after_all_hears_all(session: Session, beats: Beats) -> None:
    beats.hear_all()
    session.beat("executive", "client")
    beats.hear("client")
    assert session.heard.keys() == {"lab/tiago/beat/*"}


def test_a_supervisor_hears_all_seldom(session: Session, pulse: Pulse) -> None:
    supervisor = Beats(cast("zenoh.Session", session), "lab/tiago", pulse, Strays(), seldom=True)
    supervisor.hear_all()
    assert session.heard.keys() == {"lab/tiago/beat/*/seldom"}


def test_who_asks_no_more_hears_no_more(session: Session, beats: Beats) -> None:
    beats.hear("client")
    session.beat("executive", "client")
    beats.hear("client")
    for _ in range(UNASKED - 1):
        beats.rest()
    assert session.heard.keys() == {"lab/tiago/beat/executive"}
    beats.rest()
    assert not session.heard


def test_a_name_that_never_beats_is_not_sought_for_ever(session: Session, beats: Beats) -> None:
    beats.hear("a driver of its own")
    for _ in range(UNASKED):
        beats.rest()
    assert not session.heard


def test_one_that_was_not_heard_meanwhile_is_not_silent_for_that(session: Session) -> None:
    now = [0.0]
    pulse = Pulse(lambda: now[0])
    beats = Beats(cast("zenoh.Session", session), "lab/tiago", pulse, Strays())
    beats.hear("client")
    session.beat("executive", "client", "process/executive")
    for _ in range(UNASKED):
        beats.rest()
    now[0] = 10.0
    beats.hear("client")
    assert pulse.awake(("client", "process/executive")) == {"client", "process/executive"}
    now[0] += 2.0 * SILENT_AFTER
    beats.hear("client")
    assert not pulse.awake(("client",))
