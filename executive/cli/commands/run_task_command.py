"""``tandem run KIND``: start everything, carry out one request, and stop everything."""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final

import typer
from typer.core import TyperCommand

from tandem.executive.cli.arguments import Json, give_parameters
from tandem.executive.cli.commands.request_command import read_document
from tandem.executive.cli.kinds_group import KindsGroup, single
from tandem.executive.cli.schema_options import fields_of, read_given
from tandem.executive.cli.system_options import starts_system, system_parameters
from tandem.executive.config.run_options import RunOptions

if TYPE_CHECKING:
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
_WITHIN: Final = inspect.Parameter("within", inspect.Parameter.KEYWORD_ONLY, default=900.0, annotation=Within)
_JSON: Final = inspect.Parameter("as_json", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=Json)
_SYSTEM: Final = inspect.Parameter("options", inspect.Parameter.KEYWORD_ONLY, annotation=RunOptions)


class InstalledKinds(KindsGroup):
    """The kinds are those that are installed here."""

    def kinds(
        self, words: Sequence[str], defaults: Mapping[str, object], *, quick: bool
    ) -> Iterable[TyperCommand]:
        """Look them up."""
        from tandem.trees.registry import discover  # noqa: PLC0415 - takes a moment

        del words, defaults, quick
        return [command_of(kind) for kind in discover().values()]


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(cls=InstalledKinds, help=HELP, no_args_is_help=True)
    group.command("json")(starts_system(from_json))
    app.add_typer(group, name="run", subcommand_metavar="KIND|json [OPTIONS]...")


def from_json(
    document: Document, *, within: Within = 900.0, as_json: Json = False, options: RunOptions
) -> None:
    """Start everything, carry out a JSON request, and stop everything."""
    request = read_document(document).decode("utf-8", "replace")
    raise typer.Exit(_run(replace(options, request=request, within=within, as_json=as_json)))


def command_of(kind: TaskType[Message]) -> TyperCommand:
    """Return a command with an option for each field."""
    fields = fields_of(kind.request.model_json_schema(), beside=(_WITHIN, _JSON, *system_parameters()))

    def command(*, within: float, as_json: bool, options: RunOptions, **given: object) -> None:
        request = json.dumps({"task": kind.name, **read_given(fields, given)})
        raise typer.Exit(_run(replace(options, request=request, within=within, as_json=as_json)))

    give_parameters(command, [*(field.as_parameter() for field in fields), _WITHIN, _JSON, _SYSTEM])
    return single(kind.name, kind.summary, starts_system(command))


def _run(options: RunOptions) -> int:
    from tandem.executive.cli.running_system import run_once  # noqa: PLC0415 - loads the whole system

    return run_once(options)
