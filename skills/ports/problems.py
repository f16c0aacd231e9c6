"""What is wrong with a document, and where: the one translator of pydantic's errors.

Requests, goals, messages and files are refused in the same words.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.message import Message, PlainText

WHOLE: Final = "(the document)"
"""The path of the document itself."""
SHOWN: Final = 80
"""Characters of what was found that an answer repeats."""
MAX_PROBLEMS: Final = 16
"""Problems of one document that an answer names."""
_EXPECTED: Final[Mapping[str, str]] = {
    "missing": "a value",
    "extra_forbidden": "no such field",
    "invalid_key": "a name in text",
    "int_type": "a whole number",
    "int_parsing": "a whole number",
    "int_parsing_size": "a whole number with fewer digits",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "float_parsing": "a number",
    "finite_number": "a finite number",
    "string_type": "text",
    "string_unicode": "text in UTF-8",
    "bool_type": "true or false",
    "bool_parsing": "true or false",
    "tuple_type": "an array",
    "list_type": "an array",
    "dict_type": "an object",
    "model_type": "an object",
    "none_required": "null",
}
"""Kinds of pydantic's that say the same of each value."""
_TOLD: Final[Mapping[str, Callable[[Mapping[str, object]], str]]] = {
    "string_too_short": lambda told: f"text of at least {_some(told['min_length'], 'character')}",
    "string_too_long": lambda told: f"text of at most {_some(told['max_length'], 'character')}",
    "string_pattern_mismatch": lambda told: f"text that matches {told['pattern']}",
    "too_short": lambda told: f"at least {_some(told['min_length'], 'item')}",
    "too_long": lambda told: f"at most {_some(told['max_length'], 'item')}",
    "union_tag_not_found": lambda told: f"an object with {told['discriminator']}",
    "union_tag_invalid": lambda told: f"{told['discriminator']} as one of {told['expected_tags']}",
    "json_invalid": lambda told: f"JSON: {told['error']}",
    "value_error": lambda told: str(told["error"]).removeprefix("expected "),  # a validator's own words
}
"""Kinds that are told by what pydantic tells with them."""
_PLAIN: Final = frozenset(
    {"greater_than", "greater_than_equal", "less_than", "less_than_equal", "literal_error", "enum"}
)
"""Kinds that pydantic itself tells in plain words, after "Input should be"."""
_INTRODUCTION: Final = "Input should be "
SAID: Final = frozenset({*_EXPECTED, *_TOLD, *_PLAIN})
"""Kinds of pydantic's that are told in words; the messages of this house raise no other."""
_FOLLOWS: Final = frozenset({"default_factory_not_called"})
"""Kinds of pydantic's that only say that another field is wrong, which is told by itself."""


class Problem(Message):
    """What is wrong with a document: where in it, what was expected, what was there."""

    path: str
    expected: str
    found: PlainText = ""
    code: str = ""
    """For programs, if they can react to it: ``QUEUE_FULL``, ``NOT_KEPT``."""


def problems_of(error: ValidationError, *, most: int = MAX_PROBLEMS) -> tuple[Problem, ...]:
    """Return what pydantic found as problems: the first ``most`` of them."""
    told = error.errors(include_url=False)
    found = []
    for finding in [each for each in told if each["type"] not in _FOLLOWS][:most]:
        kind = finding["type"]
        expected = _expected(kind, finding["msg"], finding.get("ctx", {}))
        # What a validator says of the whole document names what is wrong; the document itself says no more.
        silent = kind == "missing" or (kind == "value_error" and not finding["loc"])
        shown = "" if silent else show(finding["input"])
        found.append(Problem(path=path_of(finding["loc"]), expected=expected, found=shown))
    return tuple(found) or (Problem(path=WHOLE, expected="a request"),)


def _expected(kind: str, message: str, told: Mapping[str, object]) -> str:
    if kind in _TOLD:
        return _TOLD[kind](told)
    return _EXPECTED.get(kind, message.removeprefix(_INTRODUCTION))


def _some(number: object, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def in_words(problems: tuple[Problem, ...]) -> str:
    """Return problems as a sentence: where, what was expected, what was found."""
    return "; ".join(
        f"{each.path}: {_expectation(each.expected)}" + (f", found {each.found}" if each.found else "")
        for each in problems
    )


def _expectation(expected: str) -> str:
    """Return it as a part of a sentence; a validator's own words are one already."""
    return expected if "expected" in expected else f"expected {expected}"


def show(value: object) -> str:
    """Return a value as JSON, cut short."""
    try:
        text = json.dumps(value, ensure_ascii=False)
        text.encode("utf-8")
    except (TypeError, ValueError):
        text = ascii(value)
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 1]}…"


def path_of(steps: tuple[str | int, ...]) -> str:
    """Return a place in a document in words: names and numbers with dots between."""
    return ".".join(show(step)[1:-1] if isinstance(step, str) else str(step) for step in steps) or WHOLE
