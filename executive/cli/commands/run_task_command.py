"""``tandem run KIND``: start everything, carry out one request, and stop everything."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final

import typer
from typer.core import TyperCommand, TyperGroup

from tandem.executive.cli.commands.request_command import read_document, single
from tandem.executive.cli.commands.run_commands import SYSTEM_OPTIONS, starts_system
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.schema_options import fields_of
from tandem.executive.config.run_options import RunOptions

if TYPE_CHECKING:
    from pydantic import JsonValue
    from typer._click import Command, Context

    from tandem.skills.ports.message import Message
    from tandem.trees.task import TaskType

ANY_KIND: Final = ("KIND", "Start everything, carry out one request of this kind, and stop everything.")
"""How the pages name the commands of the kinds that are installed, and what they do."""
HELP: Final = (
    "Start a simulated robot, carry out one request and stop. Exits 0 only if the task succeeds. "
    "KIND is a kind of task that is installed here, by Tandem or as a plug-in."
)
Document = Annotated[
    str,
    typer.Argument(metavar="JSON|@FILE|-", help="The request as JSON; @FILE reads a file, - standard input."),
]
Within = Annotated[
    float, typer.Option("--within", min=1.0, max=86_400.0, help="Robot seconds that the task may take.")
]
_OWN: Final = frozenset((*SYSTEM_OPTIONS, "within"))


class KindsGroup(TyperGroup):
    """Its commands are those in the code, and one for each kind of task that is installed."""

    def list_commands(self, ctx: Context) -> list[str]:
        """Return the names of all commands."""
        self._add_kinds(ctx)
        return super().list_commands(ctx)

    def resolve_command(self, ctx: Context, args: list[str]) -> tuple[str | None, Command | None, list[str]]:
        """Return the command that the words name."""
        name = args[0]
        if name not in self.commands and not name.startswith("-"):
            known = self._add_kinds(ctx)
            if name not in known:
                raise CommandError(f"no task {name!r}; expected one of {', '.join(known)}")
        return super().resolve_command(ctx, args)

    def _add_kinds(self, ctx: Context) -> list[str]:
        from tandem.trees.registry import discover  # noqa: PLC0415 - takes a moment

        defaults = {} if ctx.default_map is None else ctx.default_map  # of the project's tandem.yaml
        kinds = discover()
        for kind in kinds.values():
            self.commands.setdefault(kind.name, command_of(kind))
            defaults.setdefault(kind.name, defaults.get("json", {}))
        return list(kinds)


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(cls=KindsGroup, help=HELP, no_args_is_help=True)
    group.command("json")(starts_system(from_json))
    app.add_typer(group, name="run", subcommand_metavar="KIND|json [OPTIONS]...")


def from_json(document: Document, *, within: Within = 900.0, options: RunOptions) -> None:
    """Start everything, carry out a JSON request, and stop everything."""
    raise typer.Exit(_run(read_document(document).decode("utf-8", "replace"), within, options))


def command_of(kind: TaskType[Message]) -> TyperCommand:
    """Return a command with an option for each field; where the name is taken, ``--request-<field>``."""
    fields = fields_of(kind.request.model_json_schema())
    for field in fields:
        if field.parameter in _OWN:
            field.parameter, field.option = f"request_{field.parameter}", f"--request-{field.option[2:]}"

    def command(*, within: float, options: RunOptions, **given: object) -> None:
        document: dict[str, JsonValue] = {"task": kind.name}
        for field in fields:
            if given[field.parameter] not in (None, []):
                document[field.name] = field.read(given[field.parameter])
        raise typer.Exit(_run(json.dumps(document), within, options))

    whole = inspect.Parameter("within", inspect.Parameter.KEYWORD_ONLY, default=900.0, annotation=Within)
    rest = inspect.Parameter("options", inspect.Parameter.KEYWORD_ONLY, annotation=RunOptions)
    parameters = [*(field.as_parameter() for field in fields), whole, rest]
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {each.name: each.annotation for each in parameters}
    started: Callable[..., None] = starts_system(command)
    return single(kind.name, kind.summary, started)


def _run(request: str, within: float, options: RunOptions) -> int:
    from tandem.executive.cli.running_system import run_once  # noqa: PLC0415 - loads the whole system

    return run_once(replace(options, request=request, within=within))
