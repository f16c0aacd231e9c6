"""What the shell completes: tasks, nodes, items, scenarios, kinds. Quick, and silent without a robot."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import TYPE_CHECKING, Final

import typer

from tandem.executive.cli.arguments import of_context
from tandem.executive.cli.errors import CommandError

if TYPE_CHECKING:
    from tandem.executive.cli.connection import Connection
    from tandem.skills.ports.tasks import TaskStatus, TreeNode

WITHIN: Final = 0.5
"""Host seconds in which the robot must answer: the user is waiting for the completed word."""
Words = list[tuple[str, str]]
"""Each word with what it is."""


def open_tasks(ctx: typer.Context, incomplete: str) -> Words:
    """Return the tasks that have not ended."""
    return _tasks(ctx, incomplete, lambda status: not status.state.terminal)


def ended_tasks(ctx: typer.Context, incomplete: str) -> Words:
    """Return the tasks that have ended."""
    return _tasks(ctx, incomplete, lambda status: status.state.terminal)


def tasks(ctx: typer.Context, incomplete: str) -> Words:
    """Return the tasks that the executive remembers."""
    return _tasks(ctx, incomplete, lambda _: True)


def logged(ctx: typer.Context, incomplete: str) -> Words:
    """Return the processes that have a log on this host, and the tasks."""
    from tandem.executive.config.run_options import default_data  # noqa: PLC0415
    from tandem.executive.telemetry.log_reading import FOLDER, roles_in  # noqa: PLC0415

    roles: tuple[str, ...] = ()
    with suppress(CommandError, OSError):
        roles = roles_in(default_data(of_context(ctx.params), os.environ) / FOLDER)
    return _fitting(((role, "process") for role in roles), incomplete) + tasks(ctx, incomplete)


def running_nodes(ctx: typer.Context, incomplete: str) -> Words:
    """Return the nodes of the running task's tree."""
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TREE_NOW  # noqa: PLC0415

    return _fitting(_asked(ctx, lambda link: _told(link.ask(TREE_NOW, Nothing()).root)), incomplete)


def drawn_nodes(ctx: typer.Context, incomplete: str) -> Words:
    """Return the nodes of the tree that ``tandem tree render`` would draw."""
    if ctx.params.get("live"):
        return running_nodes(ctx, incomplete)
    from tandem.executive.cli.commands.tree_commands import built  # noqa: PLC0415
    from tandem.executive.config.run_options import DEFAULT_SITE  # noqa: PLC0415

    # While an option still lacks its value, the arguments before it stand in ``args``.
    task, request, site = (str(ctx.params.get(name) or "") for name in ("task", "request", "site"))
    try:
        root = built(task or next(iter(ctx.args), ""), request, site or DEFAULT_SITE)
    except (CommandError, ValueError):
        return []
    return _fitting(_told(root), incomplete)


def items(ctx: typer.Context, incomplete: str) -> Words:
    """Return the items that the robot's site has."""
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_KINDS  # noqa: PLC0415

    def known(link: Connection) -> Words:
        there = link.ask(TASK_KINDS, Nothing())
        named = [(name, f"item {number}") for name, number in there.names.items()]
        return named + [(item, "item") for item in there.items]

    return _fitting(_asked(ctx, known), incomplete)


def scenarios(incomplete: str) -> list[str]:
    """Return the scenarios that are installed."""
    try:
        from tandem.sim.scenario import scenario_names  # noqa: PLC0415 - an extra may be missing
    except ImportError:
        return []
    return [name for name in scenario_names() if name.startswith(incomplete)]


def kinds(incomplete: str) -> Words:
    """Return the kinds of task that are installed here."""
    from tandem.trees.registry import discover  # noqa: PLC0415

    return _fitting(((kind.name, kind.summary) for kind in discover().values()), incomplete)


def _tasks(ctx: typer.Context, incomplete: str, which: Callable[[TaskStatus], bool]) -> Words:
    from tandem.executive.client.pages import listed  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_LIST  # noqa: PLC0415

    def known(link: Connection) -> Words:
        found = listed(lambda each: link.ask(TASK_LIST, each))
        return [(each.task, f"{each.kind} {each.state}") for each in reversed(found) if which(each)]

    return _fitting(_asked(ctx, known), incomplete)


def _asked(ctx: typer.Context, ask: Callable[[Connection], Words]) -> Words:
    """Return what the robot answers; nothing when there is none, or it is slow, or the options are wrong."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415

    try:
        with Connection(of_context(ctx.params), within=WITHIN) as link:
            return ask(link)
    except CommandError:
        return []


def _told(root: TreeNode) -> Words:
    return [(each.name, f"{each.kind} {each.type}") for each in root.walk()]


def _fitting(words: Iterable[tuple[str, str]], incomplete: str) -> Words:
    return [each for each in words if each[0].startswith(incomplete)]
