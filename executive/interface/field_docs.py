"""The fields of messages in words: JSON's types, bounds, defaults, and the docstrings under the fields."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterator, Mapping
from enum import StrEnum
from types import NoneType, UnionType
from typing import Annotated, Final, Literal, Union, get_args, get_origin

import annotated_types
from pydantic.fields import FieldInfo

from tandem.skills.ports.message import Message

_PLAIN = {float: "number", int: "whole number", str: "text", bool: "true or false", NoneType: "null"}


def type_name(annotation: object) -> str:
    """Return what JSON calls it; messages and enumerations as links to their tables."""
    origin, arguments = get_origin(annotation), get_args(annotation)
    if isinstance(annotation, type) and origin is None:
        return _class_name(annotation)
    describe = _GENERIC.get(origin)
    return "any JSON" if describe is None else describe(arguments)


def _class_name(cls: type) -> str:
    if issubclass(cls, Message | StrEnum):
        return f"[{cls.__name__}](#{cls.__name__.lower()})"
    return _PLAIN.get(cls, cls.__name__)


def _union(arguments: tuple[object, ...]) -> str:
    return " or ".join(dict.fromkeys(type_name(each) for each in arguments))


def _array(arguments: tuple[object, ...]) -> str:
    if len(arguments) == 2 and arguments[1] is Ellipsis:  # noqa: PLR2004 - tuple[X, ...]
        return f"array of {type_name(arguments[0])}"
    names = [type_name(each) for each in arguments]
    if len(set(names)) == 1:
        return f"{len(names)} of {names[0]}"
    return f"[{', '.join(names)}]"


_GENERIC: Final[Mapping[object, Callable[[tuple[object, ...]], str]]] = {
    Annotated: lambda arguments: _bounded(type_name(arguments[0]), arguments[1:]),
    Union: _union,
    UnionType: _union,
    Literal: lambda arguments: " or ".join(f'`"{each}"`' for each in arguments),
    tuple: _array,
    list: lambda arguments: f"array of {type_name(arguments[0])}",
    dict: lambda arguments: f"object of {type_name(arguments[1])}",
}


def field_type(info: FieldInfo) -> str:
    """Return a field's type with its bounds."""
    return _bounded(type_name(info.annotation), tuple(info.metadata))


def field_default(info: FieldInfo) -> str:
    """Return a field's default as JSON would have it, "" when a value is required."""
    if info.is_required():
        return ""
    if info.default_factory is not None:
        return "`{}`"
    default = info.default
    if isinstance(default, Message):
        return f"`{default.model_dump_json()}`" if default.model_fields_set else "its defaults"
    if isinstance(default, tuple):
        return f"`[{', '.join(_json(each) for each in default)}]`"
    return f"`{_json(default)}`"


def field_docs(model: type[Message]) -> dict[str, str]:
    """Return what stands under each field in the model's source (PEP 257's attribute docstrings)."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(model)))
    body = tree.body[0]
    assert isinstance(body, ast.ClassDef)
    found: dict[str, str] = {}
    for field, after in zip(body.body, body.body[1:], strict=False):
        named = isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name)
        if named and isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
            assert isinstance(field, ast.AnnAssign)
            assert isinstance(field.target, ast.Name)
            found[field.target.id] = _markdown(str(after.value.value))
    return found


def first_paragraph(thing: object) -> str:
    """Return a docstring's beginning, up to an empty line, in one line."""
    return _markdown((inspect.getdoc(thing) or "").split("\n\n")[0])


def whole_doc(thing: object) -> str:
    """Return a docstring, each paragraph in one line."""
    paragraphs = (inspect.getdoc(thing) or "").split("\n\n")
    return "\n\n".join(_markdown(each) for each in paragraphs)


def models_within(annotation: object) -> Iterator[type[Message | StrEnum]]:
    """Yield the messages and enumerations that an annotation names."""
    if isinstance(annotation, type) and get_origin(annotation) is None:
        if issubclass(annotation, Message | StrEnum):
            yield annotation
        return
    for each in get_args(annotation):
        yield from models_within(each)


def _markdown(text: str) -> str:
    """Return a docstring's text in one line, with Markdown's marks for code."""
    return " ".join(text.split()).replace("``", "`")


def _bounded(name: str, metadata: tuple[object, ...]) -> str:
    parts = [text for each in metadata for text in _bounds(each)]
    return f"{name}, {', '.join(parts)}" if parts else name


def _bounds(constraint: object) -> Iterator[str]:
    if isinstance(constraint, FieldInfo):
        for each in constraint.metadata:
            yield from _bounds(each)
    elif isinstance(constraint, annotated_types.Ge):
        yield f"≥ {constraint.ge}"
    elif isinstance(constraint, annotated_types.Gt):
        yield f"> {constraint.gt}"
    elif isinstance(constraint, annotated_types.Le):
        yield f"≤ {constraint.le}"
    elif isinstance(constraint, annotated_types.Lt):
        yield f"< {constraint.lt}"
    elif isinstance(constraint, annotated_types.MinLen):
        yield f"at least {constraint.min_length} of them"
    elif isinstance(constraint, annotated_types.MaxLen):
        yield f"at most {constraint.max_length} of them"


def _json(value: object) -> str:
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    return f'"{value}"' if isinstance(value, str) else str(value)
