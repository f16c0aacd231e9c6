"""What is wrong with a document, and where: the one translator of pydantic's errors.

Requests, goals, messages and files are refused in the same words.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.message import Message

WHOLE: Final = "(the document)"
"""The path of the document itself."""
SHOWN: Final = 80
"""Characters of what was found that an answer repeats."""
MAX_PROBLEMS: Final = 16
"""Problems of one document that an answer names."""
_EXPECTED: Final[Mapping[str, str]] = {
    "missing": "a value",
    "extra_forbidden": "no such field",
    "int_type": "a whole number",
    "float_type": "a number",
    "string_type": "text",
    "bool_type": "true or false",
    "finite_number": "a finite number",
    "tuple_type": "an array",
    "list_type": "an array",
    "dict_type": "an object",
    "model_type": "an object",
    "none_required": "null",
}


_FOLLOWS: Final = frozenset({"default_factory_not_called"})
"""Kinds of pydantic's that only say that another field is wrong, which is told by itself."""


class Problem(Message):
    """What is wrong with a document: where in it, what was expected, what was there."""

    path: str
    expected: str
    found: str = ""
    code: str = ""
    """For programs, if they can react to it: ``QUEUE_FULL``, ``NOT_KEPT``."""


def problems_of(error: ValidationError, *, most: int = MAX_PROBLEMS) -> tuple[Problem, ...]:
    """Return what pydantic found as problems: the first ``most`` of them."""
    told = error.errors(include_url=False, include_context=False)
    found = []
    for finding in [each for each in told if each["type"] not in _FOLLOWS][:most]:
        kind, message = finding["type"], finding["msg"]
        expected = _EXPECTED.get(kind, message.removeprefix("Input should be ").removeprefix("Value error, "))
        expected = expected.removeprefix("expected ")  # a validator's own words
        # What a validator says of the whole document names what is wrong; the document itself says no more.
        silent = kind == "missing" or (kind == "value_error" and not finding["loc"])
        shown = "" if silent else show(finding["input"])
        found.append(Problem(path=path_of(finding["loc"]), expected=expected, found=shown))
    return tuple(found) or (Problem(path=WHOLE, expected="a request"),)


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
