"""Requests name items as the site does; trees have numbers."""

from __future__ import annotations

import json

import pytest
from pydantic import ValidationError

from tandem.executive.service.intake.request_parser import Asked, Refused, read_request
from tandem.skills.ports.site import SiteItem
from tandem.skills.site import load
from tandem.trees.registry import discover
from tandem.trees.tasks.fetch import FetchRequest

SITE = load("lab")


def read(**document: object) -> Asked | Refused:
    return read_request(json.dumps({"task": "fetch", **document}).encode(), discover(), SITE)


@pytest.mark.parametrize("said", ["tea", 29])
def test_an_item_is_meant_by_its_name_or_by_its_number(said: object) -> None:
    asked = read(item=said)
    assert isinstance(asked, Asked)
    assert isinstance(asked.request, FetchRequest)
    assert asked.request.item == 29
    assert asked.document["item"] == said  # as the client said it


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("coffee", "one of the site's items: 3 (salt)"),
        ("Tea", "29 (tea)"),
        ("29", "29 (tea)"),
        ("", "29 (tea)"),
        (30, "29 (tea)"),
        (10_000, "less than or equal to 9999"),
        (True, "a whole number"),
        (None, "a whole number"),
    ],
)
def test_another_one_is_refused_with_those_that_there_are(said: object, expected: str) -> None:
    refused = read(item=said)
    assert isinstance(refused, Refused)
    (problem,) = refused.problems
    assert problem.path == "item"
    assert expected in problem.expected
    assert not problem.expected.startswith("expected")


def test_who_does_not_know_the_site_needs_the_number() -> None:
    with pytest.raises(ValidationError, match="expected a number: only who knows the site can read a name"):
        FetchRequest.model_validate({"item": "tea"})


@pytest.mark.parametrize("name", ["29", " tea", "tea\n", "x" * 65])
def test_a_name_that_can_be_misread_is_none(name: str) -> None:
    with pytest.raises(ValidationError, match="name"):
        SiteItem(item=29, name=name, size=(0.06, 0.06, 0.06), tag_size=0.048)


def test_two_items_of_one_name_are_refused() -> None:
    document = SITE.model_dump(mode="json")
    document["items"][1]["name"] = "tea"
    with pytest.raises(ValidationError, match="names of items: expected unique names, twice there: tea"):
        type(SITE).model_validate(document)
