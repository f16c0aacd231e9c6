"""The verbs: pause, resume, step, abandon, reprioritise, answer, break, force."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar, cast

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.cli.completing import open_tasks, running_nodes
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.keys import Service
    from tandem.skills.ports.message import Message
    from tandem.skills.ports.tasks import ControlAnswer

M = TypeVar("M", bound="Message")
RunningTask = Annotated[
    str,
    typer.Argument(
        metavar="[ID]",
        help="Task id, as in `tandem tasks`. Default: the running task.",
        autocompletion=open_tasks,
    ),
]
Task = Annotated[
    str, typer.Argument(metavar="ID", help="Task id, as in `tandem tasks`.", autocompletion=open_tasks)
]
OfTask = Annotated[
    str,
    typer.Option(
        "--task", metavar="ID", help="Task id. Default: the running task.", autocompletion=open_tasks
    ),
]
Node = Annotated[
    str,
    typer.Argument(
        metavar="NODE", help="Name of the node, or its path in the tree.", autocompletion=running_nodes
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    for call in (pause, resume, step, abandon, reprioritise, answer, force):
        app.command(call.__name__)(connects(call))
    app.command("break")(connects(break_at))


def pause(task: RunningTask = "", *, bus: BusOptions) -> None:
    """Pause the running task."""
    from tandem.skills.ports.tasks import TASK_PAUSE, NameTask  # noqa: PLC0415

    named = _ask(TASK_PAUSE, lambda each: NameTask(task=each), task, bus, "paused")
    typer.echo(f"pausing {named}; `tandem resume` continues it, `tandem step` runs one leaf")


def resume(task: RunningTask = "", *, bus: BusOptions) -> None:
    """Resume a paused task."""
    from tandem.skills.ports.tasks import TASK_RESUME, NameTask  # noqa: PLC0415

    named = _ask(TASK_RESUME, lambda each: NameTask(task=each), task, bus, "resumed")
    typer.echo(f"resuming {named}")


def step(
    task: RunningTask = "",
    by: Annotated[str, typer.Option("--by", metavar="leaf|tick", help="How far to go.")] = "leaf",
    *,
    bus: BusOptions,
) -> None:
    """Run a paused task for one more leaf, or for one tick."""
    from tandem.skills.ports.tasks import TASK_STEP, StepTask  # noqa: PLC0415

    far = cast('Literal["leaf", "tick"]', _one_of(by, ("leaf", "tick"), "--by"))
    named = _ask(TASK_STEP, lambda each: StepTask(task=each, by=far), task, bus, "stepped")
    typer.echo(f"stepping {named} by one {far}")


def abandon(task: Task, *, bus: BusOptions) -> None:
    """Give up on a cancelled task whose hardware does not answer."""
    from tandem.skills.ports.tasks import TASK_ABANDON, NameTask  # noqa: PLC0415

    _ask(TASK_ABANDON, lambda each: NameTask(task=each), task, bus, "abandoned")
    typer.echo(f"abandoned {task}; make sure that the robot is at rest")


def reprioritise(
    task: Task,
    priority: Annotated[
        int, typer.Argument(min=-100, max=100, help="Tasks with a higher priority run first.")
    ],
    *,
    bus: BusOptions,
) -> None:
    """Change the priority of a queued task."""
    from tandem.skills.ports.tasks import TASK_REPRIORITISE, Reprioritise  # noqa: PLC0415

    _ask(
        TASK_REPRIORITISE,
        lambda each: Reprioritise(task=each, priority=priority),
        task,
        bus,
        "reprioritised",
    )
    typer.echo(f"{task} has priority {priority}")


def answer(
    words: Annotated[str, typer.Argument(metavar="ANSWER", help="One of the choices of the question.")],
    task: OfTask = "",
    *,
    bus: BusOptions,
) -> None:
    """Answer a question from a task. `tandem tasks` shows the question."""
    from tandem.skills.ports.tasks import TASK_ANSWER, AnswerQuestion  # noqa: PLC0415

    named = _ask(TASK_ANSWER, lambda each: AnswerQuestion(task=each, answer=words), task, bus, "answered")
    typer.echo(f"answered {named}: {words}")


def break_at(
    node: Node,
    *,
    after: Annotated[
        bool, typer.Option("--after", help="Pause after the node instead of before it.")
    ] = False,
    off: Annotated[bool, typer.Option("--off", help="Remove the breakpoint.")] = False,
    task: OfTask = "",
    bus: BusOptions,
) -> None:
    """Set a breakpoint before or after a node of the tree."""
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
    status: Annotated[str, typer.Argument(metavar="success|failure|off", help="Status to force.")],
    task: OfTask = "",
    bus: BusOptions,
) -> None:
    """Force the status of a node in a test run."""
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
    typer.echo(f"{named}: {node} {'runs again' if wanted is None else f'is forced to {wanted}'}")


def _one_of(text: str, choices: tuple[str, ...], option: str) -> str:
    if text not in choices:
        raise CommandError(f"{option}: expected one of {', '.join(choices)}; found {text!r}")
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
    from tandem.skills.ports.tasks import TASK_INFO  # noqa: PLC0415

    with Connection(options) as connection:
        connection.require_right(service.key)
        named = task or connection.ask(TASK_INFO, Nothing()).running
        if not named:
            raise CommandError("no task is running", ExitCode.BAD_INPUT)
        told = connection.ask(service, document(named))
    if not told.accepted:
        raise CommandError(f"{named} cannot be {participle}: {told.reason}", ExitCode.BAD_INPUT)
    return named
