"""``tandem``: the command's parts are put together here. Each command imports what it needs when it runs.

A new command is a module of this folder with an ``add_to(app)`` and its line in ``_parts``.
"""

from __future__ import annotations

import errno
import logging
import os
import sys
from collections.abc import Callable, MutableMapping, Sequence
from pathlib import Path
from typing import Annotated, Final

import typer

from tandem.executive.cli.commands import (
    bench_command,
    campaign_command,
    cancel_command,
    experiment_command,
    hardware_command,
    keys_command,
    log_command,
    logs_command,
    map_command,
    new_command,
    plugins_command,
    reflex_commands,
    replay_command,
    request_command,
    retry_command,
    ros_command,
    run_commands,
    run_task_command,
    scenario_commands,
    schema_command,
    stop_commands,
    task_commands,
    tree_commands,
    verb_commands,
    watch_command,
    web_command,
    why_command,
    zones_command,
)
from tandem.executive.cli.commands import doctor_command as doctor
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import MEANINGS, ExitCode
from tandem.executive.cli.logs import LogOptions
from tandem.executive.config.extras import words_on_module
from tandem.executive.config.log_format import LogFormat
from tandem.executive.system.quiet_screen import Screen
from tandem.skills.ports.isolation import isolate_children
from tandem.skills.ports.sources import DocumentError
from tandem.skills.wire.threads import few_threads

PROJECT: Final = "tandem.yaml"
NARROWEST: Final = 20
"""Columns: help has names of options of 16 characters; below that no line of it can be read."""
UNWRITTEN: Final = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO})
"""What a write to standard output may end with, once it leads to a file."""
_LOG = logging.getLogger(__name__)

_parts: Final[tuple[Callable[[typer.Typer], None], ...]] = (
    run_commands.add_to,
    run_task_command.add_to,
    request_command.add_to,
    task_commands.add_to,
    cancel_command.add_to,
    retry_command.add_to,
    verb_commands.add_to,
    stop_commands.add_to,
    reflex_commands.add_to,
    map_command.add_to,
    logs_command.add_to,
    log_command.add_to,
    replay_command.add_to,
    watch_command.add_to,
    web_command.add_to,
    why_command.add_to,
    tree_commands.add_to,
    scenario_commands.add_to,
    schema_command.add_to,
    zones_command.add_to,
    campaign_command.add_to,
    experiment_command.add_to,
    bench_command.add_to,
    keys_command.add_to,
    hardware_command.add_to,
    ros_command.add_to,
    new_command.add_to,
    plugins_command.add_to,
    doctor.add_to,
)


def build() -> typer.Typer:
    """Return the command."""
    codes = "  ".join(f"{code.value}: {MEANINGS[code]}." for code in ExitCode)
    app = typer.Typer(
        name="tandem",
        help="A task executive for mobile, two-armed robots.",
        epilog=f"Exit codes: {codes}",
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback()(_common)
    for add_to in _parts:
        add_to(app)
    return app


def main(argv: Sequence[str], screen: Screen | None = None) -> int:
    """Carry the command out and return its exit code. The user sees words, and no trace.

    Args:
        argv: the words after the command's name.
        screen: what the words of libraries are kept from; None in a process that has other uses.
    """
    try:
        build()(args=list(argv), prog_name="tandem", obj=screen)
    except (CommandError, DocumentError) as error:
        _say(f"error: {error}")
        return int(error.code if isinstance(error, CommandError) else ExitCode.BAD_INPUT)
    except SystemExit as end:
        return _code_of(end)
    except KeyboardInterrupt:
        return int(ExitCode.INTERRUPTED)
    except BrokenPipeError:
        # Whoever read our output (head, less) has seen enough.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return int(ExitCode.OK)
    except Exception as error:  # noqa: BLE001 - the last one who can say it in words
        return int(_tell_of(error))
    return int(ExitCode.OK)


def run() -> None:
    """The entry point."""
    isolate_children(os.environ)
    few_threads(os.environ)
    usable_width(os.environ)
    code = main(sys.argv[1:], Screen())
    sys.exit(_said_all(code))


def usable_width(environment: MutableMapping[str, str]) -> None:
    """Forget a width in which nothing can be said: with COLUMNS=0, as in some CI runners, help is empty."""
    told = environment.get("COLUMNS", "")
    if told and not (told.isascii() and told.isdecimal() and int(told[:9]) >= NARROWEST):
        del environment["COLUMNS"]


def _said_all(code: int) -> int:
    """Write what is still to be written; return the exit code, which is another one if that fails."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        return code or int(_unwritten(error))
    return code


def _code_of(end: SystemExit) -> int:
    if isinstance(end.__context__, BrokenPipeError):  # typer and rich end so when nobody reads on, with 1
        return int(ExitCode.OK)
    return end.code if isinstance(end.code, int) else int(end.code is not None)


def _unwritten(error: OSError) -> ExitCode:
    # What is left of the output goes nowhere: Python flushes once more at its end, and would complain.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    _say(f"error: cannot write the output: {error.strerror}")
    return ExitCode.BAD_INPUT


def _print_version(wanted: bool) -> None:  # noqa: FBT001 - as typer calls it
    if wanted:
        from importlib.metadata import version  # noqa: PLC0415

        typer.echo(f"tandem {version('tandem-executive')}")
        raise typer.Exit


def _common(
    context: typer.Context,
    *,
    log: Annotated[Path | None, typer.Option("--log", help="Write the log to this file.")] = None,
    verbose: Annotated[
        bool, typer.Option("--verbose", "-v", help="Write the log to standard error.")
    ] = False,
    log_format: Annotated[
        LogFormat, typer.Option("--log-format", help="Format of the log: plain text, or JSON lines.")
    ] = "text",
    project: Annotated[
        Path | None,
        typer.Option(
            "--project",
            metavar="DIR|FILE",
            help="Folder with a tandem.yaml, or such a file. Default: the current folder's, if it has one.",
        ),
    ] = None,
    version: Annotated[  # noqa: ARG001 - its callback does the work
        bool,
        typer.Option("--version", help="Print the version and exit.", is_eager=True, callback=_print_version),
    ] = False,
) -> None:
    logs, screen = LogOptions(log, verbose, log_format), context.find_object(Screen)
    logs.apply()
    if screen is not None:
        screen.lead_to(log, verbose=verbose)
    context.obj = logs
    if project is not None or Path(PROJECT).is_file():
        from tandem.executive.cli.defaults import defaults  # noqa: PLC0415 - most commands need none
        from tandem.executive.config.project import find_project, read_project  # noqa: PLC0415

        file = find_project(project, Path(PROJECT))
        context.default_map = defaults(context.command, read_project(file))


def _tell_of(error: Exception) -> ExitCode:
    """Say what nobody expected: that an extra is missing, or that there is a bug."""
    lacks = words_on_module(error, "this command") if isinstance(error, ModuleNotFoundError) else ""
    if isinstance(error, OSError) and error.errno in UNWRITTEN and not error.filename:
        return _unwritten(error)
    if lacks:
        _LOG.error("%s", lacks)
        _say(f"error: {lacks}")
        return ExitCode.BAD_INPUT
    _LOG.error("the command failed with an unexpected error", exc_info=error)
    _say(f"error: {type(error).__name__}: {error}\nThis is a bug in tandem; for the traceback run "
         "`tandem -v ...` or `tandem --log FILE ...`.")  # fmt: skip
    return ExitCode.BUG


def _say(text: str) -> None:
    sys.stdout.flush()
    typer.secho(text, err=True, fg=typer.colors.RED if sys.stderr.isatty() else None)
