"""``tandem request KIND``: a sub-command for each kind of task, its options made from the request's model."""

from __future__ import annotations

import inspect
import uuid
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Final, Literal, get_args, get_origin

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from pydantic import JsonValue
    from pydantic.fields import FieldInfo

    from tandem.skills.ports.message import Message
    from tandem.trees.task import TaskType

_SIMPLE: Final = (int, float, str, bool)
_ENVELOPE: Final = ("task", "id")


def add_to(app: typer.Typer, *, with_kinds: bool) -> None:
    """Add the group; with the kinds of request only when they are needed, for they take time to load."""
    group = typer.Typer(help="Send a request to the robot.", no_args_is_help=True)
    group.command("json")(connects(from_json))
    if with_kinds:
        from tandem.trees.registry import discover  # noqa: PLC0415

        for kind in discover().values():
            group.command(kind.name, help=kind.summary)(command_of(kind))
    app.add_typer(group, name="request")


Wait = Annotated[bool, typer.Option("--wait", "-w", help="Wait until the task ends. Exit 1 if it fails.")]


def from_json(
    document: Annotated[str, typer.Argument(help='The request, e.g. {"task": "fetch", "item": 29}.')],
    wait: Wait = False,  # noqa: FBT002
    *,
    bus: BusOptions,
) -> None:
    """Send a JSON request unchanged."""
    from tandem.executive.cli.sending import send  # noqa: PLC0415

    send(document.encode("utf-8", "surrogateescape"), bus, wait=wait)


def command_of(kind: TaskType[Message]) -> Callable[..., None]:
    """Return a function whose signature has an option for each field of the request."""
    fields = {name: info for name, info in kind.request.model_fields.items() if name not in _ENVELOPE}

    def command(*, wait: bool, bus: BusOptions, **given: object) -> None:
        from tandem.executive.cli.sending import send_fields  # noqa: PLC0415

        document: dict[str, JsonValue] = {"task": kind.name, "id": uuid.uuid4().hex}
        document.update({name: _json(value) for name, value in given.items() if value is not None})
        send_fields(document, bus, wait=wait)

    waits = inspect.Parameter("wait", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=Wait)
    parameters = [*(_parameter(name, info) for name, info in fields.items()), waits]
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {each.name: each.annotation for each in parameters}
    command.__name__ = kind.name
    return connects(command)


def _parameter(name: str, info: FieldInfo) -> inspect.Parameter:
    option = typer.Option(f"--{name.replace('_', '-')}", help=_help(info))
    default = inspect.Parameter.empty if info.is_required() else None
    kind = _option_type(info.annotation)
    annotation = Annotated[kind, option] if info.is_required() else Annotated[kind | None, option]
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _option_type(annotation: object) -> type:
    """Return what an option of the field takes; what is not simple is given as text, in JSON."""
    options = [each for each in get_args(annotation) if each is not type(None)]
    if annotation in _SIMPLE and isinstance(annotation, type):
        return annotation
    if get_origin(annotation) is not Literal and len(options) == 1:
        return _option_type(options[0])
    return str


def _help(info: FieldInfo) -> str:
    text = info.description or ""
    default = "" if info.is_required() or info.default is None else f"(default: {info.default})"
    return " ".join(part for part in (text, *_choices(info.annotation), default) if part)


def _choices(annotation: object) -> tuple[str, ...]:
    if get_origin(annotation) is Literal:
        return (f"({' or '.join(str(each) for each in get_args(annotation))})",)
    return tuple(text for each in get_args(annotation) for text in _choices(each))


def _json(value: object) -> JsonValue:
    """Return an option's value as the document's: text that is an array or an object is read as one."""
    if isinstance(value, str) and value[:1] in {"[", "{"}:
        import json  # noqa: PLC0415

        try:
            read: JsonValue = json.loads(value)
        except ValueError:
            return value
        return read
    assert isinstance(value, bool | int | float | str)
    return value
