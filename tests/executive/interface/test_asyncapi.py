"""docs/asyncapi.json says what the code says, and is an AsyncAPI 3.0 document."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest
from jsonschema import Draft7Validator
from pydantic import JsonValue
from surroundings import Surroundings

from tandem.executive.interface.asyncapi import asyncapi
from tandem.skills.ports import keys, tasks, world
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import Message
from tandem.trees.registry import discover

PAGE = Path(__file__).parents[3] / "docs" / "asyncapi.json"
DOCUMENT = json.loads(PAGE.read_text(encoding="utf-8"))


def test_the_document_is_up_to_date() -> None:
    assert asyncapi(discover()) == DOCUMENT, (
        "run: tandem schema --format asyncapi --output docs/asyncapi.json"
    )


def test_an_independent_model_of_asyncapi_takes_it() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the model's own, about its field names
        from asyncapi3.models import AsyncAPI3  # noqa: PLC0415 - its import warns
    AsyncAPI3.model_validate(DOCUMENT)


def references(value: JsonValue) -> Iterator[str]:
    if isinstance(value, dict):
        if isinstance(value.get("$ref"), str):
            yield str(value["$ref"])
        value = list(value.values())
    if isinstance(value, list):
        for each in value:
            yield from references(each)


def test_every_reference_leads_somewhere() -> None:
    for reference in references(DOCUMENT):
        at: JsonValue = DOCUMENT
        for part in reference.removeprefix("#/").split("/"):
            assert isinstance(at, dict)
            assert part in at, reference
            at = at[part]


@pytest.mark.parametrize("module", [tasks, world, keys], ids=lambda module: module.__name__)
def test_every_key_is_a_channel(module: object) -> None:
    addresses = {channel["address"] for channel in DOCUMENT["channels"].values()}
    entries = [each for each in vars(module).values() if isinstance(each, Topic | Service)]
    wanted = [each.key for each in entries] + [tasks.REQUEST, tasks.TASK_PICTURE, keys.rgbd("{camera}")]
    assert [key for key in wanted if f"{{site}}/{{robot}}/{key}" not in addresses] == []


def test_schemas_are_such() -> None:
    for schema in DOCUMENT["components"]["schemas"].values():
        Draft7Validator.check_schema(schema)


def fits(message: Message) -> bool:
    schema = {"$ref": f"#/components/schemas/{type(message).__name__}", "components": DOCUMENT["components"]}
    return Draft7Validator(schema).is_valid(json.loads(message.model_dump_json()))


def test_what_the_executive_says_is_what_the_document_says() -> None:
    here = Surroundings()
    answers = [here.ask({"task": "wait", "item": 3}), here.ask({"task": "wait"})]
    here.world(2)
    here.step(5)
    said = [*answers, *here.told(), *here.shown()]
    assert len(said) > 6
    assert [message for message in said if not fits(message)] == []
    assert not Draft7Validator(
        {"$ref": "#/components/schemas/TaskStatus", "components": DOCUMENT["components"]}
    ).is_valid({"task": 1})
