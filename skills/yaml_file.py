"""The one reader of the YAML that people write: sites, scenarios, faults. It is strict, and guesses nothing.

Values are those of YAML 1.2's core schema (https://yaml.org/spec/1.2.2/#103-core-schema), with decimal
numbers as in JSON. What YAML 1.1 reads as something else (``035`` is 29, ``1:30`` is 90, ``no`` is false) is
refused, because parsers and people differ on it. So are a key that stands twice, tags, merge keys, and
documents without end. Each refusal is a ``DocumentError`` with file, path and line.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final, TypeVar

import yaml
from pydantic import BaseModel, JsonValue, ValidationError

from tandem.skills.ports.documents import TOO_LARGE
from tandem.skills.ports.problems import WHOLE, in_words, problems_of
from tandem.skills.ports.sources import DocumentError, Source

Document = TypeVar("Document", bound=BaseModel)

MOST_BYTES: Final = 1 << 20
"""Of a file. The longest that comes along has 5 kB; PyYAML takes about 10 s for this much."""
DEEPEST: Final = 32
"""Levels of nesting. No model has more than 8; Python's own stack ends near 1,000."""
MOST_VALUES: Final = 100_000
"""Values in a document, each alias counted with all that it stands for: ten lines of aliases of aliases
would otherwise be billions."""
LONGEST_NUMBER: Final = 40
"""Characters of a number: a double needs 24."""
LONGEST_SHOWN: Final = 80
"""Characters of a path or a value in a message: the rest of a longer one says no more than its line."""

_NULL: Final = frozenset({"", "~", "null", "Null", "NULL"})
_BOOLEANS: Final = {
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
}
_INTEGER: Final = re.compile(r"[-+]?(0|[1-9][0-9]*)")
_FLOAT: Final = re.compile(
    r"[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)"
)
_UNCLEAR: Final = (
    (re.compile(r"[-+]?0[0-9][0-9_.eE+-]*"), "some parsers read a leading zero as octal"),
    (re.compile(r"[-+]?0[xob][0-9a-fA-F_]+"), "only decimal numbers are allowed"),
    (re.compile(r"[-+]?[0-9][0-9_]*_[0-9_]*(\.[0-9_]*)?"), "some parsers drop the underscores"),
    (re.compile(r"[-+]?[0-9]+(:[0-5]?[0-9])+(\.[0-9_]*)?"), "some parsers read it in base 60"),
    (re.compile(r"yes|no|on|off", re.IGNORECASE), "some parsers read it as true or false"),
    (re.compile(r"[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}([Tt ].*)?"), "some parsers read it as a date"),
    (re.compile(r"<<|="), "it has a special meaning in YAML 1.1"),
)
"""What YAML 1.1 (PyYAML's reading) and 1.2 take for different values, and why."""


def read_document(path: Path) -> tuple[JsonValue, Source]:
    """Return what a file says, and where.

    Raises:
        DocumentError: it can't be read, or is not YAML that has one meaning.
    """
    try:
        with path.open("rb") as file:
            content = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise DocumentError(f"{path}: cannot read: {error.strerror}") from None
    if len(content) > MOST_BYTES:
        raise DocumentError(f"{path}: expected at most {MOST_BYTES} bytes")
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        raise DocumentError(f"{path}: cannot read: not UTF-8 text") from None
    return parse_document(text, str(path))


def parse_document(text: str, name: str) -> tuple[JsonValue, Source]:
    """Return what YAML text says, and where; ``name`` is what messages call it.

    Raises:
        DocumentError: it is not YAML that has one meaning.
    """
    try:
        return _Reader(text, name).read()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = "" if mark is None else f" line {mark.line + 1}, column {mark.column + 1}:"
        reason = error.problem or error.context or "no reason given"
        raise DocumentError(f"{name}:{where} not YAML: {reason}{_hint(reason)}") from None
    except yaml.YAMLError as error:
        raise DocumentError(f"{name}: not YAML: {' '.join(str(error).split())}") from None


def _hint(reason: str) -> str:
    """Return what is mostly meant by words of the parser's that only its authors understand."""
    indent = "block end" in reason or reason.startswith("mapping values are not allowed")
    return "; is this line indented as its neighbours are, and the one before it complete?" if indent else ""


def validate(data: JsonValue, source: Source, model: type[Document], *, knowing: object = None) -> Document:
    """Return the model of what a file says. A value of another type is a mistake and is not converted.

    Args:
        data: what the file says.
        source: the file.
        model: of the document.
        knowing: what its validators are to know beside it, such as the site that names its items.

    Raises:
        DocumentError: with a line for each mistake.
    """
    try:
        # By way of JSON: pydantic's strict mode then takes lists for tuples, and no text for numbers.
        return model.model_validate_json(json.dumps(data), strict=True, context=knowing)
    except ValidationError as error:
        raise DocumentError("\n".join(mistakes(error, source))) from None


def mistakes(error: ValidationError, source: Source) -> list[str]:
    """Return a line for each mistake: file, path and line, what was expected, what was found."""
    return [
        in_words((each.model_copy(update={"path": source.at("" if each.path == WHOLE else each.path)}),))
        for each in problems_of(error, most=error.error_count())
    ]


def _line(event: yaml.Event) -> int:
    assert event.start_mark is not None, "PyYAML marks all that it reads from text"
    return event.start_mark.line + 1


def _is_unicode(text: str) -> bool:
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


class _Reader:
    """Builds the value from PyYAML's events; these come one by one, so that depth and number are bounded."""

    def __init__(self, text: str, name: str) -> None:
        self._name = name
        self._events: Iterator[yaml.Event] = yaml.parse(text, Loader=yaml.SafeLoader)
        self._lines: dict[str, int] = {}
        self._anchors: dict[str, tuple[JsonValue, int]] = {}
        self._values = 0

    def read(self) -> tuple[JsonValue, Source]:
        """Return the only document; an empty file is None."""
        found: JsonValue = None
        documents = 0
        for event in self._events:
            if isinstance(event, yaml.DocumentStartEvent):
                documents += 1
                if documents > 1:
                    raise self._refused("", event, "expected one document; here starts another")
                found = self._value(next(self._events), "", 0)
        return found, Source(self._name, self._lines)

    def _value(self, event: yaml.Event, path: str, depth: int) -> JsonValue:
        self._lines[path] = _line(event)
        if depth > DEEPEST:
            raise self._refused(path, event, f"expected at most {DEEPEST} levels of nesting")
        before = self._values
        self._count(1, path, event)
        if isinstance(event, yaml.AliasEvent):
            return self._of_alias(event, path)
        assert isinstance(event, yaml.CollectionStartEvent | yaml.ScalarEvent)
        if event.tag is not None:
            raise self._refused(path, event, f"tags are not allowed; found {event.tag}")
        value: JsonValue
        if isinstance(event, yaml.MappingStartEvent):
            value = self._mapping(path, depth)
        elif isinstance(event, yaml.SequenceStartEvent):
            value = self._sequence(path, depth)
        else:
            assert isinstance(event, yaml.ScalarEvent)
            value = self._scalar(event, path)
        if event.anchor is not None:
            self._anchors[event.anchor] = value, self._values - before
        return value

    def _of_alias(self, event: yaml.AliasEvent, path: str) -> JsonValue:
        if event.anchor not in self._anchors:
            raise self._refused(path, event, f"unknown anchor &{event.anchor}")
        value, weight = self._anchors[event.anchor]
        self._count(weight, path, event)
        return value

    def _mapping(self, path: str, depth: int) -> JsonValue:
        found: dict[str, JsonValue] = {}
        firsts: dict[str, int] = {}
        for event in self._events:
            if isinstance(event, yaml.MappingEndEvent):
                return found
            key = self._key(event, path)
            deeper = f"{path}.{key}" if path else key
            line = _line(event)
            if key in firsts:
                reason = f"duplicate key; first used in line {firsts[key]}"
                raise self._refused(deeper, event, reason)
            firsts[key] = line
            found[key] = self._value(next(self._events), deeper, depth + 1)
            self._lines[deeper] = line
        raise AssertionError("PyYAML ends each mapping that it starts")

    def _sequence(self, path: str, depth: int) -> JsonValue:
        found: list[JsonValue] = []
        for event in self._events:
            if isinstance(event, yaml.SequenceEndEvent):
                return found
            deeper = f"{path}.{len(found)}" if path else str(len(found))
            found.append(self._value(event, deeper, depth + 1))
        raise AssertionError("PyYAML ends each sequence that it starts")

    def _key(self, event: yaml.Event, path: str) -> str:
        if not isinstance(event, yaml.ScalarEvent) or event.tag is not None:
            raise self._refused(path, event, "expected a name as key")
        key = self._scalar(event, path)
        if not isinstance(key, str):
            raise self._refused(path, event, f"expected a name as key, found {event.value}")
        return key

    def _scalar(self, event: yaml.ScalarEvent, path: str) -> JsonValue:
        text = event.value
        if not _is_unicode(text):
            raise self._refused(path, event, "expected Unicode text, found half a surrogate pair")
        if event.style is not None:  # quoted, or a block: it is text
            return text
        if text in _NULL:
            return None
        if text in _BOOLEANS:
            return _BOOLEANS[text]
        if len(text) <= LONGEST_NUMBER and _INTEGER.fullmatch(text):
            return self._bounded(int(text), path, event)
        if len(text) <= LONGEST_NUMBER and _FLOAT.fullmatch(text):
            number = float(text.lower().replace(".inf", "inf").replace(".nan", "nan"))
            return self._bounded(number, path, event) if "n" not in text.lower() else number
        for unclear, why in _UNCLEAR:
            if unclear.fullmatch(text):
                advice = f"{text} is ambiguous ({why}); quote it if it is text, or write it unambiguously"
                raise self._refused(path, event, advice)
        return text

    def _bounded(self, number: float, path: str, event: yaml.ScalarEvent) -> float:
        if abs(number) < TOO_LARGE:
            return number
        raise self._refused(path, event, f"expected a number below {TOO_LARGE:g}, found {event.value}")

    def _count(self, more: int, path: str, event: yaml.Event) -> None:
        self._values += more
        if self._values > MOST_VALUES:
            raise self._refused(path, event, f"expected at most {MOST_VALUES} values")

    def _refused(self, path: str, event: yaml.Event, reason: str) -> DocumentError:
        line = f"line {_line(event)}"
        shown = path if len(path) <= LONGEST_SHOWN else f"{path[:LONGEST_SHOWN]}..."
        where = f"{shown} ({line})" if path else line
        return DocumentError(f"{self._name}: {where}: {reason}")
