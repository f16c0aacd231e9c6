"""``tandem demo`` and ``tandem up``."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import NoReturn

import typer

from tandem.executive.cli.arguments import OtherSite, connects
from tandem.executive.cli.commands.stop_commands import person
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.option_checks import (
    checked_scenario,
    folder_of_recordings,
    metrics_address,
    on_restart_of,
    page_address,
    processes_of,
    require_window,
    traces_address,
)
from tandem.executive.cli.system_options import (
    PAGE_AT,
    Data,
    Faults,
    Insecure,
    Listen,
    Lockstep,
    MetricsAt,
    Only,
    OnRestart,
    Page,
    PageAt,
    ProcessesOption,
    Record,
    RecordPictures,
    RecordTo,
    ReportFile,
    Scenario,
    Seed,
    SilentAfter,
    Speed,
    TracesTo,
    Window,
    simulation_options,
    starts_system,
)
from tandem.executive.config.run_options import BusOptions, RunOptions, default_data
from tandem.skills.wire.pulse import SILENT_AFTER


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("demo")(starts_system(demo))
    app.command("up")(connects(up))


def demo(*, options: RunOptions) -> None:
    """Start a simulated robot, fetch an item and stop. Exits 0 only if the item really is in the depot."""
    from tandem.executive.cli.running_system import run_demo  # noqa: PLC0415 - loads the whole system

    raise typer.Exit(run_demo(options))


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
    web_at: PageAt = None,
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

    if lockstep:
        raise CommandError(
            "up --lockstep: lockstep has its own bus that no client can reach; "
            "use `tandem demo --lockstep`, or leave out --lockstep"
        )
    require_window(gui=gui, lockstep=False)
    broken = broken_plugins()
    several = checked_scenario(scenario, site, faults).robots_on_the_bus
    bus = owner_of(bus, several, by_environment=_by_environment(context))
    roles = checked_roles(only, {each.plugin.key: each.error for each in broken})
    refuse_without_extras(roles)
    folder = data or default_data(bus, os.environ)
    simulated = simulation_options(
        context,
        bus,
        scenario=scenario,
        site=site,
        faults=faults,
        seed=seed,
        speed=speed,
        gui=gui,
        report=report,
    )
    routes, records = not roles or "router" in roles, record or record_to is not None
    _keep_up(
        replace(
            simulated,
            data=folder,
            on_restart=on_restart_of(on_restart),
            metrics=metrics_address(metrics),
            traces=traces_address(traces),
            web=page_address(web_at or PAGE_AT, bus, several) if web or web_at is not None else "",
            black_box=True,
            record=folder_of_recordings(record_to, folder, roles) if records else None,
            record_pictures=record_pictures,
            commit=checkout()[0],
            person=person(bus),
            silent_after=silent_after,
            listen=checked_endpoints(bus, listen or (), insecure=insecure) if routes else (),
            only=roles,
            processes=processes_of(processes),
            broken=broken,
        )
    )


def _keep_up(options: RunOptions) -> NoReturn:
    """Run it to its end; a nursery begins to load first, for the processes to be born from."""
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
