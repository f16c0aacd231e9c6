"""``tandem log``: records of a robot as files: what is in one, a part of one, as text, and mended."""

from __future__ import annotations

import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json, Output
from tandem.executive.cli.errors import CommandError

if TYPE_CHECKING:
    from tandem.executive.cli.shapes import LogInfo
    from tandem.executive.records.recording import Recording, Span

File = Annotated[Path, typer.Argument(metavar="FILE", help="A recording (.mcap) or a black box (.jsonl.gz).")]
Files = Annotated[
    list[Path],
    typer.Argument(metavar="FILE...", help="Recordings or black boxes; with --lerobot also folders of them."),
]
To = Annotated[Path | None, typer.Option("--output", "-o", metavar="FILE", help="Name of the new file.")]
AROUND = 2.0
"""Robot seconds that are cut out before a task's start and after its end: as long as a black box goes on."""
RAN = (
    f"The part in which this task ran: from {AROUND:.0f} s before its start to {AROUND:.0f} s after its end."
)
LINES_OF_KEYS = 12
"""Keys that are listed with their sizes, the largest; a robot has about a hundred."""


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(
        help="Look into a record of a robot: a recording, or a black box.", no_args_is_help=True
    )
    group.command("info")(info)
    group.command("cut")(cut)
    group.command("export")(export)
    group.command("recover")(recover)
    app.add_typer(group, name="log")


def info(file: File, *, as_json: Json = False) -> None:
    """Show what a record is of, why it was kept, what it spans and what is in it."""
    from tandem.executive.cli.shapes import LogInfo, print_json  # noqa: PLC0415
    from tandem.executive.records.exporting import counts  # noqa: PLC0415
    from tandem.executive.records.recording import open_recording  # noqa: PLC0415

    record = open_recording(file)
    try:
        told = LogInfo(
            facts=record.facts,
            begin=record.span.begin,
            end=record.span.end,
            size=file.stat().st_size,
            keys=counts(record),
            pictures=sum(1 for _ in record.pictures()),
            attachments=tuple(each.name for each in record.attachments),
        )
    finally:
        record.close()
    if as_json:
        print_json(told)
    else:
        typer.echo(_words(file, told))


def cut(
    file: File,
    *,
    since: Annotated[
        float | None, typer.Option("--from", help="Robot time in seconds at which the part begins.")
    ] = None,
    until: Annotated[
        float | None, typer.Option("--to", help="Robot time in seconds at which it ends.")
    ] = None,
    task: Annotated[str, typer.Option("--task", metavar="ID", help=RAN)] = "",
    output: To = None,
) -> None:
    """Write a part of a record into another file, by robot time or by task."""
    from tandem.executive.records.cutting import cut as cut_out  # noqa: PLC0415
    from tandem.executive.records.recording import Span, open_recording  # noqa: PLC0415

    if not task and since is None and until is None:
        raise CommandError("log cut: expected --task ID, or --from and --to in seconds of robot time")
    record = open_recording(file)
    try:
        part = _part_of(record, task) if task else record.span
        begin = part.begin if since is None else _at(record, since)
        end = part.end if until is None else _at(record, until)
        target = output or _beside(file, task or "part")
        count = cut_out(record, target, Span(begin, end))
    except OSError as error:
        raise _unwritten(error, output or file) from error
    finally:
        record.close()
    typer.echo(f"{target}: {count} messages, {max(0.0, end - begin):.1f} s")


def export(
    files: Files,
    *,
    key: Annotated[
        str, typer.Option("--key", metavar="KEY", help="Only messages of this key; * and ** as on the bus.")
    ] = "**",
    output: Output = None,
    lerobot: Annotated[
        Path | None,
        typer.Option("--lerobot", metavar="DIR", help="Write a LeRobot v3 data set into this new folder."),
    ] = None,
    fps: Annotated[int, typer.Option("--fps", min=1, max=100, help="With --lerobot: frames a second.")] = 10,
    camera: Annotated[
        list[str] | None,
        typer.Option("--camera", metavar="NAME", help="With --lerobot: this camera; may be repeated."),
    ] = None,
    pictures: Annotated[
        bool, typer.Option("--pictures/--no-pictures", help="With --lerobot: with all cameras, or with none.")
    ] = True,
) -> None:
    """Print a record as JSON lines, a message each; with --lerobot write records as a data set.

    In a data set each task that began and ended is an episode, and each leaf that ran a subtask.
    """
    if lerobot is None:
        if camera or not pictures:
            raise CommandError("log export: --camera and --no-pictures go with --lerobot DIR")
        if len(files) > 1 or files[0].is_dir():
            raise CommandError("log export: expected one record; several, or a folder, go with --lerobot DIR")
        _lines(files[0], key, output)
        return
    if key != "**" or output is not None:
        raise CommandError("log export --lerobot DIR: a data set has no --key and no --output")
    if camera and not pictures:
        raise CommandError("log export: expected --camera or --no-pictures, found both")
    from tandem.executive.cli.commands.lerobot_export import write_data_set  # noqa: PLC0415

    cameras = () if not pictures else None if not camera else tuple(dict.fromkeys(camera))
    write_data_set(files, lerobot, fps, cameras)


def _lines(file: Path, key: str, output: Path | None) -> None:
    from tandem.executive.records.exporting import exported  # noqa: PLC0415
    from tandem.executive.records.recording import open_recording  # noqa: PLC0415

    record = open_recording(file)
    try:
        if output is None:
            for line in exported(record, key):
                sys.stdout.write(f"{line}\n")
        else:
            with output.open("w", encoding="utf-8") as made:
                made.writelines(f"{line}\n" for line in exported(record, key))
    except BrokenPipeError:
        raise  # whoever read the output has seen enough
    except OSError as error:
        raise _unwritten(error, output or file) from error
    finally:
        record.close()


def recover(file: File, *, output: To = None) -> None:
    """Write what can be read of a record that was cut into another file."""
    from tandem.executive.records.recovering import recover as mend  # noqa: PLC0415
    from tandem.executive.records.recovering import recovered_name  # noqa: PLC0415

    target = output or recovered_name(file)
    try:
        count = mend(file, target)
    except OSError as error:
        raise _unwritten(error, target) from error
    typer.echo(f"{target}: {count} messages recovered")


def _words(file: Path, told: LogInfo) -> str:
    facts = told.facts
    began = f"{datetime.fromtimestamp(facts.began, UTC):%Y-%m-%d %H:%M:%S} UTC"
    lines = [
        f"{file}: {told.size / 1e6:.1f} MB of {facts.site}/{facts.robot}",
        f"  written by Tandem {facts.release}" + (f", commit {facts.commit[:10]}" if facts.commit else ""),
        f"  scenario {facts.scenario or 'unknown'}, seed {facts.seed}; recorder began {began}",
        f"  spans {told.end - told.begin:.1f} s: {told.begin:.1f} to {told.end:.1f} s of its robot seconds",
    ]
    lines += [f"  kept because {cause.words} at {cause.at:.1f} s" for cause in facts.causes]
    total = sum(each.messages for each in told.keys)
    lines.append(f"  {total} messages of {len(told.keys)} keys, {told.pictures} pictures; the largest keys:")
    largest = sorted(told.keys, key=lambda each: -each.size)[:LINES_OF_KEYS]
    lines += [f"    {each.key:<36} {each.messages:>8}  {each.size / 1e3:>10.1f} kB" for each in largest]
    lines.append(f"  attachments: {', '.join(told.attachments) or 'none'}")
    return "\n".join(lines)


def _part_of(record: Recording, task: str) -> Span:
    from tandem.executive.records.moments import span_of  # noqa: PLC0415
    from tandem.executive.records.recording import Span  # noqa: PLC0415

    found = span_of(record, task)
    if found is None:
        raise CommandError(
            f"{record.path}: no task {task!r} in it; `tandem replay {record.path}` lists those"
        )
    return Span(record.span.clipped(found.begin - AROUND), record.span.clipped(found.end + AROUND))


def _at(record: Recording, seconds: float) -> float:
    from tandem.executive.records.moments import at_of  # noqa: PLC0415

    return at_of(record, seconds)


def _beside(file: Path, word: str) -> Path:
    suffix = ".mcap" if file.suffix == ".mcap" else ".jsonl.gz"
    return file.with_name(f"{file.name.removesuffix(suffix)}.{word}{suffix}")


def _unwritten(error: OSError, path: Path) -> CommandError:
    return CommandError(f"{error.filename or path}: {error.strerror or error}")
