"""``tandem watch``: the running tree in the terminal, with phase, progress and time."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.commands.reflex_commands import has
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from rich.console import Group

    from tandem.executive.cli.connection import Connection
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ports.reflex import PipelineState
    from tandem.skills.ports.tasks import TaskStatus, TreeSnapshot

REFRESH: Final = 0.1
"""Seconds between two pictures, at the least."""
BAR: Final = 30
"""Characters of a task's bar."""


@dataclass
class View:
    """What is shown. ``gone``: the executive has not been seen for a while."""

    status: TaskStatus | None = None
    tree: TreeSnapshot | None = None
    now: RobotTime | None = None
    gone: bool = False
    told: RobotTime | None = None
    """When the status was told."""
    held: dict[str, PipelineState] = field(default_factory=dict)
    """The resources that a reflex has now."""


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("watch")(connects(watch))


def watch(
    once: Annotated[bool, typer.Option("--once", help="Print the current state and exit.")] = False,  # noqa: FBT002
    *,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Show the tree of the running task live, until Ctrl-C."""
    from rich.console import Console  # noqa: PLC0415

    from tandem.executive.cli.connection import Connection  # noqa: PLC0415

    console = Console()
    with Connection(bus) as connection:
        view = _first(connection)
        if as_json:
            _print(view)
        elif once:
            console.print(picture(view, height=10_000))
        if once:
            return
        if as_json:
            _stream(connection, view)
        else:
            _follow(connection, console, view)


def picture(view: View, *, height: int) -> Group:
    """Return what is to be shown in ``height`` lines of a terminal."""
    from rich.console import Group  # noqa: PLC0415
    from rich.text import Text  # noqa: PLC0415

    from tandem.executive.render.signs import STATUS_STYLES  # noqa: PLC0415
    from tandem.executive.render.text import lines_within  # noqa: PLC0415

    parts = [Text(head(view), style="bold")]
    if view.status is not None and view.status.failure is not None:
        parts.append(Text(f"{view.status.failure.kind}: {view.status.failure.message}", style="red"))
    parts.extend(Text(has(view.held[name]), style="magenta") for name in sorted(view.held))
    if view.tree is not None and view.tree.task:
        for line in lines_within(view.tree.root, max(4, height - len(parts) - 1)):
            text = Text(line.lead, style="dim", no_wrap=True, overflow="ellipsis")
            style = f"dim {STATUS_STYLES[line.status]}" if line.past else STATUS_STYLES[line.status]
            parts.append(text.append(str(line)[len(line.lead) :], style=style))
    return Group(*parts)


def head(view: View) -> str:
    """Return the line above the tree: task, state, phase, progress, robot seconds."""
    if view.gone:
        return "the executive is gone; waiting for it to return"
    status = view.status
    if status is None:
        return "no tasks yet; send one with `tandem request`"
    full = round(BAR * status.progress.fraction)
    bar = "█" * full + "░" * (BAR - full)
    phase = status.progress.phase or "-"
    return f"{status.task}  {status.state}  {phase}  {bar} {status.progress.fraction:4.0%}  {_seconds(view)}"


def _seconds(view: View) -> str:
    status = view.status
    if status is None or status.started is None:
        return ""
    end = view.now if status.ended is None else status.ended
    seconds = None if end is None else end.since(status.started)
    took = "" if seconds is None else f"{max(0.0, seconds):.1f} s"
    return ", ".join(part for part in (took, _left(view)) if part)


def _left(view: View) -> str:
    """Return how long the task takes yet as a rule; nothing when that is not known or it has ended."""
    status = view.status
    if status is None or status.state.terminal or status.time_left is None:
        return ""
    since = None if view.now is None or view.told is None else view.now.since(view.told)
    left = status.time_left - max(0.0, since or 0.0)
    return f"about {left:.0f} s left" if left >= 1.0 else "any moment"


def _first(connection: Connection) -> View:
    from tandem.executive.client.pages import listed  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_LIST, TREE_NOW  # noqa: PLC0415

    tasks = listed(lambda each: connection.ask(TASK_LIST, each))
    tree = connection.ask(TREE_NOW, Nothing())
    at_work = [each for each in tasks if not each.state.terminal and each.started is not None]
    shown = (at_work or list(tasks))[-1] if tasks else None
    return View(shown, tree, tree.stamp, told=tree.stamp)


class News:
    """What comes of the running task, and puts it into a view."""

    def __init__(self, connection: Connection) -> None:
        from tandem.skills.ports.hearing import Heard  # noqa: PLC0415
        from tandem.skills.ports.keys import CLOCK, Latest  # noqa: PLC0415
        from tandem.skills.ports.reflex import PipelineState, pipeline_state  # noqa: PLC0415
        from tandem.skills.ports.tasks import TASK_STATUS, TREE  # noqa: PLC0415

        bus = self._bus = connection.bus
        self._statuses, self._trees = Latest(bus, TASK_STATUS), Latest(bus, TREE)
        self._clock = Latest(bus, CLOCK)
        self._pipelines = Heard(bus, pipeline_state("*").key, PipelineState.model_validate_json)

    def take(self, view: View) -> bool:
        """Bring the view up to date; return whether more than the time has changed."""
        from tandem.skills.ports.tasks import TaskState  # noqa: PLC0415

        before = (view.status, view.tree, view.gone, _acts(view))
        tick = self._clock.refresh()
        view.now = view.now if tick is None else tick.stamp
        for status in self._statuses.take():
            if status.state is not TaskState.QUEUED or view.status is None:
                view.status, view.told = status, view.now
        for _, pipeline, _ in self._pipelines.take():
            view.held.pop(pipeline.resource, None)
            if pipeline.reflex:
                view.held[pipeline.resource] = pipeline
        view.tree = self._trees.refresh() or view.tree
        view.gone = "executive" not in self._bus.alive()
        return (view.status, view.tree, view.gone, _acts(view)) != before


def _acts(view: View) -> dict[str, tuple[str, tuple[str, ...]]]:
    """Return which reflex does what, by resource."""
    return {name: (state.reflex, state.doing) for name, state in view.held.items()}


def _print(view: View) -> None:
    from tandem.executive.cli.shapes import Watched, print_json  # noqa: PLC0415

    tree = view.tree if view.tree is not None and view.tree.task else None
    held = tuple(view.held[name] for name in sorted(view.held))
    print_json(Watched(status=view.status, tree=tree, gone=view.gone, reflexes=held), line=True)


def _stream(connection: Connection, view: View) -> None:
    """Print the view at each change, a line each, until Ctrl-C."""
    news = News(connection)
    while True:
        time.sleep(REFRESH)
        if news.take(view):
            _print(view)


def _follow(connection: Connection, console: object, view: View) -> None:
    from rich.console import Console  # noqa: PLC0415
    from rich.live import Live  # noqa: PLC0415

    assert isinstance(console, Console)
    news = News(connection)
    with Live(picture(view, height=console.height), console=console, auto_refresh=False) as live:
        while True:
            time.sleep(REFRESH)
            news.take(view)
            live.update(picture(view, height=console.height), refresh=True)
