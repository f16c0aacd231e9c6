"""Every whole number from the bus or a file has bounds: one of 20 digits ended the executive once."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator
from types import ModuleType

import pytest
from pydantic import JsonValue, TypeAdapter

from tandem import sim, skills, trees
from tandem.skills.ports.message import MOST, Message

_ADAPTER: TypeAdapter[JsonValue] = TypeAdapter(JsonValue)


def modules(room: ModuleType) -> Iterator[ModuleType]:
    for found in pkgutil.walk_packages(room.__path__, f"{room.__name__}."):
        yield importlib.import_module(found.name)


def models() -> list[type[Message]]:
    """Every message model of the rooms; ``executive`` writes reports, which nobody sends to it."""
    found = {
        value
        for room in (skills, sim, trees)
        for module in modules(room)
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, Message) and value is not Message
    }
    return sorted(found, key=lambda each: f"{each.__module__}.{each.__qualname__}")


def unbounded(schema: JsonValue, path: str = "") -> list[str]:
    """Return the places of whole numbers in a schema that have no bound, or one that JSON can't carry."""
    if isinstance(schema, list):
        return [place for index, each in enumerate(schema) for place in unbounded(each, f"{path}.{index}")]
    if not isinstance(schema, dict):
        return []
    found = [] if schema.get("type") != "integer" or _bounded(schema) else [path]
    return found + [place for name, each in schema.items() for place in unbounded(each, f"{path}.{name}")]


def _bounded(schema: dict[str, JsonValue]) -> bool:
    if "enum" in schema or "const" in schema:
        return True
    least, most = (
        next((schema[name] for name in names if name in schema), None)
        for names in (("minimum", "exclusiveMinimum"), ("maximum", "exclusiveMaximum"))
    )
    return all(isinstance(each, int | float) and abs(each) <= MOST for each in (least, most))


@pytest.mark.parametrize("model", models(), ids=lambda each: f"{each.__module__}.{each.__qualname__}")
def test_every_whole_number_is_bounded(model: type[Message]) -> None:
    assert unbounded(_ADAPTER.validate_python(model.model_json_schema())) == []


def test_an_unbounded_number_is_found() -> None:
    class Loose(Message):
        some: tuple[int, ...]

    assert unbounded(_ADAPTER.validate_python(Loose.model_json_schema())) == [".properties.some.items"]
