"""``tandem experiment picking``: fetches timed by the order-picking paper's phases, and its figures."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from tandem.executive.cli.commands.campaign_command import First, Jobs, ReportFile, Seed
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.telling import told

if TYPE_CHECKING:
    from tandem.executive.trials.picking.settings import PickingRun


def picking(
    *,
    arm_fails: Annotated[
        bool,
        typer.Option("--arm-fails/--sound", help="Let the hand be stuck at first, so that Fig. 4 happens."),
    ] = False,
    runs: Annotated[int, typer.Option("--runs", min=1, max=10_000, help="Number of runs.")] = 6,
    seed: Seed = 1,
    report: ReportFile = None,
    figures: Annotated[
        Path | None,
        typer.Option("--figures", metavar="DIR", help="Draw each run into this folder, as SVG and WebP."),
    ] = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Let a LoCoBot search, pick and place. Order-picking paper, III-A and IV."""
    from tandem.executive.trials.campaigns.series import run_number  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import series as in_series  # noqa: PLC0415
    from tandem.executive.trials.picking.run import run_picking  # noqa: PLC0415
    from tandem.executive.trials.picking.settings import PickingExperiment, PickingOptions  # noqa: PLC0415
    from tandem.executive.trials.picking.summary import summary  # noqa: PLC0415

    options = PickingOptions(seed=seed, arm_fails=arm_fails)
    console = Console(highlight=False, soft_wrap=True)
    done: list[PickingRun] = []
    work = partial(run_number, partial(run_picking, options, figures), first)
    for run in in_series(work, runs, jobs=jobs):
        done.append(run)
        console.print(_line(run), markup=False)
    done.sort(key=lambda each: each.run)
    told(console, report, summary(options, done), PickingExperiment(options=options, runs=tuple(done)))
    raise typer.Exit(ExitCode.OK if all(run.right for run in done) else ExitCode.TASK_FAILED)


def _line(run: PickingRun) -> str:
    why = "" if run.failure is None else f"  {run.failure.kind}: {run.failure.message}"
    wrong = "".join(f"  {each}" for each in run.wrong)
    return (
        f"{'ok  ' if run.right else 'FAIL'} {run.run:3d}  item {run.item:3d}  {run.lasted:6.1f} s"
        f"  {run.state.lower()}{why}{wrong}"
    )
