"""``tandem request KIND``: a command for each kind of task that the robot offers, from its JSON Schema."""

from __future__ import annotations

import inspect
import uuid
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer
from typer.core import TyperCommand

from tandem.executive.cli.arguments import Json, connects, give_parameters, shared_options, shared_parameters
from tandem.executive.cli.completing import WITHIN
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.kinds import kinds_of_robot
from tandem.executive.cli.kinds_group import KindsGroup, single
from tandem.executive.cli.schema_options import fields_of, read_given
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.tasks import KindOfTask

ANY_KIND: Final = ("KIND", "Send a request for a task of this kind; kinds and options come from the robot.")
"""How the pages name the commands that only the robot knows, and what they do."""
HELP: Final = (
    "Send a request to the robot. KIND is a kind of task that the robot offers: this help lists them "
    "while it answers, and `tandem request KIND --help` has the options of one."
)


class RobotsKinds(KindsGroup):
    """The kinds are those that the robot offers which the other words name."""

    unknown: ClassVar[str] = "the robot offers no task {name!r}; it offers {known}"

    def kinds(
        self, words: Sequence[str], defaults: Mapping[str, object], *, quick: bool
    ) -> Iterable[TyperCommand]:
        """Ask the robot."""
        offered = kinds_of_robot(shared_options(words, defaults), within=WITHIN if quick else None)
        return [command_of(kind) for kind in offered]


def add_to(app: typer.Typer) -> None:
    """Add the group."""
    group = typer.Typer(cls=RobotsKinds, help=HELP, no_args_is_help=True)
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
    fields = fields_of(kind.request, beside=(*_OWN, *shared_parameters()))

    def command(*, wait: bool, as_json: bool, bus: BusOptions, **given: object) -> None:
        from tandem.executive.cli.sending import send_fields  # noqa: PLC0415

        document = {"task": kind.name, "id": uuid.uuid4().hex, **read_given(fields, given)}
        send_fields(document, bus, wait=wait, as_json=as_json)

    give_parameters(command, [*(field.as_parameter() for field in fields), *_OWN])
    return single(kind.name, kind.summary, connects(command))
