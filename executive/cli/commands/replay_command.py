"""``tandem replay``: what `watch` and `why` would have shown at a moment of a record."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json
from tandem.executive.cli.commands.log_command import File
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.system_options import PAGE_AT

if TYPE_CHECKING:
    from tandem.executive.cli.commands.watch_command import View
    from tandem.executive.records.known import Known
    from tandem.executive.records.moments import Moment
    from tandem.executive.records.recording import Recording
    from tandem.skills.ports.tasks import TaskStatus


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("replay")(replay)


def replay(
    file: File,
    *,
    at: Annotated[
        float | None, typer.Option("--at", metavar="SECONDS", help="Robot time of the moment to show.")
    ] = None,
    task: Annotated[
        str, typer.Option("--task", metavar="ID", help="Show this task; without --at, as it ended.")
    ] = "",
    again: Annotated[
        bool,
        typer.Option("--again", help="Repeat a run in lockstep, up to --at; tell where it differs."),
    ] = False,
    web: Annotated[
        bool, typer.Option("--web", help="Show it on the page, in a browser, until Ctrl-C.")
    ] = False,
    web_at: Annotated[
        str | None,
        typer.Option(
            "--web-at",
            metavar="HOST:PORT",
            help=f"--web at this address, on this host only. Default: {PAGE_AT}.",
        ),
    ] = None,
    as_json: Json = False,
) -> None:
    """List what happened in a record; with --at or --task show the tree and the reasons at that moment."""
    if web or web_at is not None:
        from tandem.executive.cli.commands.web_command import show_record  # noqa: PLC0415

        show_record(file, web_at or PAGE_AT, option="--web-at")
        return
    from tandem.executive.records.recording import open_recording  # noqa: PLC0415

    record = open_recording(file)
    try:
        if again:
            from tandem.executive.cli.commands.run_again import run_again  # noqa: PLC0415

            raise typer.Exit(run_again(record, at))
        if at is None and not task:
            _list(record, as_json=as_json)
        else:
            _show(record, _moment_of(record, at, task), task, as_json=as_json)
    finally:
        record.close()


def _list(record: Recording, *, as_json: bool) -> None:
    from tandem.executive.cli.shapes import Replayed, print_json  # noqa: PLC0415
    from tandem.executive.records.moments import moments  # noqa: PLC0415

    found = moments(record)
    if as_json:
        print_json(Replayed(moments=found))
        return
    for each in found:
        typer.echo(f"{_seconds(each)}  {each.words}")
    if not found:
        typer.echo("nothing began, ended or failed in it")
    typer.echo(f"\nto see a moment: tandem replay {record.path} --at SECONDS")


def _seconds(moment: Moment) -> str:
    return f"{moment.at:9.1f} s" if moment.stamp is None else f"{moment.stamp.seconds:9.1f} s"


def _moment_of(record: Recording, seconds: float | None, task: str) -> float:
    from tandem.executive.records.moments import at_of, span_of  # noqa: PLC0415

    if seconds is not None:
        return at_of(record, seconds)
    span = span_of(record, task)
    if span is None:
        raise CommandError(
            f"{record.path}: no task {task!r} in it; `tandem replay {record.path}` lists those"
        )
    return span.end


def _show(record: Recording, at: float, task: str, *, as_json: bool) -> None:
    from tandem.executive.cli.shapes import Replayed, print_json  # noqa: PLC0415
    from tandem.executive.records.tape import Tape  # noqa: PLC0415
    from tandem.executive.render.failure_words import explain  # noqa: PLC0415

    tape = Tape(record)
    tape.go(at)
    view = view_of(tape.known(), task)
    words = "" if view.status is None else explain(view.status)
    if as_json:
        tree = view.tree if view.tree is not None and view.tree.task else None
        print_json(Replayed(at=at, status=view.status, tree=tree, words=words))
        return
    from rich.console import Console  # noqa: PLC0415

    from tandem.executive.cli.commands.watch_command import picture  # noqa: PLC0415

    Console().print(picture(view, height=10_000))
    if words:
        typer.echo(f"\n{words}")


def view_of(known: Known, task: str = "") -> View:
    """Return what `tandem watch` shows of a moment: the task at work then, or the one asked for."""
    from tandem.executive.cli.commands.watch_command import View  # noqa: PLC0415
    from tandem.executive.records.known import said  # noqa: PLC0415
    from tandem.skills.ports.reflex import PipelineState, pipeline_state  # noqa: PLC0415

    status = _chosen(known.statuses(), task)
    last = known.tree()
    tree = None if status is not None and last.task not in {"", status.task} else last
    pipelines = [
        read
        for each in known.of_keys(pipeline_state("").key)
        if (read := said(PipelineState, each)) is not None
    ]
    held = {each.resource: each for each in pipelines if each.reflex}
    told = None if status is None else known.last[f"task/{status.task}/status"].stamp
    gone = bool(known.alive()) and "executive" not in known.alive()
    return View(status, tree, known.stamp, gone=gone, told=told, held=held)


def _chosen(tasks: tuple[TaskStatus, ...], task: str) -> TaskStatus | None:
    if task:
        found = next((each for each in tasks if each.task == task), None)
        if found is None:
            raise CommandError(f"no task {task!r} at that moment")
        return found
    at_work = [each for each in tasks if not each.state.terminal and each.started is not None]
    return (at_work or list(tasks))[-1] if tasks else None
