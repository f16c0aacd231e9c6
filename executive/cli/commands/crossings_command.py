"""``tandem experiment crossings``: drives among people, without them, and with another planner."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from tandem.executive.cli.commands.campaign_command import First, Jobs, ReportFile, Seed
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.telling import told

if TYPE_CHECKING:
    from tandem.executive.trials.crossings.settings import CrossingRun, Drive


class LocalPlanner(StrEnum):
    """As ``tandem.skills.ports.site.LocalPlanner``, which is not loaded for a command's help."""

    BAND = "band"
    PEOPLE = "people"
    PURSUIT = "pursuit"


def crossings(
    *,
    planner: Annotated[
        LocalPlanner, typer.Option("--planner", help="Local planner of the base.")
    ] = LocalPlanner.PEOPLE,
    baselines: Annotated[
        bool,
        typer.Option(
            "--baselines/--no-baselines", help="Drive without people, and with the planner pursuit, too."
        ),
    ] = True,
    runs: Annotated[int, typer.Option("--runs", min=1, max=10_000, help="Number of runs.")] = 100,
    seed: Seed = 1,
    report: ReportFile = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Drive a LoCoBot across the paths of people. Order-picking paper, IV."""
    from tandem.executive.trials.campaigns.series import run_number  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import series as in_series  # noqa: PLC0415
    from tandem.executive.trials.crossings.run import run_crossing  # noqa: PLC0415
    from tandem.executive.trials.crossings.settings import (  # noqa: PLC0415
        CrossingExperiment,
        CrossingOptions,
    )
    from tandem.executive.trials.crossings.summary import summary  # noqa: PLC0415

    options = CrossingOptions(planner=planner.value, seed=seed, baselines=baselines)
    console = Console(highlight=False, soft_wrap=True)
    done: list[CrossingRun] = []
    for run in in_series(partial(run_number, partial(run_crossing, options), first), runs, jobs=jobs):
        done.append(run)
        for drive in run.drives:
            console.print(_line(run, drive), markup=False)
    done.sort(key=lambda each: each.run)
    told(console, report, summary(options, done), CrossingExperiment(options=options, runs=tuple(done)))
    raise typer.Exit(ExitCode.OK if all(run.reached for run in done) else ExitCode.TASK_FAILED)


def _line(run: CrossingRun, drive: Drive) -> str:
    mark = "ok  " if drive.state == "SUCCEEDED" and not drive.caused else "FAIL"
    why = "" if drive.failure is None else f"  {drive.failure.kind}: {drive.failure.message}"
    touched = "".join(
        f"  touches {each.person} at {each.at:.1f} s, having stood {each.stood:.1f} s"
        for each in drive.touches
    )
    near = "" if drive.what == "alone" else f"  near {drive.near:4.1f} s, nearest {drive.nearest:.2f} m"
    return (
        f"{mark} {run.run:3d}  {drive.what:<8}  {drive.lasted:5.1f} s{near}"
        f"  {drive.state.lower()}{why}{touched}"
    )
