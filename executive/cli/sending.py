"""Send a request, show the answer, and wait for the task's end if that was asked for."""

from __future__ import annotations

import json
import uuid

import typer
from pydantic import JsonValue

from tandem.executive.cli.connection import Connection
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.shapes import Requested, print_json
from tandem.executive.cli.waiting import Waiting
from tandem.executive.config.run_options import BusOptions
from tandem.executive.render.failure_words import result_lines
from tandem.skills.ports.failure import KINDS, Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.plain_json import read_json
from tandem.skills.ports.problems import in_words
from tandem.skills.ports.tasks import REQUEST, TASK_STATUS, TaskAnswer, TaskState, TaskStatus


def send_fields(
    document: dict[str, JsonValue], options: BusOptions, *, wait: bool, as_json: bool = False
) -> None:
    """Send a request that was given by options."""
    send(json.dumps(document).encode(), options, wait=wait, as_json=as_json)


def send(payload: bytes, options: BusOptions, *, wait: bool, as_json: bool = False) -> None:
    """Send a document; print the task's id, or what is wrong.

    An id that was printed is an accepted request, also when no robot is there yet. With ``as_json`` and
    ``wait`` it is printed to standard error, and the document at the task's end.

    Raises:
        CommandError: BAD_INPUT for a rejected request, REFUSED, NOBODY_THERE, TASK_FAILED with ``wait``.
    """
    with Connection(options) as connection:
        statuses = Latest(connection.bus, TASK_STATUS)
        answer = connection.answer(connection.own(REQUEST), _with_id(payload), TaskAnswer)
        if not answer.accepted:
            raise CommandError(describe_problems(answer))
        # First of all: it is stored, and runs, whatever becomes of this command.
        if wait or not as_json:
            typer.echo(answer.task, err=as_json)
        robot = _robot(connection, answer.task)
        status = Waiting(connection, answer.task, statuses).end() if wait else None
        if as_json:
            told = Requested(task=answer.task, retry_of=_retried(payload), robot=robot, status=status)
            print_json(told)
        if status is not None:
            _end_as(status, silent=as_json)


def _retried(payload: bytes) -> str:
    return str(read_json(payload).get("retry_of", ""))


def _robot(connection: Connection, task: str) -> str | None:
    """Return the robot's name. Say that an accepted task waits for one: it is no error, and runs with it."""
    name = connection.robot_name()
    if name is None:
        typer.echo(
            f"no robot answers on {connection.options.prefix}: {task} is queued and runs when one does; "
            f"cancel it with `tandem cancel {task}`",
            err=True,
        )
    return name


def describe_problems(answer: TaskAnswer) -> str:
    """Return what is wrong with a request, a line for each problem."""
    return "\n".join(
        ("the request was rejected:", *(f"  {in_words((problem,))}" for problem in answer.problems))
    )


def describe_failure(failure: Failure, indent: str = "") -> str:
    """Return a failure with its chain: kind, words, evidence, and who can help."""
    facts = KINDS[failure.kind]
    where = f" at {failure.where}" if failure.where else ""
    lines = [f"{indent}{failure.kind}{where}: {failure.message}"]
    if failure.evidence:
        evidence = ", ".join(f"{name} {value}" for name, value in failure.evidence.items())
        lines.append(f"{indent}  evidence: {evidence}")
    again = "retryable" if facts.retryable else "not retryable"
    lines.append(f"{indent}  {facts.meaning}; {again}; who can help: {facts.helper}")
    lines += [describe_failure(cause, f"{indent}  ") for cause in failure.causes]
    return "\n".join(lines)


def _with_id(payload: bytes) -> bytes:
    """Return the document with an id of ours: asked twice after a lost answer, it is still one request."""
    try:
        document = read_json(payload)
    except ValueError:
        return payload
    if not isinstance(document, dict) or "id" in document:
        return payload
    # Put in as text: whatever else is wrong with the document, the executive shall see it and say so.
    return payload.replace(b"{", f'{{"id": "{uuid.uuid4().hex}"{", " if document else ""}'.encode(), 1)


def _end_as(status: TaskStatus, *, silent: bool) -> None:
    took = ""
    seconds = None if status.started is None or status.ended is None else status.ended.since(status.started)
    if seconds is not None:
        took = f" after {seconds:.1f} s of robot time"
    if status.state is TaskState.SUCCEEDED:
        if not silent:
            typer.echo("\n".join((f"{status.state}{took}", *result_lines(status))))
        return
    why = "" if status.failure is None else f"\n{describe_failure(status.failure, '  ')}"
    found = "".join(f"\n{line}" for line in result_lines(status))
    raise CommandError(f"{status.task}: {status.state}{took}{why}{found}", ExitCode.TASK_FAILED)
