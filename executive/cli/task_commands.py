"""``tandem tasks``, and the verbs: ``cancel``, ``pause``, ``resume``, ``step``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from executive.cli.arguments import As, Connect, Keys, Robot, SiteKey, bus_options
from executive.cli.errors import CommandError
from executive.cli.exit_codes import ExitCode
from executive.options import DEFAULT_ENDPOINT, DEFAULT_ROBOT, DEFAULT_SITE

if TYPE_CHECKING:
    from executive.options import BusOptions
    from skills.ports.keys import Service
    from skills.ports.tasks import ControlAnswer, NameTask, TaskStatus

RunningTask = Annotated[
    str, typer.Argument(metavar="[ID]", help="As `tandem tasks` tells it; the running one unless given.")
]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("tasks")(tasks)
    app.command("cancel")(cancel)
    app.command("pause")(pause)
    app.command("resume")(resume)
    app.command("step")(step)


def tasks(
    as_json: Annotated[bool, typer.Option("--json", help="As the executive's answer.")] = False,  # noqa: FBT002
    *,
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
    keys: Keys = None,
    holder: As = "",
) -> None:
    """List the tasks that the executive remembers, oldest first."""
    from executive.cli.connection import Connection  # noqa: PLC0415
    from skills.ports.keys import Nothing  # noqa: PLC0415
    from skills.ports.tasks import TASK_LIST  # noqa: PLC0415

    with Connection(bus_options(connect, site_key, robot, keys, holder)) as connection:
        answer = connection.ask(TASK_LIST, Nothing())
    if as_json:
        typer.echo(answer.model_dump_json(indent=2))
    elif not answer.tasks:
        typer.echo("no task yet; ask for one with `tandem request`")
    else:
        _print(answer.tasks)


def cancel(
    task: Annotated[str, typer.Argument(metavar="ID", help="As `tandem tasks` tells it.")],
    *,
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
    keys: Keys = None,
    holder: As = "",
) -> None:
    """Cancel a queued or a running task; the robot stops at once, safely."""
    from executive.cli.connection import Connection  # noqa: PLC0415
    from skills.ports.tasks import TASK_CANCEL, CancelTask  # noqa: PLC0415

    with Connection(bus_options(connect, site_key, robot, keys, holder)) as connection:
        asked = CancelTask(task=task).model_dump_json().encode()
        answer = connection.answer(connection.cancel_key(), asked, TASK_CANCEL.answered)
    if not answer.accepted:
        raise CommandError(f"{task} can't be cancelled: {answer.reason}", ExitCode.BAD_INPUT)
    typer.echo(f"{task} is being cancelled")


def pause(
    task: RunningTask = "",
    *,
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
    keys: Keys = None,
    holder: As = "",
) -> None:
    """Have the running task's skills come to rest and its tree stay where it is."""
    from skills.ports.tasks import TASK_PAUSE  # noqa: PLC0415

    named = _verb(TASK_PAUSE, task, bus_options(connect, site_key, robot, keys, holder), "paused")
    typer.echo(f"{named} is being paused; `tandem resume` goes on, `tandem step` by one leaf")


def resume(
    task: RunningTask = "",
    *,
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
    keys: Keys = None,
    holder: As = "",
) -> None:
    """Go on with a paused task."""
    from skills.ports.tasks import TASK_RESUME  # noqa: PLC0415

    typer.echo(
        f"{_verb(TASK_RESUME, task, bus_options(connect, site_key, robot, keys, holder), 'resumed')} goes on"
    )


def step(
    task: RunningTask = "",
    *,
    connect: Connect = DEFAULT_ENDPOINT,
    site_key: SiteKey = DEFAULT_SITE,
    robot: Robot = DEFAULT_ROBOT,
    keys: Keys = None,
    holder: As = "",
) -> None:
    """Go on with a paused task until one more leaf of its tree has ended."""
    from skills.ports.tasks import TASK_STEP  # noqa: PLC0415

    named = _verb(TASK_STEP, task, bus_options(connect, site_key, robot, keys, holder), "stepped")
    typer.echo(f"{named} goes on by one leaf")


def _verb(service: Service[NameTask, ControlAnswer], task: str, options: BusOptions, participle: str) -> str:
    """Ask for it; return the task's id."""
    from executive.cli.connection import Connection  # noqa: PLC0415
    from skills.ports.keys import Nothing  # noqa: PLC0415
    from skills.ports.tasks import TASK_INFO, NameTask  # noqa: PLC0415

    with Connection(options) as connection:
        named = task or connection.ask(TASK_INFO, Nothing()).running
        if not named:
            raise CommandError("no task is running", ExitCode.BAD_INPUT)
        answer = connection.ask(service, NameTask(task=named))
    if not answer.accepted:
        raise CommandError(f"{named} can't be {participle}: {answer.reason}", ExitCode.BAD_INPUT)
    return named


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
