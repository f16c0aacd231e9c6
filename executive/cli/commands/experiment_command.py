"""``tandem experiment``: the experiments of the papers; exit 1 when the aim is missed.

Two-arm thesis, chapter 5; RoCS paper, 6.3 to 6.5. ``crossings_command`` and ``picking_command`` have the
order-picking paper's.
"""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from tandem.executive.cli.commands.campaign_command import First, Jobs, ReportFile, Seed
from tandem.executive.cli.commands.crossings_command import crossings
from tandem.executive.cli.commands.picking_command import picking
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.telling import told

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tandem.executive.trials.experiments.run import ExperimentRun
    from tandem.executive.trials.experiments.settings import Kind, Options
    from tandem.executive.trials.rocs.run import RocsRun


class Method(StrEnum):
    """How the hands get before their items."""

    APF_RRTCONNECT = "apf_rrtconnect"
    RRTCONNECT = "rrtconnect"
    RRTCONNECT_REPLAN = "rrtconnect_replan"


class Mode(StrEnum):
    """When a stopped arm continues."""

    FAITHFUL = "faithful"
    EAGER = "eager"


class Series(StrEnum):
    """Phase in which the objects are moved."""

    FIELD = "field"
    GRASP = "grasp"


class SightSource(StrEnum):
    """As ``tandem.skills.ports.actions.base.FollowSource``, which is not loaded for a command's help."""

    SENSOR = "sensor"
    BELIEF = "belief"


class Route(StrEnum):
    """Which routes from sensing to acting there are."""

    BOTH = "both"
    DELIBERATIVE = "deliberative"
    REACTIVE = "reactive"


Runs = Annotated[int, typer.Option("--runs", min=1, max=10_000, help="Number of runs.")]
How = Annotated[Method, typer.Option("--method", help="Method: the one of the thesis, or a baseline.")]
When = Annotated[Mode, typer.Option("--mode", help="When a stopped arm continues.")]
Phase = Annotated[Series, typer.Option("--series", help="Phase in which the objects are moved.")]
Dual = Annotated[
    bool, typer.Option("--dual/--sequential", help="Move both arms at once, or one after the other.")
]
Figures = Annotated[
    Path | None,
    typer.Option("--figures", metavar="DIR", help="Write a drawing of the paths to this SVG file."),
]


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    group = typer.Typer(help="Run the experiments of the papers in lockstep.", no_args_is_help=True)
    for command in (uncoordinated, crossing, coordinated, rocs, crossings, picking):
        group.command(command.__name__)(command)
    app.add_typer(group, name="experiment")


def uncoordinated(
    *,
    method: How = Method.APF_RRTCONNECT,
    dual: Dual = True,
    mode: When = Mode.EAGER,
    series: Phase = Series.FIELD,
    runs: Runs = 60,
    seed: Seed = 1,
    report: ReportFile = None,
    figures: Figures = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Pick a cube with each hand, in three positions, while both cubes move. Tables 5.1 to 5.3."""
    _run("uncoordinated", method, dual, mode, series, runs, seed, report, figures, jobs, first)


def crossing(
    *,
    method: How = Method.APF_RRTCONNECT,
    dual: Dual = True,
    mode: When = Mode.EAGER,
    series: Phase = Series.FIELD,
    runs: Runs = 60,
    seed: Seed = 1,
    report: ReportFile = None,
    figures: Figures = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Pick a cube with each hand across the other arm, while both cubes move. Tables 5.4 and 5.5."""
    _run("crossing", method, dual, mode, series, runs, seed, report, figures, jobs, first)


def coordinated(
    *,
    method: How = Method.APF_RRTCONNECT,
    mode: When = Mode.EAGER,
    series: Phase = Series.FIELD,
    runs: Runs = 60,
    seed: Seed = 1,
    report: ReportFile = None,
    figures: Figures = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Lift a carton with both hands while it moves. Tables 5.6 and 5.7."""
    _run("coordinated", method, True, mode, series, runs, seed, report, figures, jobs, first)


def rocs(
    *,
    case: Annotated[
        int,
        typer.Option("--case", min=1, max=3, help="EXP1, EXP2 or EXP3 of the paper."),
    ] = 1,
    route: Annotated[
        Route,
        typer.Option("--route", help="Both routes, or a baseline: without the reflex, or by reflexes alone."),
    ] = Route.BOTH,
    source: Annotated[
        SightSource,
        typer.Option(
            "--source", help="EXP3: the follower sees the other, or is told where that believes to be."
        ),
    ] = SightSource.SENSOR,
    runs: Runs = 60,
    seed: Seed = 1,
    report: ReportFile = None,
    figures: Annotated[
        Path | None, typer.Option("--figures", metavar="DIR", help="Draw each run into this folder, as SVG.")
    ] = None,
    jobs: Jobs = 2,
    first: First = 0,
) -> None:
    """Go to a place that no plan knows the way to, or follow who goes. RoCS paper, 6.3 to 6.5."""
    from tandem.executive.trials.campaigns.series import run_number  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import series as in_series  # noqa: PLC0415
    from tandem.executive.trials.rocs.figures import figure  # noqa: PLC0415
    from tandem.executive.trials.rocs.run import RocsExperiment, run_rocs  # noqa: PLC0415
    from tandem.executive.trials.rocs.settings import RocsOptions  # noqa: PLC0415
    from tandem.executive.trials.rocs.summary import summary  # noqa: PLC0415

    if route is Route.REACTIVE and case == 3:  # noqa: PLR2004 - a place after the other is a plan
        raise CommandError("--route reactive: expected --case 1 or 2; corners in order are a plan")
    options = RocsOptions.model_validate(
        {"case": case, "route": route.value, "source": source.value, "seed": seed}
    )
    console = Console(highlight=False, soft_wrap=True)
    done: list[RocsRun] = []
    for run in in_series(partial(run_number, partial(run_rocs, options), first), runs, jobs=jobs):
        done.append(run)
        _tell_rocs(run, console)
        if figures is not None:
            figures.mkdir(parents=True, exist_ok=True)
            title = f"EXP{case}, route {route.value}, seed {seed}, run {run.run}: {run.state.lower()}"
            of = f"-{source.value}" if case == 3 else ""  # noqa: PLR2004 - EXP3 alone has a follower
            path = figures / f"rocs-{case}-{route.value}{of}-{run.run}.svg"
            path.write_text(figure(run, title), encoding="utf-8")
    done.sort(key=lambda each: each.run)
    told(console, report, summary(options, done), RocsExperiment(options=options, runs=tuple(done)))
    raise typer.Exit(ExitCode.OK if all(run.reached for run in done) else ExitCode.TASK_FAILED)


def _tell_rocs(run: RocsRun, console: Console) -> None:
    why = "" if run.failure is None else f"  {run.failure.kind}: {run.failure.message}"
    touched = "".join(
        f"  {bump.robot} touches {bump.what} at {bump.at:.1f} s"
        f"{', standing' if bump.stood else ', unseen' if bump.unseen else ''}"
        for bump in run.bumps
    )
    console.print(
        f"{'ok  ' if run.reached else 'FAIL'} {run.run:3d}  {run.lasted:6.1f} s  {_judged(run)}"
        f"  reactive {run.reactive:.2f}  new plans {run.replans}  {run.state.lower()}{why}{touched}",
        markup=False,
    )


def _judged(run: RocsRun) -> str:
    if run.kept is not None:
        return f"{run.kept:.2f} of the time at its distance"
    return f"{run.off_goal} m off"


def _run(  # noqa: PLR0917 - the command's options, in their order
    kind: Kind,
    method: Method,
    dual: bool,  # noqa: FBT001 - as above
    mode: Mode,
    series: Series,
    runs: int,
    seed: int,
    report: Path | None,
    figures: Path | None,
    jobs: int,
    first: int,
) -> None:
    from tandem.executive.trials.campaigns.series import run_number  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import series as in_series  # noqa: PLC0415
    from tandem.executive.trials.experiments.run import Experiment, run_experiment  # noqa: PLC0415
    from tandem.executive.trials.experiments.settings import Options  # noqa: PLC0415
    from tandem.executive.trials.experiments.tables import picked  # noqa: PLC0415

    options = Options(
        kind=kind,
        method=method.value,
        sequential=not dual,
        mode=mode.value,
        series=series.value,
        seed=seed,
    )
    console = Console(highlight=False, soft_wrap=True)
    done: list[ExperimentRun] = []
    work = partial(run_number, partial(run_experiment, options), first)
    for run in in_series(work, runs, jobs=jobs):
        done.append(run)
        _tell(run, console)
    done.sort(key=lambda each: each.run)
    if figures is not None:
        _draw(options, done, figures)
    untouched = not any(run.touches for run in done)
    reached = picked(done) == runs and untouched
    summary = [*_tables(options, done), f"{picked(done)} of {runs} succeeded with both arms (seed {seed})"]
    told(console, report, summary, Experiment(options=options, runs=tuple(done)))
    raise typer.Exit(ExitCode.OK if reached else ExitCode.TASK_FAILED)


def _tell(run: ExperimentRun, console: Console) -> None:
    mark = "ok  " if run.left.pick and run.right.pick else "FAIL"
    why = "" if run.failure is None else f"  {run.failure.where}: {run.failure.kind}: {run.failure.message}"
    console.print(
        f"{mark} {run.run:3d}  position {run.position}  left {'ok' if run.left.pick else 'no'}"
        f"  right {'ok' if run.right.pick else 'no'}  {run.total_s:6.1f} s  moved {len(run.moved)}"
        f"  stops {run.stops}  touches {len(run.touches)}  {run.state.lower()}{why}",
        markup=False,
    )


def _tables(options: Options, runs: Sequence[ExperimentRun]) -> Iterator[str]:
    """Yield the lines of the tables: what, here, in the thesis."""
    from tandem.executive.trials.experiments.tables import tables  # noqa: PLC0415

    for title, rows in tables(options, runs):
        whats, ours, theirs = zip(("", "here", "thesis"), *rows, strict=True)
        widths = [max(map(len, column)) for column in (whats, ours, theirs)]
        yield title
        for row in zip(whats, ours, theirs, strict=True):
            yield "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        yield ""


def _draw(options: Options, runs: Sequence[ExperimentRun], folder: Path) -> None:
    from tandem.executive.trials.experiments.figures import figure, from_above, in_space  # noqa: PLC0415

    folder.mkdir(parents=True, exist_ok=True)
    for name, flat in (("2d", from_above), ("3d", in_space)):
        title = f"{options.kind}, {options.method}, {len(runs)} runs"
        path = folder / f"{options.kind}-{options.method}-{name}.svg"
        path.write_text(figure(title, runs, flat), encoding="utf-8")
