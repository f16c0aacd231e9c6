"""``tandem retry``: the same request anew, as a task of its own that refers to the first."""

from __future__ import annotations

import uuid
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.commands.request_command import Wait
from tandem.executive.cli.completing import ended_tasks
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from pydantic import JsonValue

    from tandem.skills.ports.tasks import TaskStatus

OF_THE_FIRST: Final = ("id", "by", "not_before", "expires", "retry_of")
"""Fields of a request that belong to that one request: who sent it, and the times that it was meant for."""


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("retry")(connects(retry))


def retry(
    task: Annotated[
        str, typer.Argument(metavar="ID", help="Id of a task that has ended.", autocompletion=ended_tasks)
    ],
    *,
    wait: Wait = False,
    data: Annotated[
        Path | None,
        typer.Option("--data", metavar="DIR", help="Folder of the ledger, as given to `tandem up`."),
    ] = None,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Send the request of an ended task again, as a new task that refers to it (`retry_of`).

    Everything in it stays as it was, but its earliest and latest start, which were meant for then.
    """
    from tandem.executive.cli.commands.history_command import of_ledger  # noqa: PLC0415
    from tandem.executive.cli.sending import send_fields  # noqa: PLC0415
    from tandem.executive.render.failure_words import chosen  # noqa: PLC0415
    from tandem.skills.ports.tasks import AskHistory  # noqa: PLC0415

    known = chosen(of_ledger(bus, data, AskHistory(task=task)), task) if task else None
    if known is None:
        raise CommandError(f"unknown task {task!r}; see `tandem tasks --all`")
    send_fields(document_of(known), bus, wait=wait, as_json=as_json)


def document_of(status: TaskStatus) -> dict[str, JsonValue]:
    """Return the request that repeats a task's.

    Raises:
        CommandError: when the task has not ended.
    """
    if not status.state.terminal:
        raise CommandError(f"{status.task} is {status.state}; only a task that has ended can be retried")
    kept = {name: value for name, value in status.request.items() if name not in OF_THE_FIRST}
    return {**kept, "id": uuid.uuid4().hex, "retry_of": status.task}
