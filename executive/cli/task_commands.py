"""``tandem tasks`` and ``tandem cancel``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from executive.cli.arguments import Connect, Robot, SiteKey, bus_options
from executive.cli.errors import CommandError
from executive.cli.exit_codes import ExitCode
from executive.options import DEFAULT_ENDPOINT, DEFAULT_ROBOT, DEFAULT_SITE

if TYPE_CHECKING:
    from skills.ports.tasks import TaskStatus


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("tasks")(tasks)
    app.command("cancel")(cancel)


def tasks(
    as_json: Annotated[bool, typer.Option("--json", help="As the executive's answer.")] = False,  # noqa: FBT002
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
) -> None:
    """List the tasks that the executive remembers, oldest first."""
    from executive.cli.connection import Connection  # noqa: PLC0415
    from skills.ports.keys import Nothing  # noqa: PLC0415
    from skills.ports.tasks import TASK_LIST  # noqa: PLC0415

    with Connection(bus_options(connect, site_key, robot)) as connection:
        answer = connection.ask(TASK_LIST, Nothing())
    if as_json:
        typer.echo(answer.model_dump_json(indent=2))
    elif not answer.tasks:
        typer.echo("no task yet; ask for one with `tandem request`")
    else:
        _print(answer.tasks)


def cancel(
    task: Annotated[str, typer.Argument(metavar="ID", help="As `tandem tasks` tells it.")],
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
) -> None:
    """Cancel a queued or a running task; the robot stops at once, safely."""
    from executive.cli.connection import Connection  # noqa: PLC0415
    from skills.ports.tasks import TASK_CANCEL, CancelTask  # noqa: PLC0415

    with Connection(bus_options(connect, site_key, robot)) as connection:
        answer = connection.ask(TASK_CANCEL, CancelTask(task=task))
    if not answer.accepted:
        raise CommandError(f"{task} can't be cancelled: {answer.reason}", ExitCode.BAD_INPUT)
    typer.echo(f"{task} is being cancelled")


def _print(tasks: tuple[TaskStatus, ...]) -> None:
    import json  # noqa: PLC0415

    from rich.console import Console  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    table = Table("task", "state", "phase", "done", "request", "failure", box=None)
    for status in tasks:
        table.add_row(
            status.task,
            str(status.state),
            status.progress.phase,
            f"{status.progress.fraction:.0%}",
            json.dumps({name: value for name, value in status.request.items() if name not in {"task", "id"}}),
            "" if status.failure is None else f"{status.failure.kind}: {status.failure.message}",
        )
    Console().print(table)
