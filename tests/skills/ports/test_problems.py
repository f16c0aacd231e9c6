"""What is wrong with a document is told in words, whatever pydantic calls it."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Literal, get_args

import pytest
from pydantic import Field, ValidationError, field_validator
from pydantic_core.core_schema import ErrorType

from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import SAID, problems_of


class _Shape(StrEnum):
    BOX = "box"
    TIN = "tin"


class _Left(Message):
    side: Literal["left"]


class _Right(Message):
    side: Literal["right"]


class _Asked(Message):
    whole: Annotated[int, Field(gt=0, le=9)] = 1
    number: Annotated[float, Field(ge=0.0, lt=9.0)] = 1.0
    text: Annotated[str, Field(min_length=1, max_length=3)] = "a"
    name: Annotated[str, Field(pattern="^a+$")] = "a"
    yes: bool = False
    word: Literal["up", "down"] = "up"
    shape: _Shape = _Shape.BOX
    ways: Annotated[tuple[int, ...], Field(min_length=1, max_length=2)] = (1,)
    list_: list[int] = Field(default_factory=list)
    labels: Annotated[dict[str, int], Field(max_length=1)] = Field(default_factory=dict)
    one: _Left = _Left(side="left")
    hand: Annotated[_Left | _Right, Field(discriminator="side")] = _Left(side="left")
    nothing: None = None
    checked: int = 0

    @field_validator("checked")
    @classmethod
    def _small(cls, value: int) -> int:
        if value > 1:
            raise ValueError("expected 1 for yes")
        return value


HUGE = "1" + "0" * 5000
DOCUMENTS = {
    '{"whole": null}': ("int_type", "a whole number"),
    '{"whole": "x"}': ("int_parsing", "a whole number"),
    f'{{"whole": "{HUGE}"}}': ("int_parsing_size", "a whole number with fewer digits"),
    '{"whole": 1.5}': ("int_from_float", "a whole number"),
    '{"whole": 0}': ("greater_than", "greater than 0"),
    '{"whole": 10}': ("less_than_equal", "less than or equal to 9"),
    '{"number": null}': ("float_type", "a number"),
    '{"number": "x"}': ("float_parsing", "a number"),
    '{"number": NaN}': ("finite_number", "a finite number"),
    '{"number": -1}': ("greater_than_equal", "greater than or equal to 0"),
    '{"number": 9}': ("less_than", "less than 9"),
    '{"text": 1}': ("string_type", "text"),
    '{"text": ""}': ("string_too_short", "text of at least 1 character"),
    '{"text": "abcd"}': ("string_too_long", "text of at most 3 characters"),
    '{"name": "b"}': ("string_pattern_mismatch", "text that matches ^a+$"),
    '{"yes": null}': ("bool_type", "true or false"),
    '{"yes": "perhaps"}': ("bool_parsing", "true or false"),
    '{"word": "on"}': ("literal_error", "'up' or 'down'"),
    '{"shape": "ball"}': ("enum", "'box' or 'tin'"),
    '{"ways": []}': ("too_short", "at least 1 item"),
    '{"ways": [1, 2, 3]}': ("too_long", "at most 2 items"),
    '{"labels": {"a": 1, "b": 2}}': ("too_long", "at most 1 item"),
    '{"ways": {}}': ("tuple_type", "an array"),
    '{"list_": {}}': ("list_type", "an array"),
    '{"labels": []}': ("dict_type", "an object"),
    '{"one": 1}': ("model_type", "an object"),
    '{"one": {}}': ("missing", "a value"),
    '{"hand": {}}': ("union_tag_not_found", "an object with 'side'"),
    '{"hand": {"side": "up"}}': ("union_tag_invalid", "'side' as one of 'left', 'right'"),
    '{"nothing": 1}': ("none_required", "null"),
    '{"other": 1}': ("extra_forbidden", "no such field"),
    '{"checked": 2}': ("value_error", "1 for yes"),
    "{": ("json_invalid", "JSON: EOF while parsing an object at line 1 column 1"),
}
PLAIN = {
    "invalid_key": ({1: 2}, "a name in text"),
    "string_unicode": ({"text": "\ud800"}, "text in UTF-8"),
}
"""What no JSON has, and a YAML file may."""
NEVER = (
    "no_such_attribute", "json_type", "assertion_error", "needs_python_object", "recursion_", "frozen_",
    "get_attribute", "model_attributes", "dataclass", "named_tuple", "default_factory_not_called", "ellipsis",
    "multiple_of", "iter", "string_not_ascii", "ordered_dict", "counter", "mapping", "deque", "set_",
    "bytes_", "missing_",
    "date_", "time_", "datetime_", "timezone_", "is_", "callable", "arguments", "unexpected_", "multiple_",
    "url_", "uuid_", "decimal_", "fraction_", "complex_",
)  # fmt: skip
"""How kinds begin that no message has a type for, and the one that only follows another."""


@pytest.mark.parametrize(("document", "kind", "words"), [(each, *told) for each, told in DOCUMENTS.items()])
def test_a_problem_is_told_in_words(document: str, kind: str, words: str) -> None:
    with pytest.raises(ValidationError) as caught:
        _Asked.model_validate_json(document)
    assert [each["type"] for each in caught.value.errors()] == [kind]
    assert [each.expected for each in problems_of(caught.value)] == [words]


@pytest.mark.parametrize(("kind", "document", "words"), [(kind, *told) for kind, told in PLAIN.items()])
def test_a_problem_of_a_file_is_told_in_words(kind: str, document: dict[str, object], words: str) -> None:
    with pytest.raises(ValidationError) as caught:
        _Asked.model_validate(document)
    assert [each["type"] for each in caught.value.errors()] == [kind]
    assert [each.expected for each in problems_of(caught.value)] == [words]


def test_each_kind_that_is_told_stands_in_the_tables() -> None:
    assert {kind for kind, _ in DOCUMENTS.values()} | set(PLAIN) == SAID


def test_a_kind_of_pydantics_is_told_or_never_raised() -> None:
    kinds = set(get_args(ErrorType))
    assert {each for each in kinds if each not in SAID and not each.startswith(NEVER)} == set()
