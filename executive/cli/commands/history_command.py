"""The history: asked of the executive; when none runs, read from the file, under the owner's lock."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from tandem.executive.cli.connection import Connection
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.client.pages import listed
from tandem.executive.config.run_options import BusOptions, default_data
from tandem.executive.ledger.port import LedgerError, LedgerLockedError
from tandem.executive.ledger.sqlite import FILE, SqliteLedger
from tandem.skills.ports.tasks import PAGE, TASK_HISTORY, TASK_LIST, AskHistory, History, TaskStatus

LIMIT: Final = PAGE
"""Tasks of one question."""
LATELY: Final = 50
"""Tasks that are listed without --all when the file is read."""
_AGO: Final = re.compile(r"(\d+)([mhd])")
_SECONDS: Final = {"m": 60.0, "h": 3600.0, "d": 86_400.0}


def lately(options: BusOptions, data: Path | None) -> tuple[TaskStatus, ...]:
    """Return the tasks that the executive has in memory; without one the newest of the file."""
    try:
        with Connection(options) as connection:
            return listed(lambda each: connection.ask(TASK_LIST, each))
    except CommandError as nobody:
        _only_absence(nobody)
        with_file = _file(options, data, nobody)
    try:
        return tuple(reversed(with_file.history(AskHistory(limit=LATELY)).tasks))
    finally:
        with_file.close()


def of_ledger(options: BusOptions, data: Path | None, asked: AskHistory) -> tuple[TaskStatus, ...]:
    """Return all tasks that were asked for, oldest first.

    Raises:
        CommandError: NOBODY_THERE when there is neither executive nor file.
    """
    try:
        with Connection(options) as connection:
            return _all(lambda each: connection.ask(TASK_HISTORY, each), asked)
    except CommandError as nobody:
        _only_absence(nobody)
        with_file = _file(options, data, nobody)
    try:
        return _all(with_file.history, asked)
    finally:
        with_file.close()


def moment(text: str) -> float:
    """Return UTC seconds of what ``--since`` says; 0 for nothing."""
    if not text:
        return 0.0
    ago = _AGO.fullmatch(text)
    if ago is not None:
        return time.time() - float(ago[1]) * _SECONDS[ago[2]]
    try:
        said = datetime.fromisoformat(text)
    except ValueError:
        raise CommandError(
            f"--since: expected a date such as 2026-11-24, a time such as 2026-11-24T08:30, or 90m, 12h, 7d; "
            f"found {text!r}"
        ) from None
    return (said if said.tzinfo is not None else said.replace(tzinfo=UTC)).timestamp()


def _all(ask: Callable[[AskHistory], History], asked: AskHistory) -> tuple[TaskStatus, ...]:
    found: list[TaskStatus] = []
    while True:
        answer = ask(asked)
        found += answer.tasks
        if not answer.more:
            return tuple(reversed(found))
        asked = asked.model_copy(update={"before": answer.more})


def _only_absence(error: CommandError) -> None:
    if error.code is not ExitCode.NOBODY_THERE:
        raise error


def _file(options: BusOptions, data: Path | None, nobody: CommandError) -> SqliteLedger:
    folder = data or default_data(options, os.environ)
    if (folder / options.robot / FILE).exists():  # several robots in one world have a folder each
        folder /= options.robot
    if not (folder / FILE).exists():
        raise CommandError(f"{nobody}\nno ledger found in {folder}", ExitCode.NOBODY_THERE)
    try:
        ledger = SqliteLedger(folder)
    except LedgerLockedError as error:
        raise CommandError(f"{nobody}\nbut {error}", ExitCode.NOBODY_THERE) from error
    except LedgerError as error:
        raise CommandError(str(error), ExitCode.UNKEPT) from error
    if data is None and (owner := ledger.owner) not in {None, f"{options.site}/{options.robot}"}:
        ledger.close()  # whoever names a folder means what is in it; nobody has named this one
        raise CommandError(
            f"{nobody}\nand the ledger in {folder} has the tasks of {owner}; name that robot with --site-key"
            " and --robot, or the folder with --data",
            ExitCode.NOBODY_THERE,
        )
    return ledger
