"""``tandem tasks`` and ``tandem export``: what was asked for and what became of it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, Output, connects
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.tasks import AskHistory, TaskState, TaskStatus

Data = Annotated[
    Path | None,
    typer.Option(
        "--data", metavar="DIR", help="Ledger folder, as given to `tandem up`. Read when no executive runs."
    ),
]
Since = Annotated[
    str,
    typer.Option(
        "--since",
        metavar="WHEN",
        help="Only tasks since then: 2026-11-24, 2026-11-24T08:30, or 90m, 12h, 7d ago.",
    ),
]
ENDLESS: Final = 100_000
"""Columns of a line that is not for a terminal."""
States = Annotated[
    list[str] | None, typer.Option("--state", metavar="STATE", help="Only tasks in these states.")
]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("tasks")(connects(tasks))
    app.command("export")(connects(export))


def tasks(
    *,
    everything: Annotated[bool, typer.Option("--all", help="Include all tasks in the ledger.")] = False,
    state: States = None,
    since: Since = "",
    as_json: Json = False,
    data: Data = None,
    bus: BusOptions,
) -> None:
    """List recent tasks, oldest first. Use --all to include all tasks in the ledger."""
    from tandem.executive.cli.commands.history_command import lately, of_ledger  # noqa: PLC0415
    from tandem.executive.cli.shapes import Tasks, print_json  # noqa: PLC0415

    older = everything or state or since
    found = of_ledger(bus, data, _asked(state, since)) if older else lately(bus, data)
    if as_json:
        print_json(Tasks(tasks=found))
    elif not found:
        typer.echo("no tasks yet; send one with `tandem request`")
    else:
        _print(found)


def export(
    *,
    state: States = None,
    since: Since = "",
    output: Output = None,
    data: Data = None,
    bus: BusOptions,
) -> None:
    """Export the tasks in the ledger as JSON lines, oldest first."""
    from tandem.executive.cli.commands.history_command import of_ledger  # noqa: PLC0415
    from tandem.skills.ports.utc import ISO  # noqa: PLC0415

    found = of_ledger(bus, data, _asked(state, since))
    lines = "".join(f"{status.model_dump_json(context=ISO)}\n" for status in found)
    if output is None:
        typer.echo(lines, nl=False)
        return
    try:
        output.write_text(lines, encoding="utf-8")
    except OSError as error:
        raise CommandError(f"--output {output}: cannot write: {error.strerror}") from error


def _asked(state: Iterable[str] | None, since: str) -> AskHistory:
    from tandem.executive.cli.commands.history_command import LIMIT, moment  # noqa: PLC0415
    from tandem.skills.ports.tasks import AskHistory  # noqa: PLC0415

    states = tuple(_state(each) for each in state or ())
    return AskHistory(states=states, since=moment(since), limit=LIMIT)


def _state(text: str) -> TaskState:
    from tandem.skills.ports.tasks import TaskState  # noqa: PLC0415

    try:
        return TaskState(text.upper())
    except ValueError:
        known = ", ".join(TaskState)
        raise CommandError(f"--state: expected one of {known}; found {text!r}") from None


def _print(found: tuple[TaskStatus, ...]) -> None:
    from rich.console import Console  # noqa: PLC0415
    from rich.markup import escape  # noqa: PLC0415
    from rich.table import Column, Table  # noqa: PLC0415

    # An id that is cut off is of no use to `tandem cancel`: the other columns give way.
    ids = Column("task", no_wrap=True, min_width=max(len(status.task) for status in found))
    rest = (Column(name, overflow="fold") for name in ("state", "phase", "done", "request", "failure"))
    table = Table(ids, *rest, box=None)
    for status in found:
        table.add_row(
            escape(status.task),
            str(status.state),
            escape(status.progress.phase),
            f"{status.progress.fraction:.0%}",
            escape(_request(status)),
            escape(_remark(status)),
        )
    # In a file or a pipe there is no width: a line for each task.
    console = Console() if Console().is_terminal else Console(width=ENDLESS)
    console.print(table, crop=False)


def _request(status: TaskStatus) -> str:
    import json  # noqa: PLC0415

    return json.dumps({name: value for name, value in status.request.items() if name not in {"task", "id"}})


def _remark(status: TaskStatus) -> str:
    if status.question is not None:
        return f"asks: {status.question.text} ({' or '.join(status.question.choices)})"
    if status.failure is not None:
        return f"{status.failure.kind}: {status.failure.message}"
    return f"waiting for {status.waits_for}" if status.waits_for else ""
