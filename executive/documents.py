"""JSON from strangers: bounded, and each thing that is wrong with it is named by its path.

Python's own parser takes more than JSON is (NaN, a name twice, half of a surrogate pair). Here it first
makes a plain tree that still shows all of that; a walk over the tree then makes the document, and says
where it found what.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue

from skills.ports.message import MAX_REQUEST_BYTES
from skills.ports.tasks import Problem

WHOLE: Final = "(the document)"
"""The path of the document itself."""
MAX_DEPTH: Final = 16
"""Objects and arrays within each other, at the most."""
MAX_DIGITS: Final = 300
"""Digits of a number, at the most."""
SHOWN: Final = 80
"""Characters of what was found that an answer repeats."""


@dataclass(frozen=True)
class _Pairs:
    """An object as it was written: a name may stand in it twice."""

    pairs: list[tuple[str, object]]


@dataclass(frozen=True)
class _NoNumber:
    """Something that stands where a number would, and is none of JSON's."""

    text: str


def parse(payload: bytes, *, limit: int = MAX_REQUEST_BYTES) -> dict[str, JsonValue] | tuple[Problem, ...]:
    """Return the JSON object in ``payload``, or what is wrong with it and where.

    Args:
        payload: what was sent.
        limit: bytes that it may have.
    """
    raw = _read(payload, limit)
    if isinstance(raw, Problem):
        return (raw,)
    walk = _Walk()
    document = walk.convert(raw, ())
    if walk.problems:
        return tuple(walk.problems)
    return document if isinstance(document, dict) else (_wrong("a JSON object", show(document)),)


def _read(payload: bytes, limit: int) -> object:
    """Return the tree that the payload says, with what is no JSON still in it, or a problem."""
    if len(payload) > limit:
        return _wrong(f"at most {limit} bytes", f"{len(payload)} bytes")
    try:
        text = payload.decode("utf-8")
    except UnicodeDecodeError as error:
        return _wrong("JSON in UTF-8", f"byte 0x{payload[error.start]:02x} at {error.start}")
    depth = _depth(text)
    if depth > MAX_DEPTH:
        return _wrong(f"at most {MAX_DEPTH} objects and arrays within each other", str(depth))
    try:
        raw: object = json.loads(
            text,
            object_pairs_hook=_Pairs,
            parse_constant=_NoNumber,
            parse_float=_number,
            parse_int=_whole_number,
        )
    except json.JSONDecodeError as error:
        found = f"{error.msg} at line {error.lineno}, column {error.colno}" if text.strip() else "nothing"
        return _wrong("JSON", found)
    return raw


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


@dataclass
class _Walk:
    """Makes plain values, and finds what JSON does not know or an answer could not repeat."""

    problems: list[Problem] = field(default_factory=list)

    def convert(self, value: object, steps: tuple[str | int, ...]) -> JsonValue:
        if isinstance(value, _Pairs):
            return self._object(value.pairs, steps)
        if isinstance(value, list):
            return [self.convert(each, (*steps, index)) for index, each in enumerate(value)]
        if isinstance(value, _NoNumber):
            self._note(steps, "a finite number", value.text)
            return None
        if isinstance(value, str):
            self._text(value, steps)
            return value
        assert value is None or isinstance(value, bool | int | float)
        return value

    def _object(self, pairs: list[tuple[str, object]], steps: tuple[str | int, ...]) -> JsonValue:
        made: dict[str, JsonValue] = {}
        for name, value in pairs:
            here = (*steps, name)
            self._text(name, here)
            if name in made:
                self._note(here, "each name once", "the name twice")
            made[name] = self.convert(value, here)
        return made

    def _text(self, text: str, steps: tuple[str | int, ...]) -> None:
        try:
            text.encode("utf-8")
        except UnicodeEncodeError:
            self._note(steps, "Unicode text", "half of a surrogate pair")

    def _note(self, steps: tuple[str | int, ...], expected: str, found: str) -> None:
        self.problems.append(Problem(path=path_of(steps), expected=expected, found=found))


def _wrong(expected: str, found: str) -> Problem:
    return Problem(path=WHOLE, expected=expected, found=found)


def _number(text: str) -> float | _NoNumber:
    value = float(text)
    return value if math.isfinite(value) else _NoNumber(_short(text))


def _whole_number(text: str) -> int | _NoNumber:
    return int(text) if len(text) <= MAX_DIGITS else _NoNumber(_short(text))


def _short(text: str) -> str:
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 1]}…"


def _depth(text: str) -> int:
    """Return how deep brackets are nested outside strings; the parser itself would overflow its stack."""
    deepest = depth = 0
    quoted = escaped = False
    for char in text:
        if quoted:
            quoted = escaped or char != '"'
            escaped = char == "\\" and not escaped
        elif char == '"':
            quoted = True
        elif char in "[{":
            depth += 1
            deepest = max(deepest, depth)
        elif char in "]}":
            depth -= 1
    return deepest
