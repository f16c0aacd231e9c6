"""Whatever is sent, it is either taken or refused with a reason; ``tandem campaign fuzz`` sends 100,000."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from tandem.executive.interface.schemas import separate_schemas
from tandem.executive.trials.campaigns.from_schema import from_schema
from tandem.executive.trials.campaigns.fuzz import Target, fuzz
from tandem.executive.trials.campaigns.fuzz_all import fuzz_all
from tandem.executive.trials.campaigns.fuzz_inputs import TASK_HERE, Input
from tandem.skills.ports.tasks import REQUEST
from tandem.trees.registry import discover

SCHEMAS = separate_schemas(discover())


def test_twelve_thousand_inputs() -> None:
    counts = fuzz(12_000, 1)
    assert counts.broken == ""
    assert counts.inputs == 12_000
    assert min(counts.accepted, counts.answered, counts.questions_refused) > 50
    assert min(counts.refused, counts.verbs_refused) > 100
    assert counts.verbs_taken > 5


def test_the_same_seed_sends_the_same() -> None:
    assert fuzz(100, 7) == fuzz(100, 7)


class Careless(Target):
    """Falls over at the first request."""

    def feed(self, each: Input) -> None:
        if each.key == REQUEST:
            raise KeyError("task")
        super().feed(each)


def test_an_input_that_breaks_something_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tandem.executive.trials.campaigns.fuzz.Target", Careless)
    broken = fuzz(200, 1).broken
    assert broken.startswith("task/request b")
    assert broken.endswith("KeyError: 'task'")


def test_a_task_that_runs_can_be_meant() -> None:
    target = Target()
    target.feed(Input("task/request", b'{"task": "fetch", "item": 29}'))
    target.feed(Input("task/cancel", json.dumps({"task": TASK_HERE}).encode()))
    assert target.counts == {"accepted": 1, "verbs_taken": 1}


@given(st.data())
@settings(max_examples=150, deadline=None)
def test_values_drawn_from_a_schema_fit_it(data: st.DataObject) -> None:
    name = data.draw(st.sampled_from(sorted(SCHEMAS)))
    definitions = SCHEMAS[name]["$defs"]
    assert isinstance(definitions, dict)
    value = data.draw(from_schema({"$ref": SCHEMAS[name]["$ref"]}, definitions))
    Draft202012Validator(SCHEMAS[name]).validate(value)


@pytest.mark.lockstep
def test_every_served_key_of_every_process() -> None:
    """`tandem campaign fuzz` sends 50,000 such inputs."""
    counts = fuzz_all(600, 1)
    assert counts.broken == ""
    assert counts.inputs == 600
    rooms = {key.split("/")[0] for key in counts.keys}
    assert rooms >= {"hw", "sim", "skill", "task", "tree", "(a wildcard)"}
    assert min(counts.answered, counts.refused, counts.silent) > 20
