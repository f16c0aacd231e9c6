"""A JSON Schema of a request as a command's options, and what they were given as the request's document."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterable, Mapping
from keyword import iskeyword
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.completing import items
from tandem.executive.cli.errors import CommandError
from tandem.skills.ports.plain_json import read_json

if TYPE_CHECKING:
    from pydantic import JsonValue

Schema = dict[str, "JsonValue"]
OF_THE_KIND: Final = "task"
"""The field that names the kind, which the command's name says already."""
_SIMPLE: Final[Mapping[str, type]] = {"integer": int, "number": float, "boolean": bool, "string": str}
_ITEMS: Final = frozenset({"item", "left", "right"})
"""Fields that name an item: the one that a task is about, or the one for a hand."""
_WORDS: Final = "WORD=WORD"
_TIME: Final = "TIME"


class Field:
    """One property of a request.

    Args:
        name: the property.
        schema: its schema, references followed.
        required: whether a request must have it.
        taken: names that options of the command have already.
    """

    def __init__(
        self, name: str, schema: Schema, *, required: bool, taken: frozenset[str] = frozenset()
    ) -> None:
        self.name, self.required = name, required
        plain = name.isidentifier() and not iskeyword(name) and name not in taken
        self.parameter = name if plain else f"field_{name.encode().hex()}"
        option = name.replace("_", "-")
        self.option = f"--request-{option}" if taken & {name, option} else f"--{option}"
        self._choices = [each for each in _choices(schema) if each.get("type") != "null"]
        self._default = schema.get("default")
        self._text = str(schema.get("description", ""))

    @property
    def maps_words(self) -> bool:
        """Whether it is an object of words, given as ``k=v``."""
        if len(self._choices) != 1 or "properties" in self._choices[0]:
            return False
        (only,) = self._choices
        patterned = only.get("patternProperties")
        values = [
            *(patterned.values() if isinstance(patterned, dict) else ()),
            only.get("additionalProperties"),
        ]
        said = [each for each in values if isinstance(each, dict)]
        return bool(said) and all(each.get("type") == "string" for each in said)

    def as_parameter(self) -> inspect.Parameter:
        """Return it as a parameter of a command's function."""
        kind: object = list[str] if self.maps_words else self._type()
        name = f"{self.option}/--no-{self.option[2:]}" if kind is bool else self.option
        option = typer.Option(
            name, help=self._help(), metavar=self._metavar(), autocompletion=self._completion()
        )
        annotation = Annotated[kind if self.required else kind | None, option]  # type: ignore[valid-type, operator]
        default = inspect.Parameter.empty if self.required else None
        where = inspect.Parameter.KEYWORD_ONLY
        return inspect.Parameter(self.parameter, where, default=default, annotation=annotation)

    def _completion(self) -> Callable[..., object] | None:
        """Return what completes its value: its choices, or the items of the robot's site."""
        choices = self._said()
        if choices:
            return lambda incomplete: [str(each) for each in choices if str(each).startswith(incomplete)]
        return items if self.name in _ITEMS or self.name.endswith("_item") else None

    def read(self, given: object) -> JsonValue:
        """Return what the option was given as the document's value."""
        if isinstance(given, list):
            return dict(self._pair(str(each)) for each in given)
        if isinstance(given, bool | int | float):
            return given
        return self._read(str(given))

    def _pair(self, text: str) -> tuple[str, JsonValue]:
        name, equals, value = text.partition("=")
        if not equals or not name:
            raise CommandError(f"{self.option}: expected k=v; found {text!r}")
        return name, value

    def _read(self, text: str) -> JsonValue:
        """Return text as JSON where more than text fits: an array, an object, a number."""
        if self._is_plain_text():
            return text
        try:
            value: JsonValue = read_json(text)
        except ValueError:
            return text
        return text if isinstance(value, str) else value

    def _is_plain_text(self) -> bool:
        return all(each.get("type") == "string" for each in self._choices)

    def _type(self) -> type:
        found = {_SIMPLE.get(str(each.get("type"))) for each in self._choices}
        (kind,) = found if len(found) == 1 else (None,)
        return kind or str

    def _metavar(self) -> str | None:
        if self.maps_words:
            return _WORDS
        return _TIME if any(each.get("format") == "date-time" for each in self._choices) else None

    def _said(self) -> list[JsonValue]:
        """Return the values that the schema names."""
        said = [value for each in self._choices for value in _list(each.get("enum", []))]
        return said + [each["const"] for each in self._choices if "const" in each]

    def _help(self) -> str:
        said = self._said()
        choices = f"({' or '.join(str(each) for each in said)})" if said else ""
        shown = self._default if self._default not in (None, "", [], {}) else None
        default = "" if shown is None or self.required else f"(default: {_shown(shown)})"
        return " ".join(part for part in (self._text, choices, default) if part)


def fields_of(schema: Mapping[str, JsonValue], beside: Iterable[inspect.Parameter] = ()) -> tuple[Field, ...]:
    """Return the properties of a request's schema but the one that names its kind; the required ones first.

    What the schema does not say of a property is left to the robot, which checks the whole document.

    Args:
        schema: of the request.
        beside: the command's other options; a property with one of their names is ``--request-<name>``.
    """
    taken = _names(beside)
    definitions, properties = schema.get("$defs", {}), schema.get("properties", {})
    required = _list(schema.get("required", []))
    assert isinstance(definitions, dict)
    assert isinstance(properties, dict)
    found = [
        Field(name, _followed(each, definitions), required=name in required, taken=taken)
        for name, each in properties.items()
        if name != OF_THE_KIND
    ]
    return tuple(sorted(found, key=lambda field: not field.required))


def read_given(fields: Iterable[Field], given: Mapping[str, object]) -> dict[str, JsonValue]:
    """Return the fields of a request out of what a command was given; what was not given is left out."""
    said = {field.name: (field, given[field.parameter]) for field in fields}
    return {name: field.read(value) for name, (field, value) in said.items() if value not in (None, [])}


def _names(parameters: Iterable[inspect.Parameter]) -> frozenset[str]:
    """Return the names of parameters and of the options that stand for them, and those of the help."""
    found = {"help"}
    for each in parameters:
        found.add(each.name)
        for option in getattr(each.annotation, "__metadata__", ()):
            # In an annotation typer keeps the first name in the place of the default.
            declared = (getattr(option, "default", None), *(getattr(option, "param_decls", None) or ()))
            names = [word for said in declared if isinstance(said, str) for word in said.split("/")]
            found |= {word.lstrip("-") for word in names if word.startswith("-")}
    return frozenset(found)


def _followed(schema: JsonValue, definitions: Schema, deep: int = 8) -> Schema:
    """Return a schema with the references on its way followed, as far as a command's help needs them."""
    if not isinstance(schema, dict):
        return {}
    name = str(schema.get("$ref", "")).rpartition("/")[2]
    if name and deep:
        return {**_followed(definitions.get(name), definitions, deep - 1), **_without(schema, "$ref")}
    merged = dict(schema)
    for union in ("anyOf", "oneOf"):
        if union in schema and deep:
            merged[union] = [_followed(each, definitions, deep - 1) for each in _list(schema[union])]
    return merged


def _choices(schema: Schema) -> list[Schema]:
    union = _list(schema.get("anyOf", schema.get("oneOf", [])))
    found = [deeper for each in union if isinstance(each, dict) for deeper in _choices(each)]
    return found or [schema]


def _without(schema: Schema, name: str) -> Schema:
    return {key: value for key, value in schema.items() if key != name}


def _list(value: JsonValue) -> list[JsonValue]:
    return value if isinstance(value, list) else []


def _shown(value: JsonValue) -> str:
    return value if isinstance(value, str) else json.dumps(value)
