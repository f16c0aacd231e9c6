"""The options of commands that start a whole system: demo, up, run."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Final, get_type_hints

import typer

from tandem.executive.cli.arguments import (
    OtherSite,
    OwnEndpoint,
    OwnRobot,
    OwnSite,
    bus_options,
    give_parameters,
)
from tandem.executive.cli.completing import scenarios
from tandem.executive.cli.option_checks import (
    checked_film,
    checked_scenario,
    folder_of_run,
    logs_of,
    require_window,
    speed_of,
)
from tandem.executive.config.addresses import METRICS_EXAMPLE
from tandem.executive.config.run_options import (
    DEFAULT_ENDPOINT,
    DEFAULT_ROBOT,
    DEFAULT_SITE,
    BusOptions,
    RunOptions,
)

Scenario = Annotated[
    str,
    typer.Option(
        "--scenario",
        metavar="NAME|FILE",
        help="A name from `tandem scenario list`, or a YAML file.",
        autocompletion=scenarios,
    ),
]
Faults = Annotated[
    Path | None,
    typer.Option("--faults", metavar="FILE", help="YAML file of faults to inject."),
]
Seed = Annotated[int, typer.Option("--seed", min=0, help="Seed for everything random.")]
Speed = Annotated[
    str,
    typer.Option("--speed", metavar="X|max", help="Simulated seconds per real second, or max."),
]
Window = Annotated[bool, typer.Option("--gui/--headless", help="Show the simulation in a window.")]
Lockstep = Annotated[
    bool, typer.Option("--lockstep", help="Run everything in one thread: the same seed gives the same run.")
]
MetricsAt = Annotated[
    str,
    typer.Option(
        "--metrics",
        metavar="HOST:PORT",
        help=f"Serve Prometheus metrics at this address, e.g. {METRICS_EXAMPLE}.",
    ),
]
TracesTo = Annotated[
    str,
    typer.Option(
        "--traces", metavar="URL", help="Send OpenTelemetry traces to this URL, e.g. http://127.0.0.1:4318."
    ),
]
ReportFile = Annotated[
    Path | None, typer.Option("--report", metavar="FILE", help="Write a JSON report to this file.")
]
Page = Annotated[
    bool, typer.Option("--web", help="Serve the page: robot, tree, tasks and stop in a browser.")
]
PAGE_AT: Final = "127.0.0.1:8447"
"""Where the page is served unless told otherwise."""
PageAt = Annotated[
    str | None,
    typer.Option(
        "--web-at",
        metavar="HOST:PORT",
        help=f"--web at this address, on this host only. Default: {PAGE_AT}.",
    ),
]
Record = Annotated[
    bool, typer.Option("--record", help="Record everything that is said on the bus, as MCAP files.")
]
RecordTo = Annotated[
    Path | None,
    typer.Option("--record-to", metavar="DIR", help="--record into this folder. Default: records in --data."),
]
RunRecord = Annotated[
    Path | None,
    typer.Option("--record-to", metavar="DIR", help="With --lockstep: record the run into this folder."),
]
RecordPictures = Annotated[
    bool, typer.Option("--record-pictures/--no-record-pictures", help="Record camera pictures, 5 a second.")
]
Data = Annotated[
    Path | None,
    typer.Option(
        "--data", metavar="DIR", help="Folder of the ledger. Default: $XDG_STATE_HOME/tandem/<site>-<robot>."
    ),
]
OnRestart = Annotated[
    str,
    typer.Option(
        "--on-restart",
        metavar="resume|ask|interrupt",
        help="What to do with a task that was running when the executive ended.",
    ),
]
Picture = Annotated[
    Path | None,
    typer.Option("--picture", metavar="FILE", help="Save a picture of the final scene to this file."),
]
FilmFile = Annotated[
    Path | None,
    typer.Option(
        "--film",
        metavar="FILE",
        help="Save a small moving picture of room and tree to this file: .webp, .gif or .png.",
    ),
]
Listen = Annotated[
    list[str] | None,
    typer.Option(
        "--listen",
        metavar="ENDPOINT",
        help="Extra endpoint of the router, as tls/HOST:PORT. Repeat for more than one.",
    ),
]
Insecure = Annotated[
    bool,
    typer.Option(
        "--insecure", help="Listen beyond this host without TLS. Anyone who can connect can move the robot."
    ),
]
SilentAfter = Annotated[
    float,
    typer.Option(
        "--silent-after",
        min=0.2,
        max=10.0,
        help="Seconds of silence after which a process counts as hung and is killed.",
    ),
]
ProcessesOption = Annotated[
    str,
    typer.Option(
        "--processes",
        metavar="few|many",
        help="Give each skill a process, or have all share one: less memory, for small robots.",
    ),
]
Only = Annotated[
    str | None,
    typer.Option("--only", metavar="ROLE,...", help="Start only these processes; run the others elsewhere."),
]


def starts_system(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of a system that it starts and ends; it receives them as ``options``.

    Args:
        command: takes a keyword ``options: RunOptions``, which no option of its own stands for.
    """

    @functools.wraps(command)
    def starting(context: typer.Context, **named: object) -> None:
        shared = {each.name: named.pop(each.name) for each in system_parameters()[1:]}
        made: Callable[..., RunOptions] = _whole_system  # typer has checked them
        command(**named, options=made(context, **shared))

    hints = get_type_hints(command, include_extras=True)
    given = inspect.signature(command).parameters.values()
    own = [each.replace(annotation=hints.get(each.name, each.annotation)) for each in given]
    shared = system_parameters()
    give_parameters(starting, [shared[0], *(each for each in own if each.name != "options"), *shared[1:]])
    return starting


def system_parameters() -> list[inspect.Parameter]:
    """Return the context and the options that ``starts_system`` adds, as a function's parameters."""
    hints = get_type_hints(_whole_system, include_extras=True)
    return [
        each.replace(annotation=hints[each.name])
        for each in inspect.signature(_whole_system).parameters.values()
    ]


def _whole_system(
    context: typer.Context,
    *,
    scenario: Scenario = "Demo",
    site: OtherSite = "",
    faults: Faults = None,
    seed: Seed = 1,
    speed: Speed = "1",
    gui: Window = False,
    lockstep: Lockstep = False,
    report: ReportFile = None,
    picture: Picture = None,
    film: FilmFile = None,
    record_to: RunRecord = None,
    connect: OwnEndpoint = DEFAULT_ENDPOINT,
    site_key: OwnSite = DEFAULT_SITE,
    robot: OwnRobot = DEFAULT_ROBOT,
) -> RunOptions:
    """Return the options of a whole system, checked."""
    from tandem.executive.cli.opening import checked_roles, refuse_without_extras  # noqa: PLC0415
    from tandem.executive.system.plugin_probe import broken as broken_plugins  # noqa: PLC0415

    require_window(gui=gui, lockstep=lockstep)
    refuse_without_extras(checked_roles(None))
    checked_scenario(scenario, site, faults)
    simulated = simulation_options(
        context,
        bus_options(connect, site_key, robot),
        scenario=scenario,
        site=site,
        faults=faults,
        seed=seed,
        speed=speed,
        gui=gui,
        report=report,
    )
    return replace(
        simulated,
        lockstep=lockstep,
        broken=broken_plugins(),
        picture=picture,
        film=checked_film(film),
        record=folder_of_run(record_to, lockstep=lockstep),
    )


def simulation_options(
    context: typer.Context,
    bus: BusOptions,
    *,
    scenario: str,
    site: str,
    faults: Path | None,
    seed: int,
    speed: str,
    gui: bool,
    report: Path | None,
) -> RunOptions:
    """Return what every command that starts a system asks for: a simulation on a bus, and logs of it.

    Raises:
        CommandError: when the speed is none.
    """
    logs = logs_of(context)
    return RunOptions(
        bus=bus,
        scenario=scenario,
        site=site,
        faults=faults,
        seed=seed,
        speed=speed_of(speed),
        gui=gui,
        report=report,
        log=logs.file,
        verbose=logs.verbose,
        log_format=logs.format,
    )
