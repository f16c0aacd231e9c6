"""``tandem campaign``: series of seeded runs; exit 1 when the aim is missed."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from tandem.executive.cli.arguments import OtherSite, OwnEndpoint
from tandem.executive.cli.commands.recorded_campaign import RecordPictures, RecordTo, recorded_runs
from tandem.executive.cli.commands.restart_command import restart
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.telling import told

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tandem.executive.trials.campaigns.crash import CrashCampaign, CrashRun
    from tandem.executive.trials.campaigns.crash_physics import PhysicsCampaign, PhysicsRun
    from tandem.executive.trials.campaigns.fetch import FetchRun
    from tandem.executive.trials.campaigns.fuzz_all import AllCounts
    from tandem.executive.trials.campaigns.recovery import RecoveryRun

Runs = Annotated[int, typer.Option("--runs", min=1, max=10_000, help="Number of runs.")]
Seed = Annotated[int, typer.Option("--seed", min=0, help="Seed for all random draws and noise.")]
Scenario = Annotated[
    str, typer.Option("--scenario", metavar="NAME|FILE", help="Scenario whose surfaces items are placed on.")
]
ReportFile = Annotated[
    Path | None, typer.Option("--report", metavar="FILE", help="Write all runs to this JSON file.")
]
Jobs = Annotated[int, typer.Option("--jobs", min=1, max=64, help="Number of parallel processes.")]
First = Annotated[
    int, typer.Option("--first", min=0, help="Number of the first run; use it to repeat a single run.")
]
RECOVERED_SHARE = 58 / 60
"""Of the runs that can be mended, as the aim has it."""


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    campaigns = typer.Typer(help="Run series of seeded trials against a target.", no_args_is_help=True)
    campaigns.command("fetch")(fetch)
    campaigns.command("recovery")(recovery)
    campaigns.command("crash")(crash)
    campaigns.command("restart")(restart)
    campaigns.command("fuzz")(fuzz)
    campaigns.command("soak")(soak)
    app.add_typer(campaigns, name="campaign")


def fetch(
    *,
    runs: Runs = 20,
    seed: Seed = 1,
    scenario: Scenario = "Demo",
    site: OtherSite = "",
    report: ReportFile = None,
    jobs: Jobs = 2,
    first: First = 0,
    record_to: RecordTo = None,
    record_pictures: RecordPictures = True,
) -> None:
    """Fetch random items from random start poses. Exits 0 only if every fetch succeeds in ground truth."""
    from tandem.executive.cli.commands.scenario_commands import checked  # noqa: PLC0415
    from tandem.executive.trials.campaigns.fetch import FetchCampaign, run_fetch  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import run_number, series  # noqa: PLC0415

    drawn_from = checked(scenario, site)
    console = Console(highlight=False, soft_wrap=True)
    done: list[FetchRun] = []
    recorded = recorded_runs("fetch", scenario, seed, record_to, pictures=record_pictures)
    work = partial(run_number, partial(run_fetch, drawn_from, seed, runs=recorded), first)
    for run in series(work, runs, jobs=jobs):
        done.append(run)
        _tell(run, console)
    done.sort(key=lambda each: each.run)
    right = sum(run.right for run in done)
    far = sum(run.unreachable for run in done)
    summary = [
        f"{right} of {runs} succeeded (seed {seed})",
        f"{far} of {runs + far} random free places were out of reach and were drawn again",
    ]
    campaign = FetchCampaign(scenario=scenario, seed=seed, right=right, unreachable=far, runs=tuple(done))
    told(console, report, summary, campaign)
    raise typer.Exit(ExitCode.OK if right == runs else ExitCode.TASK_FAILED)


def recovery(
    *,
    runs: Annotated[
        int, typer.Option("--runs", min=0, max=10_000, help="Number of runs that are recoverable.")
    ] = 60,
    hopeless: Annotated[
        int, typer.Option("--hopeless", min=0, max=10_000, help="Number of runs that are not.")
    ] = 20,
    seed: Seed = 1,
    scenario: Scenario = "Demo",
    site: OtherSite = "",
    report: ReportFile = None,
    jobs: Jobs = 2,
    first: First = 0,
    record_to: RecordTo = None,
    record_pictures: RecordPictures = True,
) -> None:
    """Fetch items while random faults strike.

    Exits 0 only if at least 58 of 60 recoverable runs end as they would without a fault, in ground truth,
    and every unrecoverable run ends at rest with the expected kind of failure. A run whose fault never
    struck counts as failed.
    """
    from tandem.executive.cli.commands.scenario_commands import checked  # noqa: PLC0415
    from tandem.executive.trials.campaigns.recovery import RecoveryCampaign, run_hopeless, run_recovery  # noqa: PLC0415
    from tandem.executive.trials.campaigns.series import run_number, series  # noqa: PLC0415

    drawn_from = checked(scenario, site)
    console = Console(highlight=False, soft_wrap=True)
    done: list[RecoveryRun] = []
    for count, what in ((runs, run_recovery), (hopeless, run_hopeless)):
        name = "recovery" if what is run_recovery else "hopeless"
        recorded = recorded_runs(name, scenario, seed, record_to, pictures=record_pictures)
        work = partial(run_number, partial(what, drawn_from, seed, runs=recorded), first)
        part: list[RecoveryRun] = []
        for run in series(work, count, jobs=jobs):
            part.append(run)
            _tell_recovery(run, console)
        done += sorted(part, key=lambda each: each.run)
    recovered = sum(run.right for run in done if not run.hopeless)
    right_kind = sum(run.right for run in done if run.hopeless)
    unstruck = sum(bool(run.unstruck) for run in done)
    summary = [
        f"{recovered} of {runs} recovered, {right_kind} of {hopeless} unrecoverable runs ended as expected"
    ]
    if unstruck:
        summary.append(f"{unstruck} of these count as failed because a fault never struck")
    campaign = RecoveryCampaign(
        scenario=scenario,
        seed=seed,
        recovered=recovered,
        recoverable=runs,
        right_kind=right_kind,
        hopeless=hopeless,
        unstruck=unstruck,
        runs=tuple(done),
    )
    told(console, report, summary, campaign)
    reached = recovered >= runs * RECOVERED_SHARE and right_kind == hopeless
    raise typer.Exit(ExitCode.OK if reached else ExitCode.TASK_FAILED)


def fuzz(
    *,
    inputs: Annotated[
        int, typer.Option("--inputs", min=1, max=100_000_000, help="Number of inputs.")
    ] = 100_000,
    seed: Seed = 1,
    report: ReportFile = None,
) -> None:
    """Send random documents to every topic that is served. Exits 0 only if each is answered or refused.

    Half of them go to the request interface of an executive, half to all topics of a system in lockstep.
    """
    from tandem.executive.trials.campaigns.fuzz import fuzz as run_fuzz  # noqa: PLC0415
    from tandem.executive.trials.campaigns.fuzz_all import fuzz_all  # noqa: PLC0415

    console = Console(highlight=False, soft_wrap=True)
    half = (inputs + 1) // 2
    counts = run_fuzz(half, seed, lambda fed: console.print(f"{fed} of {inputs}", end="\r"))
    if half < inputs and not counts.broken:
        every = fuzz_all(
            inputs - half, seed, lambda fed: console.print(f"{half + fed} of {inputs}", end="\r")
        )
        counts = counts.model_copy(update={"everywhere": every, "broken": every.broken})
    summary = [
        f"{counts.inputs} inputs (seed {seed})",
        f"requests: {counts.accepted} accepted, {counts.refused} refused",
        f"verbs: {counts.verbs_taken} accepted, {counts.verbs_refused} refused",
        f"questions: {counts.answered} answered, {counts.questions_refused} refused",
        *_everywhere(counts.everywhere),
        *(f"  {times:7d}  expected {reason}" for reason, times in counts.reasons.items()),
    ]
    told(console, report, summary, counts)
    if counts.broken:
        console.print(f"neither accepted nor refused: {counts.broken}", style="red", markup=False)
    raise typer.Exit(ExitCode.TASK_FAILED if counts.broken else ExitCode.OK)


def _everywhere(counts: AllCounts | None) -> list[str]:
    if counts is None:
        return []
    how = f"{counts.answered} answered, {counts.refused} refused with an error, {counts.silent} unanswered"
    return [f"on {len(counts.keys)} topics of all processes: {counts.inputs} inputs, {how}"]


def _tell_recovery(run: RecoveryRun, console: Console) -> None:
    mark = "ok  " if run.right else "FAIL"
    why = "" if run.failure is None else f"  {run.failure.where}: {run.failure.kind}: {run.failure.message}"
    console.print(
        f"{mark} {run.run:3d}  item {run.item:3d}  {run.trouble}: {run.robot_seconds:.1f} s  "
        f"{run.state.lower()}{why}",
        markup=False,
    )
    for unstruck in run.unstruck:
        console.print(f"         never struck: {unstruck}", markup=False)
    for wrong in run.wrong:
        console.print(f"         wrong in ground truth: {wrong}", markup=False)
    for struck in run.struck:
        console.print(f"         {struck}", markup=False)
    for each in run.tried:
        took = f"{each.recovery}, attempt {each.times}" if each.recovery else "given up"
        at = "" if each.at is None else f"{each.at.seconds:.1f} s"
        console.print(f"         {at}  {each.failure.where}: {each.failure.kind}: {took}", markup=False)


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
    for wrong in run.wrong:
        console.print(f"         {wrong}", markup=False)


def crash(
    *,
    runs: Annotated[
        int | None,
        typer.Option("--runs", min=0, max=10_000, help="Number of runs. Default: 200, or 20 with --physics."),
    ] = None,
    seed: Seed = 1,
    first: First = 0,
    points: Annotated[
        bool, typer.Option("--points/--no-points", help="Also kill at each point where it writes or sends.")
    ] = True,
    verbs: Annotated[
        bool, typer.Option("--verbs/--no-verbs", help="Also kill between each command and its effect.")
    ] = True,
    physics: Annotated[
        bool,
        typer.Option(
            "--physics", help="Use real skills and physics, with one kill in each phase of two tasks in turn."
        ),
    ] = False,
    report: ReportFile = None,
    connect: OwnEndpoint = "tcp/127.0.0.1:7449",
) -> None:
    """Kill and restart processes. Exits 0 only if nothing is lost, duplicated or stuck."""
    import tempfile  # noqa: PLC0415

    console = Console(highlight=False, soft_wrap=True)
    with tempfile.TemporaryDirectory(prefix="tandem-crash-") as folder:
        if physics:
            made: CrashCampaign | PhysicsCampaign = _in_physics(
                Path(folder), connect, 20 if runs is None else runs, console, seed=seed, first=first
            )
        else:
            many = 200 if runs is None else runs
            made = _mocked(
                Path(folder), connect, many, console, seed=seed, first=first, points=points, verbs=verbs
            )
    told(console, report, [f"{made.right} of {len(made.runs)} succeeded (seed {seed})"], made)
    raise typer.Exit(ExitCode.OK if made.right == len(made.runs) else ExitCode.TASK_FAILED)


def _mocked(
    folder: Path,
    connect: str,
    runs: int,
    console: Console,
    *,
    seed: int,
    first: int,
    points: bool,
    verbs: bool,
) -> CrashCampaign:
    from tandem.executive.trials.campaigns.crash import CrashCampaign, crash_points, crash_runs, point_runs  # noqa: PLC0415
    from tandem.executive.trials.campaigns.crash_verbs import verb_runs  # noqa: PLC0415

    done: list[CrashRun] = []

    def take(made: Iterable[CrashRun]) -> None:
        for run in made:
            done.append(run)
            console.print(_crash_line(run), markup=False)

    take(crash_runs(folder / "random", connect, runs, seed, first=first))
    if points:
        named = crash_points(folder / "found", connect)
        take(point_runs(folder / "points", connect, named))
    if verbs:
        take(verb_runs(folder / "verbs", connect))
    return CrashCampaign(seed=seed, right=sum(not run.wrong for run in done), runs=tuple(done))


def _in_physics(
    folder: Path, connect: str, runs: int, console: Console, *, seed: int, first: int
) -> PhysicsCampaign:
    from tandem.executive.system.systems import RefusedError  # noqa: PLC0415
    from tandem.executive.trials.campaigns.crash_physics import PhysicsCampaign, physics_runs  # noqa: PLC0415

    done: list[PhysicsRun] = []
    try:
        for run in physics_runs(folder, connect, runs, seed, first=first):
            done.append(run)
            console.print(_physics_line(run), markup=False)
    except RefusedError as error:
        raise CommandError(str(error)) from error
    return PhysicsCampaign(seed=seed, right=sum(not run.wrong for run in done), runs=tuple(done))


def _physics_line(run: PhysicsRun) -> str:
    at = "never" if run.killed_at is None else f"at {run.killed_at:.2f} s"
    end = "ok" if not run.wrong else "WRONG: " + "; ".join(run.wrong)
    why = "" if run.failure is None else f" ({run.failure.kind}: {run.failure.message})"
    return (
        f"{run.run:4d}  {run.seconds:6.2f} s  starts {run.begun}  {run.kind}, {run.phase}: "
        f"{run.victim} killed {at}, in '{run.leaf}': {end}{why}"
    )


def _crash_line(run: CrashRun) -> str:
    kills = ", ".join(f"{kill.victim} at {kill.after:.2f} s" for kill in run.kills)
    how = f"{run.point} ({'killed there' if kills else 'never reached'})" if run.point else kills
    end = "ok" if not run.wrong else "WRONG: " + "; ".join(run.wrong)
    return f"{run.run:4d}  {run.seconds:6.2f} s  starts {run.begun}  {how}: {end}"


def soak(
    *,
    tasks: Annotated[int, typer.Option("--tasks", min=1, max=1_000_000, help="Number of tasks.")] = 2000,
    warm_up: Annotated[
        int, typer.Option("--warm-up", min=0, max=1_000_000, help="Warm-up tasks before growth is measured.")
    ] = 200,
    report: ReportFile = None,
    connect: OwnEndpoint = "tcp/127.0.0.1:7450",
    metrics: Annotated[
        str, typer.Option("--metrics", metavar="HOST:PORT", help="Address that the metrics are served on.")
    ] = "127.0.0.1:9465",
) -> None:
    """Run many mocked tasks. Exits 0 only if no process grows and no handle or thread is left open."""
    import tempfile  # noqa: PLC0415

    from tandem.executive.system.systems import RefusedError, SystemFailure  # noqa: PLC0415
    from tandem.executive.trials.campaigns.soak import run_soak  # noqa: PLC0415

    console = Console(highlight=False, soft_wrap=True)

    def tell(done: int) -> None:
        console.print(f"{done} of {tasks}", end="\r")

    with tempfile.TemporaryDirectory(prefix="tandem-soak-") as folder:
        try:
            made = run_soak(Path(folder), connect, tasks, metrics=metrics, tell=tell, warm_up=warm_up)
        except (RefusedError, SystemFailure) as error:
            raise CommandError(str(error)) from error
    states = ", ".join(f"{count} {state.lower()}" for state, count in sorted(made.ended.items()))
    summary = [
        *(
            f"{each.role:12} {each.memory:7.2f} MB, grew by {each.growth:5.2f}; "
            f"handles {each.handles[0]} to {each.handles[1]}, threads {each.threads[0]} to {each.threads[1]}"
            for each in made.processes
        ),
        f"ledger: {made.ledger_bytes_a_task / 1000:.1f} kB per task",
        f"{made.tasks} tasks: {states}",
        *(f"WRONG: {wrong}" for wrong in made.wrong),
    ]
    told(console, report, summary, made)
    raise typer.Exit(ExitCode.TASK_FAILED if made.wrong else ExitCode.OK)
