"""``tandem cancel``: one task, or all that have not ended."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.completing import open_tasks
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tandem.executive.cli.connection import Connection
    from tandem.skills.ports.tasks import ControlAnswer, TaskStatus


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("cancel")(connects(cancel))


def cancel(
    task: Annotated[
        str, typer.Argument(metavar="[ID]", help="Task id, as in `tandem tasks`.", autocompletion=open_tasks)
    ] = "",
    *,
    everything: Annotated[
        bool,
        typer.Option("--all", help="Cancel every task that has not ended; with a requester's key, its own."),
    ] = False,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Cancel a queued or running task, or with --all every one. The robot comes to rest first."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import Cancelled, print_json  # noqa: PLC0415

    if bool(task) == everything:
        raise CommandError("expected the ID of a task, or --all; see `tandem tasks`")
    with Connection(bus) as connection:
        connection.require_right(connection.cancel_key())
        named = not_ended(connection) if everything else (task,)
        answers = {each: _cancel(connection, each) for each in named}
    refused = tuple(f"{each}: {answer.reason}" for each, answer in answers.items() if not answer.accepted)
    done = tuple(each for each, answer in answers.items() if answer.accepted)
    if as_json:
        print_json(Cancelled(tasks=done, refused=refused))
    else:
        for each in done:
            typer.echo(f"cancelling {each}")
        if everything and not named:
            typer.echo("no task is queued or running")
    if refused and everything:
        raise CommandError("\n".join(("not cancelled:", *(f"  {each}" for each in refused))))
    if refused:
        raise CommandError(f"{task} cannot be cancelled: {answers[task].reason}")


def not_ended(connection: Connection) -> tuple[str, ...]:
    """Return the tasks to cancel: those that wait before the one that runs, so that none begins meanwhile."""
    from tandem.executive.client.pages import listed  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_LIST  # noqa: PLC0415

    tasks = listed(lambda each: connection.ask(TASK_LIST, each))
    return tuple(each.task for each in in_order(tasks) if connection.owns(each.request))


def in_order(tasks: Iterable[TaskStatus]) -> list[TaskStatus]:
    """Return the tasks that have not ended: first those that have not begun, the newest first."""
    newest = [each for each in tuple(tasks)[::-1] if not each.state.terminal]
    return sorted(newest, key=lambda each: each.started is not None)


def _cancel(connection: Connection, task: str) -> ControlAnswer:
    from dataclasses import replace  # noqa: PLC0415

    from tandem.skills.ports.tasks import TASK_CANCEL, CancelTask  # noqa: PLC0415

    return connection.ask(replace(TASK_CANCEL, key=connection.cancel_key()), CancelTask(task=task))
