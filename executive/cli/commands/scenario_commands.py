"""``tandem scenario``: lists the scenarios, and checks one of your own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json, OtherSite
from tandem.executive.cli.completing import scenarios

if TYPE_CHECKING:
    from tandem.executive.cli.shapes import ScenarioFacts
    from tandem.executive.config.fault_file import FaultFile
    from tandem.sim.scenario import Scenario


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(help="List and check scenarios of the simulation.", no_args_is_help=True)
    group.command("list")(list_all)
    group.command("check")(check)
    app.add_typer(group, name="scenario")


def list_all(*, as_json: Json = False) -> None:
    """List the scenarios that come with Tandem."""
    if as_json:
        _print_list()
        return
    from rich.console import Console  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    from tandem.sim.scenario import load_scenario, scenario_names  # noqa: PLC0415

    table = Table("name", "site", "items", "obstacles", "robot starts at", box=None)
    for name in scenario_names():
        scenario = load_scenario(name)
        start = "; ".join(
            f"({at.x:g}, {at.y:g}), {at.yaw:.2f} rad" for at in (each.start for each in scenario.placed)
        )
        tags = " ".join(str(item.item) for item in scenario.items)
        table.add_row(name, scenario.site, tags, str(len(scenario.obstacles)), start)
    Console().print(table)


def check(
    file: Annotated[
        str, typer.Argument(metavar="FILE|NAME", help="A YAML file or a name.", autocompletion=scenarios)
    ],
    *,
    faults: Annotated[
        Path | None, typer.Option("--faults", metavar="FILE", help="Also check this fault file.")
    ] = None,
    site: OtherSite = "",
    as_json: Json = False,
) -> None:
    """Check a scenario against its schema and its site. Exits 2 if it is invalid."""
    scenario = checked(file, site)
    more = None if faults is None else checked_faults(faults, scenario)
    if as_json:
        _print_checked(scenario, more)
        return
    typer.echo(
        f"{file}: valid scenario: {scenario.name}, {len(scenario.items)} items, "
        f"{len(scenario.obstacles)} obstacles, {len(scenario.faults)} faults, site {scenario.site}"
    )
    if more is not None:
        bus = "no bus faults" if more.bus is None else "a faulty bus"
        typer.echo(f"{faults}: valid faults: {len(more.faults)} of robot and room, {bus}")


def _print_list() -> None:
    from tandem.executive.cli.shapes import ScenarioList, print_json  # noqa: PLC0415
    from tandem.sim.scenario import load_scenario, scenario_names  # noqa: PLC0415

    print_json(ScenarioList(scenarios=tuple(_facts(load_scenario(name)) for name in scenario_names())))


def _print_checked(scenario: Scenario, more: FaultFile | None) -> None:
    from tandem.executive.cli.shapes import ScenarioChecked, print_json  # noqa: PLC0415

    faults = None if more is None else len(more.faults)
    bus_faults = more is not None and more.bus is not None
    print_json(ScenarioChecked(scenario=_facts(scenario), faults=faults, bus_faults=bus_faults))


def _facts(scenario: Scenario) -> ScenarioFacts:
    from tandem.executive.cli.shapes import ScenarioFacts  # noqa: PLC0415

    return ScenarioFacts(
        name=scenario.name,
        site=scenario.site,
        items=tuple(item.item for item in scenario.items),
        obstacles=len(scenario.obstacles),
        faults=len(scenario.faults),
    )


def checked(name_or_path: str, site: str = "") -> Scenario:
    """Return the scenario, in another site than its own when one is named.

    Raises:
        DocumentError: naming the file, the path and line in it, and what was expected.
    """
    from tandem.sim.scenario import read_scenario  # noqa: PLC0415
    from tandem.sim.scene import build_scene  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415

    scenario, source = read_scenario(name_or_path, site)
    build_scene(load(scenario.site), scenario, source=source)
    return scenario


def checked_faults(path: Path, scenario: Scenario) -> FaultFile:
    """Return a file of faults that fits a scenario's site.

    Raises:
        DocumentError: naming the file, the path and line in it, and what was expected.
    """
    from tandem.executive.config.fault_file import check_faults  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415

    return check_faults(path, load(scenario.site), scenario.robots_by_name)
