"""Bad documents: each is rejected with the path in it and what was expected."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest
from surroundings import WAIT, Surroundings, WaitRequest

from tandem.executive.service.intake.request_parser import Asked, Refused, read_request
from tandem.skills.ports.documents import parse
from tandem.skills.ports.keys import Nothing
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import REQUEST, TASK_ANSWERS, TASK_KINDS, TaskState
from tandem.skills.site import load

GOOD = b'{"task": "wait", "item": 29}'
DEEP = b'{"task": "wait", "item": ' + b"[" * 50_000 + b"]" * 50_000 + b"}"

BAD = [
    (b"", "(the document)", "JSON"),
    (b"bring me item 29", "(the document)", "JSON"),
    (b'{"task": "wait", "item": 29', "(the document)", "JSON"),
    (b"\xff\xfe{}", "(the document)", "UTF-8"),
    (b"[]", "(the document)", "a JSON object"),
    (b"29", "(the document)", "a JSON object"),
    (b"null", "(the document)", "a JSON object"),
    (b'{"task": "wait", "item": 29, "to": "' + b"x" * 70_000 + b'"}', "(the document)", "65536 bytes"),
    (DEEP[:60_000], "(the document)", "nested objects"),
    (b'{"task": "wait", "item": 29, "item": 42}', "item", "each name once"),
    (b'{"task": "wait", "item": NaN}', "item", "a finite number"),
    (b'{"task": "wait", "item": 29, "weight": Infinity}', "weight", "a finite number"),
    (b'{"task": "wait", "item": 29, "weight": -1e999}', "weight", "a finite number"),
    (b'{"task": "wait", "item": 29, "weight": -1e300}', "weight", "a number below 1e+30"),
    (b'{"task": "wait", "item": 29, "weight": 1' + b"0" * 30 + b"}", "weight", "a number below 1e+30"),
    (b'{"task": "wait", "item": ' + b"9" * 5000 + b"}", "item", "a number below 1e+30"),
    (b'{"task": "wait", "item": 99999999999999999999999}', "item", ""),
    (b'{"task": "wait", "item": 29, "to": "\\ud800"}', "to", "Unicode text"),
    (b'{"task": "wait", "item": 29, "\\udfff": 1}', "\\udfff", "Unicode text"),
    (b"{}", "task", '"wait"'),
    (b'{"task": "dance"}', "task", '"wait"'),
    (b'{"task": 3, "item": 29}', "task", '"wait"'),
    (b'{"task": ["wait"], "item": 29}', "task", '"wait"'),
    (b'{"task": "wait"}', "item", "a value"),
    (b'{"task": "wait", "item": 29, "colour": "red"}', "colour", "no such field"),
    (b'{"task": "wait", "item": "29"}', "item", "a whole number"),
    (b'{"task": "wait", "item": 29.5}', "item", ""),
    (b'{"task": "wait", "item": true}', "item", "a whole number"),
    (b'{"task": "wait", "item": null}', "item", "a whole number"),
    (b'{"task": "wait", "item": -1}', "item", "greater than or equal to 0"),
    (b'{"task": "wait", "item": 587}', "item", "less than or equal to 586"),
    (b'{"task": "wait", "item": 29, "weight": 0}', "weight", "greater than 0"),
    (b'{"task": "wait", "item": 29, "expires": "2026-11-24T08:30"}', "expires", "ISO 8601 with a zone"),
    (b'{"task": "wait", "item": 29, "labels": {"order": 7}}', "labels.order", "text"),
    (b'{"task": "wait", "item": 29, "labels": ["order"]}', "labels", "an object"),
    (b'{"task": "wait", "item": 29, "arm": "middle"}', "arm", "'left' or 'right'"),
    (b'{"task": "wait", "item": 29, "spots": ["a", 2]}', "spots.1", "text"),
    (b'{"task": "wait", "item": 29, "to": "moon"}', "to", "depot"),
    (b'{"task": "wait", "item": 29, "id": 5}', "id", "text"),
    (b'{"task": "wait", "item": 29, "id": "' + b"x" * 65 + b'"}', "id", "text"),
]


@pytest.mark.parametrize(("payload", "path", "expected"), BAD, ids=lambda value: repr(value)[:50])
def test_a_bad_document_is_refused_with_path_and_expectation(
    payload: bytes, path: str, expected: str
) -> None:
    refused = read_request(payload, {"wait": WAIT}, load("lab"))
    assert isinstance(refused, Refused)
    assert [problem.path for problem in refused.problems] == [path]
    assert expected in refused.problems[0].expected
    refused.problems[0].model_dump_json()


def test_all_problems_are_told_at_once() -> None:
    refused = read_request(b'{"task": "wait", "arm": 1, "x": 2}', {"wait": WAIT}, load("lab"))
    assert isinstance(refused, Refused)
    assert sorted(problem.path for problem in refused.problems) == ["arm", "item", "x"]


def test_a_good_document_is_kept_as_it_was_sent() -> None:
    asked = read_request(b'{"task": "wait", "item": 29, "id": "mine"}', {"wait": WAIT}, load("lab"))
    assert isinstance(asked, Asked)
    assert asked.document == {"task": "wait", "item": 29, "id": "mine"}
    assert asked.client_id == "mine"


def test_brackets_within_text_are_no_nesting() -> None:
    assert parse(b'{"a": "[[[[[[[[[[[[[[[[[[[[[[[[\\"[[[["}') == {"a": '[[[[[[[[[[[[[[[[[[[[[[[["[[[['}


@pytest.mark.parametrize(("payload", "path", "expected"), BAD[:12], ids=lambda value: repr(value)[:50])
def test_the_running_task_goes_on(payload: bytes, path: str, expected: str) -> None:
    here = Surroundings()
    task = here.ask(json.loads(GOOD)).task
    answer = here.ask(payload)
    assert not answer.accepted
    assert answer.problems[0].path == path
    assert expected in answer.problems[0].expected
    here.world(1)
    here.step()
    assert [(each.task, each.state) for each in here.told()][-1] == (task, TaskState.SUCCEEDED)


def test_a_put_is_a_request_and_its_answer_is_published() -> None:
    here = Surroundings()
    answers = here.bus.subscribe(TASK_ANSWERS.key)
    here.bus.publish(REQUEST, b'{"task": "wait", "item": 29, "id": "mine"}')
    here.bus.publish(REQUEST, b'{"task": "wait"}')
    here.step()
    good, bad = (TASK_ANSWERS.decode(sample.payload) for sample in answers.drain())
    assert (good.accepted, good.task, good.client_id) == (True, "wait-0001", "mine")
    assert (bad.accepted, bad.problems[0].path) == (False, "item")


def test_the_same_request_under_the_same_id_starts_once() -> None:
    here = Surroundings()
    asked = {"task": "wait", "item": 29, "id": "mine"}
    assert here.ask(asked).task == here.ask(asked).task == "wait-0001"
    other = here.ask({**asked, "item": 30})
    assert (other.accepted, other.problems[0].path) == (False, "id")


def raises(_request: WaitRequest, _site: Site) -> tuple[Problem, ...]:
    raise RuntimeError("a mistake")


def tells_text(_request: WaitRequest, _site: Site) -> tuple[Problem, ...]:
    return ("no",)  # type: ignore[return-value] - as a stranger writes it


@pytest.mark.parametrize(
    ("check", "words"),
    [
        (raises, "RuntimeError: a mistake"),
        (tells_text, "expected a tuple of Problem from `problems` of wait"),
    ],
)
def test_a_check_that_is_wrong_costs_its_request_only(
    check: Callable[[WaitRequest, Site], tuple[Problem, ...]], words: str
) -> None:
    here = Surroundings()
    broken = WAIT.__class__(WAIT.name, WAIT.summary, WAIT.request, check, WAIT.build)
    here.executive._kinds["wait"] = broken
    refused = here.ask(json.loads(GOOD))
    assert not refused.accepted
    assert words in refused.problems[0].expected
    here.executive._kinds["wait"] = WAIT
    assert here.ask(json.loads(GOOD)).accepted


def test_times_of_day_are_seconds_or_iso_8601_and_told_as_iso() -> None:
    document = b'{"task": "wait", "item": 29, "not_before": 120.0, "expires": "1970-01-01T01:01:00+01:00"}'
    refused = read_request(document, {"wait": WAIT}, load("lab"))
    assert isinstance(refused, Refused)
    assert refused.problems == (
        Problem(
            path="expires",
            expected="a time after not_before (1970-01-01T00:02:00Z)",
            found="1970-01-01T00:01:00Z",
        ),
    )


def test_the_kinds_are_served_with_schemas_that_are_whole() -> None:
    here = Surroundings()
    pending = TASK_KINDS.query(here.bus, Nothing())
    here.step()
    answer = pending.poll()
    assert answer is not None
    (kind,) = [each for each in TASK_KINDS.decode_answer(answer).kinds if each.name == "wait"]
    properties = kind.request["properties"]
    assert isinstance(properties, dict)
    assert {"task", "id", "item", "priority", "not_before", "expires", "labels"} <= properties.keys()
