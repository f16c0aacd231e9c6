"""``tandem why``: why a task failed, what was tried, who can help, and the picture of that moment."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.completing import tasks
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions, default_data

if TYPE_CHECKING:
    from tandem.executive.cli.connection import Connection
    from tandem.executive.cli.shapes import Explained
    from tandem.skills.ports.tasks import TaskStatus


ROBOT_WITHIN: Final = 0.5
"""Host seconds in which a recorder must answer; an idle one takes 0.1."""


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("why")(connects(why))


def why(
    *,
    task: Annotated[
        str,
        typer.Argument(
            metavar="[ID]",
            help="Task id, as in `tandem tasks`. Default: the last task that failed.",
            autocompletion=tasks,
        ),
    ] = "",
    picture: Annotated[
        Path | None,
        typer.Option(
            "--picture", metavar="FILE", help="Save the picture of the last attempt to this JPEG file."
        ),
    ] = None,
    data: Annotated[
        Path | None,
        typer.Option(
            "--data",
            metavar="DIR",
            help="Ledger folder, as given to `tandem up`. Read when no executive runs.",
        ),
    ] = None,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Explain why a task failed, what was tried, and what to do next."""
    from tandem.executive.cli.commands.history_command import lately, of_ledger  # noqa: PLC0415
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import Explained  # noqa: PLC0415
    from tandem.executive.render.failure_words import chosen, explain, last_picture  # noqa: PLC0415
    from tandem.skills.ports.tasks import AskHistory  # noqa: PLC0415

    known = of_ledger(bus, data, AskHistory(task=task)) if task else lately(bus, data)
    status = chosen(known, task)
    if status is None:
        if task:
            raise CommandError(f"unknown task {task!r}; see `tandem tasks --all`", ExitCode.BAD_INPUT)
        words = "no task has failed, and none is running"
        _tell(words, Explained(status=None, words=words), as_json=as_json)
        return
    saved = ""
    if as_json and picture is not None and last_picture(status):
        with Connection(bus) as connection:
            _picture(connection, status, picture)
        saved = str(picture.resolve()) if picture.exists() else ""
    words = explain(status)
    kept = record_of(bus, data, status)
    _tell(words, Explained(status=status, words=words, picture=saved, record=kept), as_json=as_json)
    if as_json:
        return
    typer.echo("")
    if kept:
        typer.echo(f"the last minute before it: {kept}")
        typer.echo(f"  to look at it: tandem replay {kept} --task {status.task}")
    if not last_picture(status):
        typer.echo("no picture of the failure was taken")
        return
    if picture is None:
        typer.echo(f"to save the picture of the failure: tandem why {status.task} --picture FILE")
        return
    # It is kept by the skills, not in the ledger: only this part needs a robot.
    with Connection(bus) as connection:
        typer.echo(_picture(connection, status, picture))


def record_of(bus: BusOptions, data: Path | None, status: TaskStatus) -> str:
    """Return the black box of a task, out of the folder of data on this host, else as its recorder says."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.records.boxes import FOLDER, Boxes  # noqa: PLC0415
    from tandem.skills.ports.records import TASK_RECORDS, AskRecords  # noqa: PLC0415

    if status.failure is None:
        return ""
    found = Boxes((data or default_data(bus, os.environ)) / FOLDER).known(status.task)
    if not found and data is None:
        try:
            with Connection(bus, within=ROBOT_WITHIN) as connection:
                if not connection.allows(TASK_RECORDS.key):
                    return ""
                asked = AskRecords(task=status.task)
                found = connection.ask(TASK_RECORDS, asked, of="recorder").boxes
        except CommandError:
            return ""  # no recorder, or no robot: what is known of the task is told all the same
    return found[0].file if found else ""


def _tell(words: str, facts: Explained, *, as_json: bool) -> None:
    if as_json:
        from tandem.executive.cli.shapes import print_json  # noqa: PLC0415

        print_json(facts)
    else:
        typer.echo(words)


def _picture(connection: Connection, status: TaskStatus, path: Path) -> str:
    """Save the picture and return a sentence about it."""
    from tandem.executive.render.failure_words import last_picture  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_PICTURE, AskPicture  # noqa: PLC0415

    number = last_picture(status)
    asked = AskPicture(task=status.task, picture=number).model_dump_json().encode()
    picture = connection.raw(TASK_PICTURE, asked)
    if not picture:
        return f"picture {number} is no longer available"
    try:
        path.write_bytes(picture)
    except OSError as error:
        raise CommandError(f"--picture {path}: cannot write: {error.strerror}") from error
    return f"picture of the failure: {path.resolve()}"
