"""``tandem demo`` and ``tandem up``."""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated, cast, get_args, get_type_hints

import typer

from tandem.executive.cli.arguments import (
    OtherSite,
    OwnEndpoint,
    OwnRobot,
    OwnSite,
    bus_options,
    connects,
    give_parameters,
)
from tandem.executive.cli.commands.stop_commands import person
from tandem.executive.cli.completing import scenarios
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.logs import LogOptions
from tandem.executive.config.extras import RECORD, WEB, words_on
from tandem.executive.config.on_restart import OnRestart as Restart
from tandem.executive.config.run_options import (
    DEFAULT_ENDPOINT,
    DEFAULT_ROBOT,
    DEFAULT_SITE,
    BusOptions,
    Processes,
    RunOptions,
    default_data,
)
from tandem.skills.wire.pulse import SILENT_AFTER

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
        help="Serve Prometheus metrics at this address, e.g. 127.0.0.1:9464.",
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
PageAt = Annotated[
    str,
    typer.Option("--web-at", metavar="HOST:PORT", help="Address of the page, on this host only."),
]
Record = Annotated[
    bool, typer.Option("--record", help="Record everything that is said on the bus, as MCAP files.")
]
RecordTo = Annotated[
    Path | None,
    typer.Option("--record-to", metavar="DIR", help="Folder of the recordings. Default: records in --data."),
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


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("demo")(starts_system(demo))
    app.command("up")(connects(up))


def demo(*, options: RunOptions) -> None:
    """Start a simulated robot, fetch an item and stop. Exits 0 only if the item really is in the depot."""
    from tandem.executive.cli.running_system import run_demo  # noqa: PLC0415 - loads the whole system

    raise typer.Exit(run_demo(options))


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
    record_to: RunRecord = None,
    connect: OwnEndpoint = DEFAULT_ENDPOINT,
    site_key: OwnSite = DEFAULT_SITE,
    robot: OwnRobot = DEFAULT_ROBOT,
) -> RunOptions:
    """Return the options of a whole system, checked."""
    from tandem.executive.cli.opening import checked_roles, refuse_without_extras  # noqa: PLC0415
    from tandem.executive.system.plugin_probe import broken as broken_plugins  # noqa: PLC0415

    logs = _logs(context)
    _require_window(gui=gui, lockstep=lockstep)
    refuse_without_extras(checked_roles(None))
    return RunOptions(
        bus=bus_options(connect, site_key, robot),
        scenario=_scenario(scenario, site, faults),
        site=site,
        faults=faults,
        seed=seed,
        speed=_speed(speed),
        gui=gui,
        lockstep=lockstep,
        report=report,
        broken=broken_plugins(),
        picture=picture,
        record=_recorded_run(record_to, lockstep=lockstep),
        log=logs.file,
        verbose=logs.verbose,
        log_format=logs.format,
    )


def up(
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
    metrics: MetricsAt = "",
    traces: TracesTo = "",
    web: Page = False,
    web_at: PageAt = "127.0.0.1:8447",
    record: Record = False,
    record_to: RecordTo = None,
    record_pictures: RecordPictures = True,
    data: Data = None,
    on_restart: OnRestart = "resume",
    listen: Listen = None,
    insecure: Insecure = False,
    only: Only = None,
    processes: ProcessesOption = "many",
    silent_after: SilentAfter = SILENT_AFTER,
    bus: BusOptions,
) -> None:
    """Start the router, simulated robot, skills and executive, and keep them running until Ctrl-C."""
    from tandem.executive.cli.opening import (  # noqa: PLC0415
        checked_endpoints,
        checked_roles,
        owner_of,
        refuse_without_extras,
    )
    from tandem.executive.system.plugin_probe import broken as broken_plugins  # noqa: PLC0415
    from tandem.executive.trials.provenance import checkout  # noqa: PLC0415

    logs = _logs(context)
    if lockstep:
        raise CommandError(
            "up --lockstep: lockstep has its own bus that no client can reach; "
            "use `tandem demo --lockstep`, or leave out --lockstep"
        )
    _require_window(gui=gui, lockstep=False)
    broken = broken_plugins()
    bus = owner_of(bus, by_environment=_by_environment(context))
    roles = checked_roles(only, {each.plugin.key: each.error for each in broken})
    refuse_without_extras(roles)
    options = RunOptions(
        bus=bus,
        data=data or default_data(bus, os.environ),
        on_restart=_on_restart(on_restart),
        scenario=_scenario(scenario, site, faults),
        site=site,
        faults=faults,
        seed=seed,
        speed=_speed(speed),
        gui=gui,
        report=report,
        log=logs.file,
        verbose=logs.verbose,
        log_format=logs.format,
        metrics=_metrics(metrics),
        traces=_traces(traces),
        web=_page(web_at, bus) if web else "",
        black_box=True,
        record=_recordings(record_to, data or default_data(bus, os.environ), roles) if record else None,
        record_pictures=record_pictures,
        commit=checkout()[0],
        person=person(bus),
        silent_after=silent_after,
        listen=checked_endpoints(bus, listen or (), insecure=insecure)
        if not roles or "router" in roles
        else (),
        only=roles,
        processes=_processes(processes),
        broken=broken,
    )
    _check_map(options)
    from tandem.executive.system.births import begun  # noqa: PLC0415

    with begun() as births:
        from tandem.executive.cli.running_system import run_up  # noqa: PLC0415 - loads the whole system

        raise typer.Exit(run_up(options, births))


def _check_map(options: RunOptions) -> None:
    """Raise DocumentError when the saved map of the site is wrong."""
    from tandem.executive.cli.commands.scenario_commands import checked  # noqa: PLC0415
    from tandem.skills.map_file import check  # noqa: PLC0415

    check(checked(options.scenario, options.site).site, None if options.data is None else str(options.data))


def _by_environment(context: typer.Context) -> bool:
    """Say whether TANDEM_AS names the holder, which may be meant for the commands of a client."""
    source = context.get_parameter_source("holder")
    return source is not None and source.name == "ENVIRONMENT"


def _one_of(texts: tuple[str, ...], text: str, option: str) -> str:
    """Return a word that an option takes."""
    if text not in texts:
        expected = f"{', '.join(texts[:-1])} or {texts[-1]}"
        raise typer.BadParameter(f"expected {expected}; found {text!r}", param_hint=option)
    return text


def _processes(text: str) -> Processes:
    return cast("Processes", _one_of(get_args(Processes), text, "--processes"))


def _on_restart(text: str) -> Restart:
    return cast("Restart", _one_of(get_args(Restart), text, "--on-restart"))


def _speed(text: str) -> float | None:
    if text == "max":
        return None
    try:
        speed = float(text)
    except ValueError:
        speed = 0.0
    if not 0.01 <= speed <= 100.0:  # noqa: PLR2004 - beyond, nothing useful happens
        raise typer.BadParameter(f"expected a number from 0.01 to 100, or max; found {text!r}",
                                 param_hint="--speed")  # fmt: skip
    return speed


def _require_window(*, gui: bool, lockstep: bool) -> None:
    if not gui:
        return
    from tandem.executive.cli.display import require_display  # noqa: PLC0415

    if lockstep:
        raise CommandError("--gui: lockstep has no window; leave out --gui or --lockstep")
    require_display(os.environ)


def _metrics(text: str) -> str:
    from tandem.executive.telemetry.process import host_and_port  # noqa: PLC0415

    if not text:
        return text
    try:
        host_and_port(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="--metrics") from error
    return text


def _page(text: str, bus: BusOptions) -> str:
    lacks = words_on(WEB, "up --web")
    if lacks:
        raise CommandError(lacks)
    if bus.keys is not None:
        raise CommandError(
            "up --web: where keys are used the page shows the key of a person; "
            f"leave out --web, and run `tandem web --keys {bus.keys} --as NAME` beside it"
        )
    from tandem.executive.web.options import AddressError, checked_address  # noqa: PLC0415

    try:
        _, port = checked_address(text)
    except AddressError as error:
        raise CommandError(f"--web-at: {error}") from error
    if port == 0:
        raise CommandError("--web-at: expected a port other than 0, so that it can be told")
    return text


def _recorded_run(folder: Path | None, *, lockstep: bool) -> Path | None:
    if folder is None:
        return None
    if not lockstep:
        advice = "add --lockstep, or use `tandem up --record`"
        raise CommandError(f"--record-to: only a run in lockstep is recorded here; {advice}")
    return _recordings(folder, folder, ())


def _recordings(folder: Path | None, data: Path, roles: Sequence[str]) -> Path:
    from tandem.executive.records.boxes import FOLDER  # noqa: PLC0415
    from tandem.executive.system.roles.recorder import NAME  # noqa: PLC0415

    lacks = words_on(RECORD, "a recording")
    if lacks:
        raise CommandError(lacks)
    if roles and NAME not in roles:
        raise CommandError(f"up --record: expected {NAME} among the roles of --only; found {','.join(roles)}")
    chosen = folder or data / FOLDER
    try:
        chosen.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CommandError(f"--record-to {chosen}: {error.strerror}") from error
    return chosen


def _traces(text: str) -> str:
    if text and not text.startswith(("http://", "https://")):
        raise typer.BadParameter(
            f"expected a URL such as http://127.0.0.1:4318; found {text!r}", param_hint="--traces"
        )
    return text


def _scenario(name_or_path: str, site: str, faults: Path | None) -> str:
    """Return it when both are right; CommandError names the file, the path in it and what was expected."""
    from tandem.executive.cli.commands.scenario_commands import checked, checked_faults  # noqa: PLC0415

    scenario = checked(name_or_path, site)
    if faults is not None:
        checked_faults(faults, scenario)
    return name_or_path


def _logs(context: typer.Context) -> LogOptions:
    found = context.find_object(LogOptions)
    return found or LogOptions()
