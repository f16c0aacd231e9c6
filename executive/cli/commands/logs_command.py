"""``tandem logs``: what the processes of ``tandem up`` on this host have logged, or what became of a task."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.completing import logged
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions, default_data

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from tandem.executive.telemetry.log_reading import LogLine
    from tandem.skills.ports.tasks import TaskStatus

LOOKS: Final = 0.2
"""Seconds between two looks at the files with ``--follow``."""


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("logs")(connects(logs))


def logs(
    about: Annotated[
        str,
        typer.Argument(
            metavar="[ROLE|ID]",
            help="A process such as base, or a task's id. Default: all processes.",
            autocompletion=logged,
        ),
    ] = "",
    *,
    follow: Annotated[
        bool, typer.Option("--follow", "-f", help="Go on as the logs grow, until Ctrl-C.")
    ] = False,
    lines: Annotated[int, typer.Option("--lines", "-n", min=0, help="Lines of what is there already.")] = 200,
    data: Annotated[
        Path | None,
        typer.Option("--data", metavar="DIR", help="Folder of the robot's data, as given to `tandem up`."),
    ] = None,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Print the logs of the processes that `tandem up` runs on this host, by role or by task.

    Of a task whose robot runs on another host, what the ledger knows is printed: when it was accepted and
    ended, and each failure on the way.
    """
    from tandem.executive.telemetry.log_reading import FOLDER, LogFolder, roles_in  # noqa: PLC0415

    folder = (data or _own_folder(bus)) / FOLDER
    roles = roles_in(folder)
    if about in roles or not about:
        if not roles:
            raise CommandError(f"no logs in {folder}; `tandem up` writes them, --data names its folder")
        found = LogFolder(folder, lambda line: about in {"", line.role})
    else:
        found = LogFolder(folder, lambda line: line.task == about)
    begun = found.first(lines)
    if about and about not in roles and not begun:
        status = _in_ledger(bus, data, about, roles)
        if status.task != about:  # the client's own id of its request; the logs name the task's
            found = LogFolder(folder, lambda line: line.task == status.task)
            begun = found.first(lines)
        if not begun:
            _print(_events(status), as_json=as_json)
            if not (follow and roles):
                return
    _print(begun, as_json=as_json)
    while follow:
        time.sleep(LOOKS)
        _print(found.more(), as_json=as_json)


def _print(lines: Iterable[LogLine], *, as_json: bool) -> None:
    from tandem.executive.cli.shapes import print_json  # noqa: PLC0415

    for line in lines:
        if as_json:
            print_json(line, line=True)
        else:
            typer.echo(line.text)


def _own_folder(bus: BusOptions) -> Path:
    """Return the default folder of a robot's data.

    Raises:
        CommandError: NOBODY_THERE when another robot has it: c at a-b and b-c at a have one folder.
    """
    from tandem.executive.ledger.sqlite import owner_of  # noqa: PLC0415

    folder, robot = default_data(bus, os.environ), bus.prefix
    owner = owner_of(folder)
    if owner not in {None, robot}:
        raise CommandError(
            f"{folder} has the logs of {owner}, not of {robot}; name that robot with --site-key and --robot, "
            "or the folder with --data",
            ExitCode.NOBODY_THERE,
        )
    return folder


def _in_ledger(bus: BusOptions, data: Path | None, task: str, roles: tuple[str, ...]) -> TaskStatus:
    """Return what the ledger knows of a task.

    Raises:
        CommandError: when there is no such task, and no such role.
    """
    from tandem.executive.cli.commands.history_command import of_ledger  # noqa: PLC0415
    from tandem.executive.render.failure_words import chosen  # noqa: PLC0415
    from tandem.skills.ports.tasks import AskHistory  # noqa: PLC0415

    known = chosen(of_ledger(bus, data, AskHistory(task=task)), task)
    if known is None:
        processes = f"; the processes with a log are {', '.join(roles)}" if roles else ""
        raise CommandError(f"neither a process nor a task is called {task!r}{processes}")
    return known


def _events(status: TaskStatus) -> Iterator[LogLine]:
    from tandem.executive.telemetry.log_reading import LogLine  # noqa: PLC0415
    from tandem.skills.ports.utc import iso  # noqa: PLC0415

    def line(at: float | None, level: str, words: str) -> LogLine:
        when = "" if at is None else iso(at)
        text = f"{when or ' ' * 20} {level.upper():<7} executive {words} task={status.task}"
        return LogLine(time=when, level=level, role="executive", task=status.task, text=text)

    yield line(status.accepted_at, "info", "accepted")
    for each in status.tried:
        then = f"; then {each.recovery} ({each.times})" if each.recovery else ""
        yield line(
            None, "warning", f"{each.failure.kind} at {each.failure.where}: {each.failure.message}{then}"
        )
    if status.state.terminal:
        why = "" if status.failure is None else f": {status.failure.kind}: {status.failure.message}"
        level = "info" if status.failure is None else "warning"
        yield line(status.ended_at, level, f"ended {status.state}{why}")
    else:
        yield line(None, "info", f"is {status.state}")
