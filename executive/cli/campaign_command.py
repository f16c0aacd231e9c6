"""``tandem campaign``: series of seeded runs; exit 1 when the aim is missed."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from executive.cli.exit_codes import ExitCode

if TYPE_CHECKING:
    from executive.campaigns.fetch import FetchRun

Runs = Annotated[int, typer.Option("--runs", min=1, max=10_000, help="How many.")]
Seed = Annotated[int, typer.Option("--seed", min=0, help="Of all draws and all noise.")]
Scenario = Annotated[
    str, typer.Option("--scenario", metavar="NAME|FILE", help="Its surfaces are drawn from.")
]
ReportFile = Annotated[
    Path | None, typer.Option("--report", metavar="FILE", help="Write the runs here (JSON).")
]
Jobs = Annotated[int, typer.Option("--jobs", min=1, max=64, help="Processes beside each other.")]
First = Annotated[int, typer.Option("--first", min=0, help="Number of the first run: repeats a run alone.")]


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    campaigns = typer.Typer(
        help="Series of seeded runs in lockstep, each with its aim.", no_args_is_help=True
    )
    campaigns.command("fetch")(fetch)
    app.add_typer(campaigns, name="campaign")


def fetch(
    *,
    runs: Runs = 20,
    seed: Seed = 1,
    scenario: Scenario = "Demo",
    report: ReportFile = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Fetch drawn items from drawn starts. Ends with 0 only when every fetch is right, in truth."""
    from executive.campaigns.fetch import FetchCampaign, run_fetch, run_number  # noqa: PLC0415
    from executive.campaigns.series import series  # noqa: PLC0415
    from executive.cli.scenario_commands import checked  # noqa: PLC0415

    drawn_from = checked(scenario)
    console = Console(highlight=False, soft_wrap=True)
    done: list[FetchRun] = []
    work = partial(run_number, partial(run_fetch, drawn_from, seed), first)
    for run in series(work, runs, jobs=jobs):
        done.append(run)
        _tell(run, console)
    done.sort(key=lambda each: each.run)
    right = sum(run.right for run in done)
    console.print(f"{right} of {runs} right (seed {seed})")
    if report is not None:
        report.parent.mkdir(parents=True, exist_ok=True)
        campaign = FetchCampaign(scenario=scenario, seed=seed, right=right, runs=tuple(done))
        report.write_text(campaign.model_dump_json(indent=2) + "\n", encoding="utf-8")
    raise typer.Exit(ExitCode.OK if right == runs else ExitCode.TASK_FAILED)


def _tell(run: FetchRun, console: Console) -> None:
    for rejected in run.rejected:
        console.print(f"  {run.run:3d}  drawn again: {rejected}", markup=False)
    why = "" if run.failure is None else f"  {run.failure.where}: {run.failure.kind}: {run.failure.message}"
    mark = "ok  " if run.right else "FAIL"
    start = f"({run.start.x:5.2f}, {run.start.y:5.2f}, {run.start.yaw:5.2f})"
    place = f"({run.place.x:5.2f}, {run.place.y:5.2f}, {run.place.yaw:5.2f})"
    console.print(
        f"{mark} {run.run:3d}  item {run.item:3d} at {place} from {start}  "
        f"{run.robot_seconds:6.1f} s  {run.state.lower()}{why}",
        markup=False,
    )
