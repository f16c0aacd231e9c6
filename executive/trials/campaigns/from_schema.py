"""Values that a JSON Schema takes, as a hypothesis strategy: for as much of JSON Schema as pydantic writes.

hypothesis-jsonschema knows all of JSON Schema, but not the hypothesis of today: its last release calls what
is no longer there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from typing import Final

from hypothesis import strategies as st
from pydantic import JsonValue

Schema = dict[str, JsonValue]
Values = st.SearchStrategy[JsonValue]
_SINCE: Final = datetime(1970, 1, 2)  # noqa: DTZ001 - hypothesis adds the zone
LONGEST: Final = 8
"""Elements of an array that has no bound of its own."""


def from_schema(schema: JsonValue, definitions: Mapping[str, JsonValue]) -> Values:
    """Return the values.

    Args:
        schema: what they fit.
        definitions: where its references lead (``#/.../name``).

    Raises:
        ValueError: for a schema that says something else than the schemas of messages do.
    """
    assert isinstance(schema, dict)
    if "$ref" in schema:
        name = str(schema["$ref"]).rsplit("/", 1)[1]
        # Deferred: a node of a tree has nodes below it.
        return st.deferred(lambda: from_schema(definitions[name], definitions))
    if "const" in schema:
        return st.just(schema["const"])
    if "enum" in schema:
        return st.sampled_from(_list(schema["enum"]))
    choices = schema.get("anyOf") or schema.get("oneOf")
    if choices:
        return st.one_of([from_schema(each, definitions) for each in _list(choices)])
    if "type" not in schema:
        return st.none() | st.booleans() | st.integers() | st.text()
    make = _TYPES.get(str(schema["type"]))
    if make is None:
        raise ValueError(f"expected a schema of one of {', '.join(_TYPES)}; found {schema}")
    return make(schema, definitions)


def _object(schema: Schema, definitions: Mapping[str, JsonValue]) -> Values:
    fields, required = schema.get("properties") or {}, _list(schema.get("required") or [])
    assert isinstance(fields, dict)
    made = {name: from_schema(each, definitions) for name, each in fields.items()}
    must = {name: values for name, values in made.items() if name in required}
    may = {name: values for name, values in made.items() if name not in required}
    more = schema.get("additionalProperties")
    if not made and isinstance(more, dict):
        return st.dictionaries(st.text(max_size=8), from_schema(more, definitions), max_size=3).map(as_json)
    return st.fixed_dictionaries(must, optional=may).map(as_json)


def _array(schema: Schema, definitions: Mapping[str, JsonValue]) -> Values:
    if "prefixItems" in schema:
        return st.tuples(*(from_schema(each, definitions) for each in _list(schema["prefixItems"]))).map(list)
    least, most = _whole(schema.get("minItems"), 0), _whole(schema.get("maxItems"), LONGEST)
    items = from_schema(schema.get("items") or {}, definitions)
    return st.lists(items, min_size=least, max_size=min(most, least + LONGEST)).map(as_json)


def _string(schema: Schema, _: Mapping[str, JsonValue]) -> Values:
    if "pattern" in schema:
        return st.from_regex(str(schema["pattern"]), fullmatch=True).map(as_json)
    if schema.get("format") == "date-time":
        return st.datetimes(_SINCE, timezones=st.just(UTC)).map(lambda moment: as_json(moment.isoformat()))
    most = schema.get("maxLength")
    return st.text(
        st.characters(codec="utf-8"),
        min_size=_whole(schema.get("minLength"), 0),
        max_size=None if most is None else _whole(most, 0),
    ).map(as_json)


def _integer(schema: Schema, _: Mapping[str, JsonValue]) -> Values:
    return st.integers(
        _bound(schema, "minimum", "exclusiveMinimum", 1), _bound(schema, "maximum", "exclusiveMaximum", -1)
    ).map(as_json)


def _number(schema: Schema, _: Mapping[str, JsonValue]) -> Values:
    return st.floats(
        min_value=_float(schema.get("minimum", schema.get("exclusiveMinimum"))),
        max_value=_float(schema.get("maximum", schema.get("exclusiveMaximum"))),
        exclude_min="exclusiveMinimum" in schema,
        exclude_max="exclusiveMaximum" in schema,
        allow_nan=False,
        allow_infinity=False,
    ).map(as_json)


_TYPES: Final[Mapping[str, Callable[[Schema, Mapping[str, JsonValue]], Values]]] = {
    "object": _object,
    "array": _array,
    "string": _string,
    "integer": _integer,
    "number": _number,
    "boolean": lambda _schema, _definitions: st.booleans().map(as_json),
    "null": lambda _schema, _definitions: st.none().map(as_json),
}


def as_json(value: JsonValue) -> JsonValue:
    """Return it: a strategy of texts is one of values, which the type checker can't see by itself."""
    return value


def _list(value: JsonValue) -> list[JsonValue]:
    assert isinstance(value, list)
    return value


def _bound(schema: Schema, name: str, beyond: str, step: int) -> int | None:
    if beyond in schema:
        return _whole(schema[beyond], 0) + step
    return _whole(schema[name], 0) if name in schema else None


def _whole(value: JsonValue, default: int) -> int:
    return int(value) if isinstance(value, int | float) else default


def _float(value: JsonValue) -> float | None:
    return float(value) if isinstance(value, int | float) else None
