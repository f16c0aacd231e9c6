"""The verbs: cancel, pause, resume, step, abandon, reprioritise, answer, break, force."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar, cast

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.keys import Service
    from tandem.skills.ports.message import Message
    from tandem.skills.ports.tasks import ControlAnswer

M = TypeVar("M", bound="Message")
RunningTask = Annotated[
    str, typer.Argument(metavar="[ID]", help="As `tandem tasks` tells it; the running one unless given.")
]
Task = Annotated[str, typer.Argument(metavar="ID", help="As `tandem tasks` tells it.")]
OfTask = Annotated[str, typer.Option("--task", metavar="ID", help="The running one unless given.")]
Node = Annotated[str, typer.Argument(metavar="NODE", help="Its name in the tree, or its path.")]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    for call in (cancel, pause, resume, step, abandon, reprioritise, answer, force):
        app.command(call.__name__)(connects(call))
    app.command("break")(connects(break_at))


def cancel(task: Task, *, bus: BusOptions) -> None:
    """Cancel a queued or a running task: the robot comes to rest, and the task winds down."""
    from tandem.skills.ports.tasks import TASK_CANCEL, CancelTask  # noqa: PLC0415

    _ask(TASK_CANCEL, lambda named: CancelTask(task=named), task, bus, "cancelled")
    typer.echo(f"{task} is being cancelled")


def pause(task: RunningTask = "", *, bus: BusOptions) -> None:
    """Have the running task's skills come to rest and its tree stay where it is."""
    from tandem.skills.ports.tasks import TASK_PAUSE, NameTask  # noqa: PLC0415

    named = _ask(TASK_PAUSE, lambda each: NameTask(task=each), task, bus, "paused")
    typer.echo(f"{named} is being paused; `tandem resume` goes on, `tandem step` by one leaf")


def resume(task: RunningTask = "", *, bus: BusOptions) -> None:
    """Go on with a paused task."""
    from tandem.skills.ports.tasks import TASK_RESUME, NameTask  # noqa: PLC0415

    named = _ask(TASK_RESUME, lambda each: NameTask(task=each), task, bus, "resumed")
    typer.echo(f"{named} goes on")


def step(
    task: RunningTask = "",
    by: Annotated[str, typer.Option("--by", metavar="leaf|tick", help="How far.")] = "leaf",
    *,
    bus: BusOptions,
) -> None:
    """Go on with a paused task until one more leaf of its tree has ended, or by one tick."""
    from tandem.skills.ports.tasks import TASK_STEP, StepTask  # noqa: PLC0415

    far = cast('Literal["leaf", "tick"]', _one_of(by, ("leaf", "tick"), "--by"))
    named = _ask(TASK_STEP, lambda each: StepTask(task=each, by=far), task, bus, "stepped")
    typer.echo(f"{named} goes on by one {far}")


def abandon(task: Task, *, bus: BusOptions) -> None:
    """Give up a cancelled task whose hardware does not answer."""
    from tandem.skills.ports.tasks import TASK_ABANDON, NameTask  # noqa: PLC0415

    _ask(TASK_ABANDON, lambda each: NameTask(task=each), task, bus, "abandoned")
    typer.echo(f"{task} is given up; see that the robot is at rest")


def reprioritise(
    task: Task,
    priority: Annotated[int, typer.Argument(min=-100, max=100, help="The higher one is taken first.")],
    *,
    bus: BusOptions,
) -> None:
    """Give a queued task another priority."""
    from tandem.skills.ports.tasks import TASK_REPRIORITISE, Reprioritise  # noqa: PLC0415

    _ask(
        TASK_REPRIORITISE,
        lambda each: Reprioritise(task=each, priority=priority),
        task,
        bus,
        "put elsewhere in the queue",
    )
    typer.echo(f"{task} has priority {priority}")


def answer(
    words: Annotated[str, typer.Argument(metavar="ANSWER", help="One of the question's choices.")],
    task: OfTask = "",
    *,
    bus: BusOptions,
) -> None:
    """Answer what a task asks an operator; `tandem tasks` shows the question."""
    from tandem.skills.ports.tasks import TASK_ANSWER, AnswerQuestion  # noqa: PLC0415

    named = _ask(TASK_ANSWER, lambda each: AnswerQuestion(task=each, answer=words), task, bus, "answered")
    typer.echo(f"{named} has its answer: {words}")


def break_at(
    node: Node,
    *,
    after: Annotated[bool, typer.Option("--after", help="Behind the node, not before it.")] = False,
    off: Annotated[bool, typer.Option("--off", help="Take the breakpoint away.")] = False,
    task: OfTask = "",
    bus: BusOptions,
) -> None:
    """Have a task pause before or after a node of its tree."""
    from tandem.skills.ports.tasks import TASK_BREAKPOINT, Breakpoint  # noqa: PLC0415

    when: Literal["before", "after"] = "after" if after else "before"
    named = _ask(
        TASK_BREAKPOINT,
        lambda each: Breakpoint(task=each, node=node, when=when, on=not off),
        task,
        bus,
        "given a breakpoint",
    )
    typer.echo(f"{named} {'no longer pauses' if off else 'pauses'} {when} {node}")


def force(
    node: Node,
    *,
    status: Annotated[str, typer.Argument(metavar="success|failure|off", help="What it ends with.")],
    task: OfTask = "",
    bus: BusOptions,
) -> None:
    """Have a node of a test run end with a status instead of doing its work."""
    from tandem.skills.ports.tasks import TASK_FORCE, ForceNode  # noqa: PLC0415

    said = _one_of(status, ("success", "failure", "off"), "STATUS")
    wanted = None if said == "off" else cast('Literal["SUCCESS", "FAILURE"]', said.upper())
    named = _ask(
        TASK_FORCE,
        lambda each: ForceNode(task=each, node=node, status=wanted),
        task,
        bus,
        "forced",
    )
    typer.echo(f"{named}: {node} {'works again' if wanted is None else f'ends with {wanted}'}")


def _one_of(text: str, choices: tuple[str, ...], option: str) -> str:
    if text not in choices:
        raise CommandError(f"{option}: one of {', '.join(choices)} was expected; found {text!r}")
    return text


def _ask(
    service: Service[M, ControlAnswer],
    document: Callable[[str], M],
    task: str,
    options: BusOptions,
    participle: str,
) -> str:
    """Ask for it, of the running task unless one is named; return the task's id."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_CANCEL, TASK_INFO  # noqa: PLC0415

    with Connection(options) as connection:
        key = connection.cancel_key() if service is TASK_CANCEL else service.key
        connection.require_right(key)
        named = task or connection.ask(TASK_INFO, Nothing()).running
        if not named:
            raise CommandError("no task is running", ExitCode.BAD_INPUT)
        told = connection.ask(replace(service, key=key), document(named))
    if not told.accepted:
        raise CommandError(f"{named} can't be {participle}: {told.reason}", ExitCode.BAD_INPUT)
    return named
