"""``tandem tree``: the trees there are, and pictures of them; no robot and no sim is needed."""

from __future__ import annotations

import sys
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json, Output, SiteFile, connects
from tandem.executive.cli.completing import drawn_nodes, kinds
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import DEFAULT_SITE, BusOptions

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pydantic import JsonValue

    from tandem.executive.trials.exploration.exploring import Coverage
    from tandem.executive.trials.exploration.worlds import Make
    from tandem.skills.ports.message import Message
    from tandem.skills.ports.site import Site
    from tandem.skills.ports.tasks import TreeNode
    from tandem.trees.task import TaskType


class Format(StrEnum):
    """How a tree can be drawn; the names of ``tandem.executive.render.formats``, which a test compares."""

    UNICODE = "unicode"
    ASCII = "ascii"
    DOT = "dot"
    SVG = "svg"
    PNG = "png"
    JSON = "json"


class Hide(StrEnum):
    """What can be left out of a picture; the names of ``tandem.executive.render.outline.HIDES``."""

    RECOVERIES = "recoveries"
    GUARDS = "guards"


Hidden = Annotated[
    list[Hide] | None,
    typer.Option(
        "--hide",
        help="Leave these out and say how many they are: the steps of recoveries; conditions beside the work "
        "that they may save. Repeat for both.",
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(help="Draw and check the behaviour trees of the tasks.", no_args_is_help=True)
    group.command("list")(list_all)
    group.command("render")(connects(render))
    group.command("coverage")(coverage)
    group.command("properties")(properties)
    app.add_typer(group, name="tree")


def list_all(*, as_json: Json = False) -> None:
    """List the tasks and the fields of their requests."""
    if as_json:
        _print_list()
        return
    from rich.console import Console  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    from tandem.trees.registry import discover  # noqa: PLC0415

    table = Table("task", "what it does", "fields of the request", box=None)
    for kind in discover().values():
        fields = [
            name if info.is_required() else f"[{name}]"
            for name, info in kind.request.model_fields.items()
            if name != "task"
        ]
        table.add_row(kind.name, kind.summary, " ".join(fields).replace("[", r"\["))
    Console().print(table)


def render(
    task: Annotated[
        str, typer.Argument(metavar="[TASK]", help="Task, as in `tandem tree list`.", autocompletion=kinds)
    ] = "",
    *,
    form: Annotated[Format, typer.Option("--format", "-f")] = Format.UNICODE,
    output: Output = None,
    live: Annotated[bool, typer.Option("--live", help="Draw the tree that is running now.")] = False,
    request: Annotated[
        str, typer.Option("--request", metavar="JSON", help="Draw the tree for this request.")
    ] = "",
    depth: Annotated[
        int | None,
        typer.Option("--depth", min=0, help="Levels below the root, or below the node of --focus; 0: all."),
    ] = None,
    hide: Hidden = None,
    focus: Annotated[
        str,
        typer.Option(
            "--focus",
            metavar="NODE",
            help="Draw from this node on: its name or its path.",
            autocompletion=drawn_nodes,
        ),
    ] = "",
    everything: Annotated[bool, typer.Option("--all", help="Draw every node.")] = False,
    site: SiteFile = DEFAULT_SITE,
    bus: BusOptions,
) -> None:
    """Draw the tree of a task, or with --live the running tree and its statuses.

    Without --depth, --hide and --all the picture fits a page: phases and their steps, with the number of
    nodes and recoveries that each folded node stands for. JSON then has every node.
    """
    from tandem.executive.render.formats import BINARY, FORMATS  # noqa: PLC0415
    from tandem.executive.render.view import NoSuchNodeError, View  # noqa: PLC0415

    if live:
        root = _running(bus)
    elif task:
        root = built(task, request, site)
    else:
        raise CommandError("expected a TASK or --live; see `tandem tree list`")
    chosen = everything or (form is Format.JSON and depth is None and not hide)
    view = View(chosen, depth, tuple(each.value for each in hide or ()), focus)
    try:
        content = FORMATS[form.value](view.of(root))
    except NoSuchNodeError as error:
        raise CommandError(f"--focus: {error}") from error
    if output is not None:
        try:
            output.write_bytes(content)
        except OSError as error:
            raise CommandError(f"--output {output}: cannot write: {error.strerror}") from error
        typer.echo(f"{output}: {len(content)} bytes")
    elif form.value in BINARY and sys.stdout.isatty():
        raise CommandError(f"{form.value} is binary; give a file with --output")
    else:
        sys.stdout.buffer.write(content)
        sys.stdout.flush()


def coverage(
    task: Annotated[
        str, typer.Argument(metavar="TASK", help="Task, as in `tandem tree list`.", autocompletion=kinds)
    ],
    *,
    depth: Annotated[
        int, typer.Option("--depth", min=0, max=9, help="Number of leaves that fail in one plan.")
    ] = 3,
    plans: Annotated[bool, typer.Option("--plans", help="Print each plan before it runs.")] = False,
    as_json: Json = False,
) -> None:
    """Make each leaf fail in each way, with mock skills. Exits 1 if a status is missed or a rule broken."""
    from tandem.executive.trials.exploration.exploring import explore  # noqa: PLC0415

    tell = typer.echo if plans else _tell_nobody
    seen = explore(*_worlds(task), depth=depth, tell=_tell_nobody if as_json else tell)
    whole = not seen.missing() and not seen.broken
    if as_json:
        _print_coverage(seen)
        raise typer.Exit(ExitCode.OK if whole else ExitCode.TASK_FAILED)
    for name, gaps in seen.missing().items():
        typer.echo(f"not seen  {name}: {', '.join(status.lower() for status in gaps)}")
    for broken in seen.broken:
        typer.echo(f"broken    {broken}")
    typer.echo(
        f"{len(seen.wanted)} nodes, {seen.runs} runs, {seen.ticks} ticks:"
        f" {len(seen.missing())} nodes not seen in every status, {len(seen.broken)} invariants broken"
    )
    raise typer.Exit(ExitCode.OK if whole else ExitCode.TASK_FAILED)


def properties(
    task: Annotated[
        str, typer.Argument(metavar="TASK", help="Task, as in `tandem tree list`.", autocompletion=kinds)
    ],
    *,
    ticks: Annotated[
        int, typer.Option("--ticks", min=1, max=10**9, help="Total number of ticks.")
    ] = 1_000_000,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed for all random draws.")] = 1,
    as_json: Json = False,
) -> None:
    """Run random fault schedules with mock skills. Exits 1 if one breaks a rule."""
    from tandem.executive.trials.exploration.properties import search  # noqa: PLC0415

    worlds, _ = _worlds(task)
    said: list[str] = []
    runs, bad = search(worlds, ticks=ticks, seed=seed, tell=said.append if as_json else typer.echo)
    if as_json:
        from tandem.executive.cli.shapes import Searched, print_json  # noqa: PLC0415

        print_json(Searched(runs=runs, broken=bad, words=tuple(said)))
        raise typer.Exit(ExitCode.TASK_FAILED if bad else ExitCode.OK)
    typer.echo(f"{runs} runs, at least {ticks} ticks: {bad} broke a rule")
    raise typer.Exit(ExitCode.TASK_FAILED if bad else ExitCode.OK)


def _print_list() -> None:
    from tandem.executive.cli.shapes import TaskKind, TaskKindList, print_json  # noqa: PLC0415
    from tandem.trees.registry import discover  # noqa: PLC0415

    found = []
    for kind in discover().values():
        fields = {name: info for name, info in kind.request.model_fields.items() if name != "task"}
        required = tuple(name for name, info in fields.items() if info.is_required())
        optional = tuple(name for name in fields if name not in required)
        found.append(TaskKind(name=kind.name, summary=kind.summary, required=required, optional=optional))
    print_json(TaskKindList(kinds=tuple(found)))


def _print_coverage(seen: Coverage) -> None:
    from tandem.executive.cli.shapes import Covered, print_json  # noqa: PLC0415

    missing = {name: tuple(status.value for status in gaps) for name, gaps in seen.missing().items()}
    print_json(
        Covered(
            nodes=len(seen.wanted),
            runs=seen.runs,
            ticks=seen.ticks,
            missing=missing,
            broken=tuple(seen.broken),
        )
    )


def _worlds(task: str) -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of a task.

    Raises:
        CommandError: when there are none.
    """
    from tandem.executive.trials.exploration.hand_worlds import HAND_WORLDS  # noqa: PLC0415
    from tandem.executive.trials.exploration.inspect_worlds import inspect_worlds  # noqa: PLC0415
    from tandem.executive.trials.exploration.travel_worlds import TRAVEL_WORLDS  # noqa: PLC0415
    from tandem.executive.trials.exploration.worlds import fetch_corners, fetch_worlds  # noqa: PLC0415

    if task == "fetch":
        return fetch_worlds(), fetch_corners()
    if task == "inspect":
        return inspect_worlds()
    if task in HAND_WORLDS:
        return HAND_WORLDS[task]()
    if task in TRAVEL_WORLDS:
        return TRAVEL_WORLDS[task]()
    known = ", ".join(("fetch", "inspect", *HAND_WORLDS, *TRAVEL_WORLDS))
    raise CommandError(f"no worlds to explore {task!r} in; expected one of {known}")


def _tell_nobody(_: str) -> None:
    """Tell nobody."""


def _running(options: BusOptions) -> TreeNode:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TREE_NOW  # noqa: PLC0415

    with Connection(options) as connection:
        return connection.ask(TREE_NOW, Nothing()).root


def built(task: str, request: str, site_name: str) -> TreeNode:
    """Return the tree of a task, for a request as JSON or for an example of one.

    Raises:
        CommandError: when there is no such task, the request does not fit, or the task can't build its tree.
    """
    from tandem.executive.render.example import NoExampleError, example_request  # noqa: PLC0415
    from tandem.executive.service.intake.request_parser import Refused, read_request  # noqa: PLC0415
    from tandem.skills.ports.documents import parse  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415
    from tandem.trees.registry import discover  # noqa: PLC0415

    installed = discover()
    if task not in installed:
        raise CommandError(f"no task {task!r}; expected one of {', '.join(installed)}")
    site = load(site_name)
    if not request:
        try:
            return _tree_of(installed[task], site, example_request(installed[task], site))
        except NoExampleError as error:
            raise CommandError(str(error)) from error
    asked = read_request(request.encode(), installed, site)
    document = parse(request.encode())
    if isinstance(asked, Refused) or isinstance(document, tuple):
        problems = asked.problems if isinstance(asked, Refused) else ()
        lines = [
            f"  {each.path}: expected {each.expected}, found {each.found or 'nothing'}" for each in problems
        ]
        raise CommandError("\n".join(("--request is invalid:", *lines)))
    return _tree_of(installed[task], site, document)


def _tree_of(kind: TaskType[Message], site: Site, document: dict[str, JsonValue]) -> TreeNode:
    """Return a task's tree; whatever its builder raises is a mistake in the task, and told in words."""
    from tandem.executive.render.example import tree_of  # noqa: PLC0415
    from tandem.skills.ports.plugins import in_words  # noqa: PLC0415
    from tandem.trees.node_paths import AmbiguousNodesError  # noqa: PLC0415

    try:
        return tree_of(kind, site, document)
    except AmbiguousNodesError as error:
        raise CommandError(f"task {kind.name!r} can't build its tree: {error}") from error
    except Exception as error:
        raise CommandError(f"task {kind.name!r} can't build its tree: {in_words(error)}") from error
