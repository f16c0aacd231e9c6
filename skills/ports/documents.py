"""JSON from strangers: bounded, and each thing that is wrong with it is named by its path.

Python's own parser takes more than JSON is (NaN, a name twice, half of a surrogate pair). A document that
shows no sign of such things is parsed at once. Any other first becomes a plain tree that still shows all of
them; a walk over the tree then makes the document, and says where it found what.
"""

from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue

from tandem.skills.ports.limits import MAX_DEPTH
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.ports.problems import MAX_PROBLEMS, SHOWN, WHOLE, Problem, path_of, show

MAX_DIGITS: Final = 30
"""Digits of a whole number, at the most."""
TOO_LARGE: Final = 1e30
"""Numbers from here on are refused: products of several of them would be infinite, in the middle of sums
about places and joints. Nothing that a robot is told in metres, seconds or newtons comes near."""
_SUSPECT: Final = re.compile(rb"\\u[dD]|[eE]\+?\d{2}|\d{31}|NaN|Infinity")
"""What may be half of a surrogate pair, too large a number, NaN or Infinity, or only looks like it."""
_SMALLER: Final = f"a number below {TOO_LARGE:g}"
_TEXT: Final = re.compile(r'"(?:[^"\\]+|\\.)*"?', re.DOTALL)
_NO_BRACKET: Final = re.compile(r"[^][{}]+")


@dataclass(frozen=True)
class _Pairs:
    """An object as it was written: a name may stand in it twice."""

    pairs: list[tuple[str, object]]


@dataclass(frozen=True)
class _NoNumber:
    """Something that stands where a number would, and is none of JSON's."""

    text: str
    expected: str = "a finite number"


def parse(
    payload: bytes, *, limit: int = MAX_REQUEST_BYTES, depth: int = MAX_DEPTH
) -> dict[str, JsonValue] | tuple[Problem, ...]:
    """Return the JSON object in ``payload``, or what is wrong with it and where.

    Args:
        payload: what was sent.
        limit: bytes that it may have.
        depth: objects and arrays that it may have within each other.
    """
    text = _read(payload, limit, depth)
    if isinstance(text, Problem):
        return (text,)
    plain = None if _SUSPECT.search(payload) else _plain(text)
    return _thorough(text) if plain is None else plain


class _TwiceError(ValueError):
    """A name stands twice in an object."""


def _plain(text: str) -> dict[str, JsonValue] | None:
    """Return the object, or None when only the thorough way tells what is wrong with it."""
    try:
        made: object = json.loads(text, object_pairs_hook=_object_once)
    except ValueError:
        return None
    return made if isinstance(made, dict) else None


def _object_once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    made = dict(pairs)
    if len(made) != len(pairs):
        raise _TwiceError
    return made


def _thorough(text: str) -> dict[str, JsonValue] | tuple[Problem, ...]:
    raw = _tree(text)
    if isinstance(raw, Problem):
        return (raw,)
    walk = _Walk()
    document = walk.convert(raw, ())
    if walk.problems:
        return tuple(walk.problems[:MAX_PROBLEMS])
    return document if isinstance(document, dict) else (_wrong("a JSON object", show(document)),)


def _read(payload: bytes, limit: int, most: int) -> str | Problem:
    """Return the payload's text, or a problem that shows without parsing it."""
    if len(payload) > limit:
        return _wrong(f"at most {limit} bytes", f"{len(payload)} bytes")
    try:
        text = payload.decode("utf-8")
    except UnicodeDecodeError as error:
        return _wrong("JSON in UTF-8", f"byte 0x{payload[error.start]:02x} at {error.start}")
    depth = _depth(text, most)
    if depth > most:
        return _wrong(f"at most {most} nested objects and arrays", f"{depth} or more")
    return text


def _tree(text: str) -> object:
    """Return the tree that the text says, with what is no JSON still in it, or a problem."""
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
            self._note(steps, value.expected, value.text)
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
            self._note(steps, "Unicode text", "half a surrogate pair")

    def _note(self, steps: tuple[str | int, ...], expected: str, found: str) -> None:
        self.problems.append(Problem(path=path_of(steps), expected=expected, found=found))


def _wrong(expected: str, found: str) -> Problem:
    return Problem(path=WHOLE, expected=expected, found=found)


def _number(text: str) -> float | _NoNumber:
    value = float(text)
    if not math.isfinite(value):
        return _NoNumber(_short(text))
    return value if abs(value) < TOO_LARGE else _NoNumber(_short(text), _SMALLER)


def _whole_number(text: str) -> int | _NoNumber:
    return int(text) if len(text.lstrip("-")) <= MAX_DIGITS else _NoNumber(_short(text), _SMALLER)


def _short(text: str) -> str:
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 1]}…"


def _depth(text: str, most: int) -> int:
    """Return how deep brackets are nested outside strings, counting no further than one more than ``most``.

    The parser itself would overflow its stack.
    """
    deepest = depth = 0
    for char in _NO_BRACKET.sub("", _TEXT.sub("", text)):
        if char in "[{":
            depth += 1
            deepest = max(deepest, depth)
            if deepest > most:
                break
        else:
            depth -= 1
    return deepest
