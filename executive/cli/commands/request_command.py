"""``tandem request KIND``: a command for each kind of task that the robot offers, from its JSON Schema."""

from __future__ import annotations

import inspect
import uuid
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Annotated, Final

import typer
from typer.core import TyperCommand, TyperGroup

from tandem.executive.cli.arguments import Json, connects, shared_options
from tandem.executive.cli.completing import WITHIN
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.kinds import kinds_of_robot
from tandem.executive.cli.schema_options import fields_of
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from pydantic import JsonValue
    from typer._click import Command, Context

    from tandem.skills.ports.tasks import KindOfTask

ANY_KIND: Final = ("KIND", "Send a request for a task of this kind; kinds and options come from the robot.")
"""How the pages name the commands that only the robot knows, and what they do."""
HELP: Final = (
    "Send a request to the robot. KIND is a kind of task that the robot offers: this help lists them "
    "while it answers, and `tandem request KIND --help` has the options of one."
)


class KindsGroup(TyperGroup):
    """Its commands are those in the code, and one for each kind that the robot offers."""

    def list_commands(self, ctx: Context) -> list[str]:
        """Return the names of all commands; without a robot those in the code."""
        with suppress(CommandError):
            self._add_kinds(ctx, (), quick=ctx.resilient_parsing)
        return super().list_commands(ctx)

    def resolve_command(self, ctx: Context, args: list[str]) -> tuple[str | None, Command | None, list[str]]:
        """Return the command that the words name; kinds are asked of the robot that the others name."""
        name = args[0]
        if ctx.resilient_parsing:  # the shell completes a word: nothing is said, and nothing takes long
            with suppress(Exception):  # a half-typed line may be wrong in any way
                self._add_kinds(ctx, args[1:], quick=True)
        elif name not in self.commands and not name.startswith("-"):
            known = self._add_kinds(ctx, args[1:])
            if name not in known:
                offered = ", ".join(known) or "none"
                raise CommandError(f"the robot offers no task {name!r}; it offers {offered}")
        return super().resolve_command(ctx, args)

    def _add_kinds(self, ctx: Context, words: Sequence[str], *, quick: bool = False) -> list[str]:
        defaults = {} if ctx.default_map is None else ctx.default_map  # of the project's tandem.yaml
        way = defaults.get("json", {})
        kinds = kinds_of_robot(shared_options(words, way), within=WITHIN if quick else None)
        for kind in kinds:
            self.commands.setdefault(kind.name, command_of(kind))
            defaults.setdefault(kind.name, way)
        return [kind.name for kind in kinds]


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(cls=KindsGroup, help=HELP, no_args_is_help=True)
    group.command("json")(connects(from_json))
    app.add_typer(group, name="request", subcommand_metavar="KIND|json [OPTIONS]...")


Wait = Annotated[bool, typer.Option("--wait", "-w", help="Wait until the task ends. Exit 1 if it fails.")]


_OWN: Final = tuple(
    inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=False, annotation=annotation)
    for name, annotation in (("wait", Wait), ("as_json", Json))
)
"""Options that every kind has beside the fields of its request."""


def from_json(
    document: Annotated[
        str,
        typer.Argument(
            metavar="JSON|@FILE|-",
            help='The request, e.g. {"task": "fetch", "item": 29}; @FILE reads a file, - standard input.',
        ),
    ],
    wait: Wait = False,  # noqa: FBT002
    *,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Send a JSON request unchanged: as an argument, from a file or from standard input."""
    from tandem.executive.cli.sending import send  # noqa: PLC0415

    send(read_document(document), bus, wait=wait, as_json=as_json)


def read_document(said: str) -> bytes:
    """Return the document that is given as itself, as ``@file`` or as ``-`` for standard input.

    Raises:
        CommandError: when the file can't be read.
    """
    import sys  # noqa: PLC0415
    from pathlib import Path  # noqa: PLC0415

    if said == "-":
        return sys.stdin.buffer.read()
    if not said.startswith("@"):
        return said.encode("utf-8", "surrogateescape")
    try:
        return Path(said[1:]).read_bytes()
    except OSError as error:
        raise CommandError(f"{said}: cannot read {said[1:]!r}: {error.strerror}") from error


def command_of(kind: KindOfTask) -> TyperCommand:
    """Return a command with an option for each property of the request's schema."""
    fields = fields_of(kind.request)

    def command(*, wait: bool, as_json: bool, bus: BusOptions, **given: object) -> None:
        from tandem.executive.cli.sending import send_fields  # noqa: PLC0415

        document: dict[str, JsonValue] = {"task": kind.name, "id": uuid.uuid4().hex}
        for field in fields:
            if given[field.parameter] not in (None, []):
                document[field.name] = field.read(given[field.parameter])
        send_fields(document, bus, wait=wait, as_json=as_json)

    parameters = [*(field.as_parameter() for field in fields), *_OWN]
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {each.name: each.annotation for each in parameters}
    return single(kind.name, kind.summary, connects(command))


def single(name: str, text: str, function: Callable[..., None]) -> TyperCommand:
    """Return a function as a command of its own."""
    app = typer.Typer(add_completion=False, context_settings={"help_option_names": ["-h", "--help"]})
    app.command(name, help=text)(function)
    made = typer.main.get_command(app)
    assert isinstance(made, TyperCommand)
    return made
