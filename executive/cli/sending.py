"""Send a request, show the answer, and wait for the task's end if that was asked for."""

from __future__ import annotations

import json
import time
import uuid
from typing import Final

import typer
from pydantic import JsonValue
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskID, TextColumn, TimeElapsedColumn

from executive.cli.connection import Connection
from executive.cli.errors import CommandError
from executive.cli.exit_codes import ExitCode
from executive.options import BusOptions
from skills.ports.failure import KINDS, Failure
from skills.ports.keys import Latest, Nothing
from skills.ports.tasks import REQUEST, TASK_LIST, TASK_STATUS, TaskAnswer, TaskState, TaskStatus

ASK_EVERY: Final = 2.0
"""Seconds after which the list is asked for: a status may have been lost with a lost link."""


def send_fields(document: dict[str, JsonValue], options: BusOptions, *, wait: bool) -> None:
    """Send a request that was given by options."""
    send(json.dumps(document).encode(), options, wait=wait)


def send(payload: bytes, options: BusOptions, *, wait: bool) -> None:
    """Send a document; print the task's id, or what is wrong.

    Raises:
        CommandError: BAD_INPUT for a rejected request, NOBODY_THERE, TASK_FAILED with ``wait``.
    """
    with Connection(options) as connection:
        statuses = Latest(connection.bus, TASK_STATUS)
        answer = connection.answer(connection.own(REQUEST), _with_id(payload), TaskAnswer)
        if not answer.accepted:
            raise CommandError(describe_problems(answer))
        connection.require_robot()
        typer.echo(answer.task)
        if wait:
            _end_as(_wait(connection, answer.task, statuses))


def describe_problems(answer: TaskAnswer) -> str:
    """Return what is wrong with a request, a line for each problem."""
    lines = ["the request was rejected:"]
    for problem in answer.problems:
        found = f", found {problem.found}" if problem.found else ""
        lines.append(f"  {problem.path}: expected {problem.expected}{found}")
    return "\n".join(lines)


def describe_failure(failure: Failure, indent: str = "") -> str:
    """Return a failure with its chain: kind, words, evidence, and who can help."""
    facts = KINDS[failure.kind]
    where = f" at {failure.where}" if failure.where else ""
    lines = [f"{indent}{failure.kind}{where}: {failure.message}"]
    if failure.evidence:
        evidence = ", ".join(f"{name} {value}" for name, value in failure.evidence.items())
        lines.append(f"{indent}  evidence: {evidence}")
    again = "may be tried again" if facts.retryable else "is no use to try again"
    lines.append(f"{indent}  {facts.meaning}; {again}; who can help: {facts.helper}")
    lines += [describe_failure(cause, f"{indent}  ") for cause in failure.causes]
    return "\n".join(lines)


def _with_id(payload: bytes) -> bytes:
    """Return the document with an id of ours: asked twice after a lost answer, it is still one request."""
    try:
        document = json.loads(payload)
    except ValueError:
        return payload
    if not isinstance(document, dict) or "id" in document:
        return payload
    # Put in as text: whatever else is wrong with the document, the executive shall see it and say so.
    return payload.replace(b"{", f'{{"id": "{uuid.uuid4().hex}"{", " if document else ""}'.encode(), 1)


def _wait(connection: Connection, task: str, statuses: Latest[TaskStatus]) -> TaskStatus:
    asked_at = time.monotonic()
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    try:
        with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
            bar = progress.add_task("queued", total=1.0)
            while True:
                connection.bus.waker.wait(0.2)
                news = [each for each in statuses.take() if each.task == task]
                if not news and time.monotonic() - asked_at > ASK_EVERY:
                    asked_at = time.monotonic()
                    news = [_ask(connection, task)]
                for status in news:
                    _show(progress, bar, status)
                    if status.state.terminal:
                        return status
    except KeyboardInterrupt:
        typer.echo(f"{task} goes on; stop it with `tandem cancel {task}`", err=True)
        raise


def _ask(connection: Connection, task: str) -> TaskStatus:
    found = [each for each in connection.ask(TASK_LIST, Nothing()).tasks if each.task == task]
    if not found:
        raise CommandError(f"the executive was started anew and has forgotten {task}", ExitCode.TASK_FAILED)
    return found[0]


def _show(progress: Progress, bar: TaskID, status: TaskStatus) -> None:
    phase = f" {status.progress.phase}" if status.progress.phase else ""
    progress.update(bar, completed=status.progress.fraction, description=f"{status.state}{phase}")


def _end_as(status: TaskStatus) -> None:
    took = ""
    if status.started is not None and status.ended is not None and status.started.boot == status.ended.boot:
        took = f" after {status.ended.seconds - status.started.seconds:.1f} s of robot time"
    if status.state is TaskState.SUCCEEDED:
        typer.echo(f"{status.state}{took}")
        return
    why = "" if status.failure is None else f"\n{describe_failure(status.failure, '  ')}"
    raise CommandError(f"{status.task}: {status.state}{took}{why}", ExitCode.TASK_FAILED)
