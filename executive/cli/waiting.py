"""Wait for a task's end. Silence is no end: a wait outlives a restart of the executive."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Final

import typer
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from tandem.executive.cli.connection import Connection
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import TASK_HISTORY, AskHistory, TaskStatus

ASK_EVERY: Final = 2.0
"""Seconds of silence after which the task's status is asked for: one may have been lost with a lost link."""
SAY_AFTER: Final = 5.0
"""Seconds of silence that are worth a word. An executive is asked every 2 s and starts again within one."""


@dataclass
class Silence:
    """Since when nothing has been heard, on the host's monotonic clock and as people read it."""

    since: float = field(default_factory=time.monotonic)
    at: str = field(default_factory=lambda: time.strftime("%H:%M:%S"))
    said: bool = False

    @property
    def seconds(self) -> float:
        """How long it lasts."""
        return time.monotonic() - self.since

    @property
    def words(self) -> str:
        """It in words; empty when it is too short to matter."""
        return f"no news since {self.at}" if self.seconds > SAY_AFTER else ""


class Waiting:
    """Follows one task to its end.

    Args:
        connection: an open bus.
        task: the task's id.
        statuses: what has been published since before the task was asked for.
    """

    def __init__(self, connection: Connection, task: str, statuses: Latest[TaskStatus]) -> None:
        self._connection, self._task, self._statuses = connection, task, statuses
        self._silence = Silence()
        self._asked_at = time.monotonic()
        self._pending: Pending | None = None
        console = Console(stderr=True)
        columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
        self._quiet = not console.is_terminal
        self._progress = Progress(*columns, console=console, transient=True, disable=self._quiet)
        self._shown = "queued"

    def end(self) -> TaskStatus:
        """Return the task's last status, however long that takes.

        Raises:
            CommandError: TASK_FAILED when the executive answers, and no longer knows the task.
        """
        try:
            with self._progress as progress:
                bar = progress.add_task(self._shown, total=1.0)
                while True:
                    self._connection.bus.waker.wait(0.2)
                    for status in self._news():
                        self._shown = _words(status)
                        progress.update(bar, completed=status.progress.fraction)
                        if status.state.terminal:
                            return status
                    self._say_silence()
                    progress.update(
                        bar, description=": ".join(filter(None, (self._shown, self._silence.words)))
                    )
        except KeyboardInterrupt:
            typer.echo(
                f"{self._task} is still running; cancel it with `tandem cancel {self._task}`", err=True
            )
            raise

    def _news(self) -> list[TaskStatus]:
        news = [each for each in self._statuses.take() if each.task == self._task] or self._answered()
        if news:
            if self._silence.said:
                typer.echo("the executive is back", err=True)
            self._silence = Silence()
        return news

    def _answered(self) -> list[TaskStatus]:
        """Ask how the task stands when nothing has come for a while, and return what is answered."""
        now = time.monotonic()
        if self._pending is None:
            if now - max(self._asked_at, self._silence.since) > ASK_EVERY:
                self._asked_at = now
                bus = self._connection.bus
                self._pending = TASK_HISTORY.query(
                    bus, AskHistory(task=self._task, limit=1), timeout=ASK_EVERY
                )
            return []
        answer = self._pending.poll()
        if answer is None and not self._pending.done() and now - self._asked_at < ASK_EVERY:
            return []
        self._pending = None
        if answer is None:
            return []
        found = TASK_HISTORY.decode_answer(answer).tasks
        if not found:
            raise CommandError(f"the executive no longer knows {self._task}", ExitCode.TASK_FAILED)
        return list(found)

    def _say_silence(self) -> None:
        if self._quiet and self._silence.words and not self._silence.said:
            self._silence.said = True
            typer.echo(f"{self._silence.words}; still waiting for {self._task}", err=True)


def _words(status: TaskStatus) -> str:
    phase = f"waiting for {status.waits_for}" if status.waits_for else status.progress.phase
    return f"{status.state} {phase}".rstrip()
