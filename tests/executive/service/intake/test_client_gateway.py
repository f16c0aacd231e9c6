"""The executive's doors over the bus in memory: who asks, how often, and for how much."""

from __future__ import annotations

import json

import pytest

from tandem.executive.service.executive import Executive
from tandem.executive.service.intake.client_limits import Bounds
from tandem.executive.service.policy import Policy
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, CancelTask, ControlAnswer, TaskAnswer, by_client
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tests.executive.waiting import WAIT, WAITING

BOUNDS = Bounds(rate=10.0, burst=3.0, open=2)


class Here:
    """An executive behind its doors, and a client's end of the bus."""

    def __init__(self, bounds: Bounds = BOUNDS) -> None:
        hub, self.clocks = MemoryHub(), SteppedClocks()
        self.bus = MemoryBus(hub)
        self.executive = Executive(
            MemoryBus(hub), self.clocks, load("lab"), {"wait": WAITING}, policy=Policy(bounds=bounds)
        )

    def ask(self, client: str, document: object = WAIT) -> TaskAnswer | None:
        key = by_client(client, REQUEST) if client else REQUEST
        body = document if isinstance(document, bytes) else json.dumps(document).encode()
        pending = self.bus.query(key, body)
        self.executive.step()
        answer = pending.poll()
        return None if answer is None else TaskAnswer.model_validate_json(answer)

    def cancel(self, client: str, task: str) -> ControlAnswer:
        key = by_client(client, TASK_CANCEL.key) if client else TASK_CANCEL.key
        pending = self.bus.query(key, CancelTask(task=task).model_dump_json().encode())
        self.executive.step()
        answer = pending.poll()
        assert answer is not None
        return ControlAnswer.model_validate_json(answer)

    def by(self, task: str) -> object:
        (status,) = (each for each in self.executive.book.all() if each.task == task)
        return status.request.get("by")


def accepted(answer: TaskAnswer | None) -> str:
    assert answer is not None
    assert answer.accepted, answer.problems
    return answer.task


def refused(answer: TaskAnswer | None) -> tuple[str, str]:
    assert answer is not None
    assert not answer.accepted
    (problem,) = answer.problems
    return problem.path, problem.expected


def test_the_key_tells_who_asks_and_the_document_keeps_it() -> None:
    here = Here()
    assert here.by(accepted(here.ask("ann"))) == "ann"
    assert here.by(accepted(here.ask(""))) is None


@pytest.mark.parametrize("client", ["", "ann"])
def test_nobody_says_himself_who_he_is(client: str) -> None:
    path, expected = refused(Here().ask(client, {**WAIT, "by": "bob"}))
    assert path == "by"
    assert "the topic already names the client" in expected


def test_a_name_in_an_escape_is_a_name() -> None:
    assert refused(Here().ask("ann", rb'{"task": "wait", "item": 29, "b\u0079": "bob"}'))[0] == "by"


def test_a_client_cancels_its_own_tasks_only() -> None:
    here = Here()
    hers, his = accepted(here.ask("ann")), accepted(here.ask("bob"))
    answer = here.cancel("bob", hers)
    assert not answer.accepted
    assert "another client than bob" in answer.reason
    assert here.cancel("bob", his).accepted
    assert here.cancel("", hers).accepted  # an operator's key: the access rules let nobody else there


def test_a_client_that_asks_too_often_is_told_when_to_ask_again() -> None:
    here = Here(Bounds(rate=10.0, burst=3.0))
    for _ in range(3):
        accepted(here.ask("ann"))
    assert "ask again in 0.100 s" in refused(here.ask("ann"))[1]
    accepted(here.ask("bob"))
    here.clocks.advance(0.1)
    accepted(here.ask("ann"))


def test_a_client_that_has_too_much_open_waits_for_an_end() -> None:
    here = Here()
    first, _ = accepted(here.ask("ann", {**WAIT, "id": "1"})), accepted(here.ask("ann"))
    here.clocks.advance(1.0)
    assert "at most 2 open requests" in refused(here.ask("ann"))[1]
    assert accepted(here.ask("ann", {**WAIT, "id": "1"})) == first  # asked again, it is no new one
    accepted(here.ask("bob"))
    here.cancel("ann", first)
    here.executive.step()
    here.clocks.advance(1.0)
    accepted(here.ask("ann"))


def test_what_is_put_is_bounded_too() -> None:
    here = Here(Bounds(rate=10.0, burst=3.0))
    for _ in range(50):
        here.bus.publish(by_client("ann", REQUEST), json.dumps(WAIT).encode())
    here.executive.step()
    assert len(here.executive.book.all()) == 3


def test_of_a_flood_a_few_are_told() -> None:
    here = Here(Bounds(rate=1.0, burst=1.0))
    answers = [here.ask("ann") for _ in range(60)]
    assert 15 <= sum(answer is not None for answer in answers) <= 25


def test_a_wrong_document_is_answered_as_ever() -> None:
    assert refused(Here().ask("ann", b"no json"))[0] == "(the document)"


def test_two_clients_may_call_their_requests_the_same() -> None:
    here = Here()
    hers = accepted(here.ask("ann", {**WAIT, "id": "1"}))
    his = accepted(here.ask("bob", {**WAIT, "item": 3, "id": "1"}))
    assert hers != his
    assert accepted(here.ask("ann", {**WAIT, "id": "1"})) == hers
    path, _ = refused(here.ask("ann", {**WAIT, "item": 3, "id": "1"}))
    assert path == "id"


def test_requests_that_are_still_unread_count_as_open() -> None:
    here = Here(Bounds(rate=1000.0, burst=1000.0, open=5))
    body = json.dumps(WAIT).encode()
    for _ in range(20):
        here.bus.publish(by_client("ann", REQUEST), body)
    asked = [here.bus.query(by_client("ann", REQUEST), body) for _ in range(20)]
    for _ in range(5):
        here.executive.step()
    assert len(here.executive.book.all()) == 5
    assert all(each.done() for each in asked)


@pytest.mark.parametrize("name", ['a"b', "a b", "a\\", "\n", "é"])
def test_a_name_that_is_none_gets_nowhere(name: str) -> None:
    here = Here()
    pending = here.bus.query(f"task/by/{name}/request", json.dumps(WAIT).encode())
    here.executive.step()
    answer = pending.poll()
    assert answer is not None
    assert "a name of letters" in TaskAnswer.model_validate_json(answer).problems[0].expected
    assert here.executive.book.all() == ()


@pytest.mark.parametrize(
    "text", ["a\nb", "\x00", "\x7f", "\u2028", "a\n", "\u202e92", "29\u200b", "\ufeff29"]
)
def test_an_id_has_no_characters_that_control_or_are_not_seen(text: str) -> None:
    assert refused(Here().ask("", {**WAIT, "id": text}))[0] == "id"


def test_a_clients_own_id_is_its_own_alone() -> None:
    here = Here()
    hers, his = (accepted(here.ask(each, {**WAIT, "id": "1"})) for each in ("ann", "bob"))
    both = here.cancel("", "1")
    assert f"2 requests have the id '1'; name one: {hers}, {his}" == both.reason
    assert here.cancel("bob", "1").accepted
    assert "another client than bob" in here.cancel("bob", hers).reason
    assert here.cancel("", "1").accepted  # the one that has not ended
