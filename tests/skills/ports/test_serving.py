"""What the mechanism promises at every endpoint."""

from __future__ import annotations

import json
import logging
from dataclasses import dataclass, field
from typing import Annotated

import pytest
from pydantic import Field

from tandem.skills.ports.endpoint import Call, Refusal, answering, endpoint
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.keys import Nothing, Service
from tandem.skills.ports.limits import Limits, Rates
from tandem.skills.ports.message import Message
from tandem.skills.ports.serving import Endpoints
from tandem.skills.wire.memory import MemoryBus, MemoryHub, MemoryPending


class Push(Message):
    by: str
    force: Annotated[int, Field(ge=0, le=10)] = 1


class Done(Message):
    accepted: bool
    reason: str = ""


class Shown(Message):
    name: str


class FatalError(Exception):
    pass


LIMITS = Limits(bytes=200, depth=4, per_step=3, rate=10.0, burst=6.0)
PUSH = Service("a/push", Push, Done, limits=LIMITS)
SHOW = Service("a/show", Nothing, Shown, reads=True, limits=LIMITS)
DRAW = Service("a/draw", Nothing, Shown, reads=True, exact=True, limits=LIMITS)
EACH = Service("a/*/shown", Nothing, Shown, reads=True, limits=LIMITS)
BREAK = Service("a/break", Push, Done, limits=LIMITS)
HALT = Service("a/halt", Push, Done, limits=Limits(rate=float("inf")))


@dataclass
class Room:
    """A served room and whoever asks."""

    bus: MemoryBus = field(default_factory=lambda: MemoryBus(MemoryHub()))
    pushed: list[Push] = field(default_factory=list)
    drawn: int = 0
    now: float = 0.0
    later: list[Call[Nothing]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.endpoints = Endpoints(
            self.bus,
            lambda: self.now,
            (
                endpoint(PUSH, self._push, puts=True),
                answering(SHOW, lambda _: Shown(name="show")),
                answering(DRAW, self._draw),
                endpoint(
                    EACH,
                    lambda call: Shown(name=call.name) if call.name in "xy" else None,
                    keys=lambda: ["a/x/shown", "a/y/shown"],
                ),
                answering(BREAK, self._break),
                endpoint(HALT, self._push, unread=lambda: Push(by="nobody")),
            ),
            fatal=(FatalError,),
        )

    def query(self, key: str, payload: bytes | dict[str, object] = b"") -> MemoryPending:
        body = payload if isinstance(payload, bytes) else json.dumps(payload).encode()
        pending = self.bus.query(key, body)
        assert isinstance(pending, MemoryPending)
        return pending

    def ask(self, key: str, payload: bytes | dict[str, object] = b"") -> MemoryPending:
        pending = self.query(key, payload)
        self.endpoints.step()
        return pending

    def refused(self, key: str, payload: bytes | dict[str, object]) -> str:
        answer = self.ask(key, payload).poll()
        assert answer is not None
        done = Done.model_validate_json(answer)
        assert not done.accepted
        return done.reason

    def _push(self, call: Call[Push]) -> Done:
        self.pushed.append(call.document)
        return Done(accepted=True)

    def _draw(self, _: Nothing) -> Shown:
        self.drawn += 1
        return Shown(name="drawn")

    def _break(self, asked: Push) -> Done:
        if asked.force > 5:
            raise FatalError
        raise KeyError(asked.by)


@pytest.fixture
def room() -> Room:
    return Room()


SELECTORS = ["**", "a/**", "a/*", "*/push", "a/**/push", "a/push/**", "*/*"]


@pytest.mark.parametrize("selector", SELECTORS)
@pytest.mark.parametrize("document", [b"", b'{"by": "me"}', b"{}", b"x" * 1000])
def test_no_wildcard_commands(room: Room, selector: str, document: bytes) -> None:
    found = room.ask(selector, document)
    assert room.pushed == []
    assert room.drawn == 0
    assert not {"a/push", "a/break", "a/draw", "a/halt"} & found.replies.keys()
    assert found.done()


def test_a_wildcard_is_answered_under_each_key_that_is_read_only(room: Room) -> None:
    found = room.ask("**").replies
    assert {key: Shown.model_validate_json(told).name for key, told in found.items()} == {
        "a/show": "show",
        "a/x/shown": "x",
        "a/y/shown": "y",
    }
    assert list(room.ask("a/x/*").replies) == ["a/x/shown"]


def test_a_question_needs_no_document_and_a_command_one_with_a_field(room: Room) -> None:
    assert room.ask("a/show").poll() is not None
    assert room.ask("a/draw").poll() is not None
    assert 'a JSON object with "by", "force"' in room.refused("a/push", b"")
    assert "at least one field" in room.refused("a/push", b"{}")
    assert room.pushed == []
    room.ask("a/push", {"by": "me"})
    assert room.pushed == [Push(by="me")]


@pytest.mark.parametrize(
    ("document", "said"),
    [
        (b'{"by": "me", "force": 99999999999999999999}', "force"),
        (b'{"by": "me", "by": "you"}', "the name twice"),
        (b'{"by": "me", "x": 1}', "x: expected no such field"),
        (b'{"by": "' + b"x" * 300 + b'"}', "at most 200 bytes, found 310 bytes"),
        (b'{"by": ' + b"[" * 50 + b"]" * 50 + b"}", "at most 4 nested objects and arrays"),
        (b'{"by": NaN}', "a finite number"),
        (b'{"by": "\\ud800"}', "surrogate"),
        (b'["by"]', "a JSON object"),
        (b"\xff\xfe", "UTF-8"),
    ],
)
def test_a_bad_document_is_told_what_is_wrong(room: Room, document: bytes, said: str) -> None:
    assert said in room.refused("a/push", document)
    assert room.pushed == []


@pytest.mark.parametrize("force", [True, "3", 2.0, None])
def test_nothing_is_taken_for_a_number_that_is_none(room: Room, force: object) -> None:
    """A client's mistake must not move a gripper to a width of ``true`` metres."""
    assert room.refused("a/push", {"by": "me", "force": force}).startswith("force: expected a ")
    assert room.pushed == []


def test_a_question_is_refused_with_an_error(room: Room) -> None:
    found = room.ask("a/show", {"x": 1})
    assert found.poll() is None
    error = found.refusal()
    assert error is not None
    assert Refusal.model_validate_json(error).problems[0].path == "x"


def test_a_handler_that_raises_costs_one_answer(room: Room, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.ERROR):
        assert "it raised KeyError" in room.refused("a/break", {"by": "me"})
    assert "Traceback" in caplog.text
    assert room.ask("a/show").poll() is not None


def test_what_is_fatal_is_answered_and_goes_on_up(room: Room) -> None:
    pending = room.query("a/break", {"by": "me", "force": 9})
    with pytest.raises(FatalError):
        room.endpoints.step()
    assert pending.poll() is not None


def test_a_step_handles_a_bounded_number(room: Room) -> None:
    pending = [room.query("a/show") for _ in range(5)]
    assert room.endpoints.step()
    assert sum(each.poll() is not None for each in pending) == 3
    assert not room.endpoints.step()
    assert all(each.poll() is not None for each in pending)


def test_a_sender_that_asks_too_often_is_told_for_a_while_and_then_ignored(room: Room) -> None:
    found = [room.ask("a/push", {"by": "me"}) for _ in range(60)]
    assert len(room.pushed) == 6
    told = [each.poll() for each in found if each.poll() is not None]
    assert len(told) == 6 + 20
    assert b"ask again in 0.100 s" in (told[6] or b"")
    assert all(each.done() for each in found)
    room.now += 0.1
    room.ask("a/push", {"by": "me"})
    assert len(room.pushed) == 7


def test_each_name_in_a_key_has_a_rate_of_its_own(room: Room) -> None:
    assert sum(room.ask("a/x/shown").poll() is not None for _ in range(10)) == 6
    assert room.ask("a/y/shown").poll() is not None


@pytest.mark.parametrize("name", ['x"y', "x y", "ü", "x\ny", "." * 3, "x" * 81])
def test_a_name_that_would_need_an_escape_is_refused(room: Room, name: str) -> None:
    found = room.ask(f"a/{name}/shown")
    assert found.poll() is None
    assert b"a name of letters" in (found.refusal() or b"")


@pytest.mark.parametrize("document", [b"", b"{}", b"no json", b"x" * 100_000, b"[" * 60_000])
def test_one_command_is_carried_out_unread_but_not_for_a_wildcard(room: Room, document: bytes) -> None:
    room.ask("a/halt", document)
    assert room.pushed == [Push(by="nobody")]
    room.ask("a/ha*", document)
    room.ask("**", document)
    assert len(room.pushed) == 1


def test_what_is_put_is_checked_as_what_is_asked(room: Room) -> None:
    for document in (b'{"by": "me"}', b"no json", b"x" * 1000):
        room.bus.publish("a/push", document)
    room.endpoints.step()
    assert room.pushed == [Push(by="me")]
    assert room.bus.ear.refused == {("a/push", Reason.MALFORMED): 2}, (
        "nobody waits for an answer that says so"
    )


def test_closed_it_answers_nobody(room: Room) -> None:
    pending = [room.query("a/show") for _ in range(5)]
    room.endpoints.step()
    room.endpoints.close()
    room.endpoints.close()
    assert all(each.done() for each in pending)
    assert room.query("a/show").done()


def test_a_bucket_fills_up_to_its_burst() -> None:
    now = [0.0]
    rates = Rates(10.0, 2.0, lambda: now[0])
    assert [rates.take("a") for _ in range(3)] == [0.0, 0.0, pytest.approx(0.1)]
    now[0] = 100.0
    assert [rates.take("a") for _ in range(3)] == [0.0, 0.0, pytest.approx(0.1)]
