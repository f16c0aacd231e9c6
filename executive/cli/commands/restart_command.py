"""``tandem campaign restart``: the hardware is killed, and the next fetch must succeed; exit 1 otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from tandem.executive.cli.arguments import OwnEndpoint
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.telling import told

if TYPE_CHECKING:
    from tandem.executive.trials.campaigns.hardware_restart import RestartRun


def restart(
    *,
    runs: Annotated[int, typer.Option("--runs", min=0, max=10_000, help="Number of kills.")] = 10,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed for all noise.")] = 1,
    first: Annotated[
        int, typer.Option("--first", min=0, help="Number of the first run; use it to repeat a single run.")
    ] = 0,
    report: Annotated[
        Path | None, typer.Option("--report", metavar="FILE", help="Write all runs to this JSON file.")
    ] = None,
    connect: OwnEndpoint = "tcp/127.0.0.1:7449",
) -> None:
    """Kill the hardware process while skills run, at rest and in each phase of a fetch.

    Exits 0 only if the next fetch after each kill succeeds in ground truth.
    """
    import tempfile  # noqa: PLC0415

    from tandem.executive.system.systems import RefusedError  # noqa: PLC0415
    from tandem.executive.trials.campaigns.hardware_restart import RestartCampaign, restart_runs  # noqa: PLC0415

    console = Console(highlight=False, soft_wrap=True)
    done: list[RestartRun] = []
    with tempfile.TemporaryDirectory(prefix="tandem-restart-") as folder:
        try:
            for run in restart_runs(Path(folder), connect, runs, seed, first=first):
                done.append(run)
                console.print(_restart_line(run), markup=False)
        except RefusedError as error:
            raise CommandError(str(error)) from error
    right = sum(not run.wrong for run in done)
    campaign = RestartCampaign(seed=seed, right=right, runs=tuple(done))
    told(console, report, [f"{right} of {runs} succeeded (seed {seed})"], campaign)
    raise typer.Exit(ExitCode.OK if right == runs else ExitCode.TASK_FAILED)


def _restart_line(run: RestartRun) -> str:
    where = f"in '{run.leaf}'" if run.leaf else "at rest"
    at = "never" if run.killed_at is None else f"at {run.killed_at:.2f} s"
    kind = "" if run.kind is None else f" ({run.kind})"
    cost = f"; that fetch {run.interrupted.lower()}{kind}" if run.interrupted else ""
    end = "ok" if not run.wrong else "WRONG: " + "; ".join(run.wrong)
    return (
        f"{run.run:4d}  killed {where} {at}, back after {run.back_after:.1f} s{cost}; "
        f"the next fetch {run.state.lower() or 'never ended'}: {end}"
    )
