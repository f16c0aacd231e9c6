"""``tandem replay --again``: a run in lockstep once more, held to its record."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode

if TYPE_CHECKING:
    from tandem.executive.records.recording import Recording


def run_again(record: Recording, at: float | None) -> ExitCode:
    """Repeat a run up to a moment, and say whether it is as recorded.

    Args:
        record: of the run.
        at: robot seconds of the moment; None: the record's end.
    """
    facts = record.facts
    if not facts.lockstep:
        advice = "`tandem demo --lockstep --record-to DIR` records one"
        raise CommandError(f"{record.path}: expected a run in lockstep, found one in real time; {advice}")
    from tandem.executive.trials.provenance import checkout  # noqa: PLC0415
    from tandem.executive.trials.recorded_lockstep import ReachedError  # noqa: PLC0415

    here = checkout()[0]
    if here and facts.commit and here != facts.commit:
        typer.echo(
            f"the record is of commit {facts.commit[:10]}, this is {here[:10]}: what it says may differ"
        )

    until = record.span.end if at is None else at
    try:
        return _campaign(record, until) if facts.campaign else _demo(record, until)
    except ReachedError as reached:
        typer.echo(reached.words)
        return ExitCode.OK if reached.same else ExitCode.TASK_FAILED


def _campaign(record: Recording, until: float) -> ExitCode:
    from tandem.executive.cli.commands.scenario_commands import checked  # noqa: PLC0415
    from tandem.executive.trials.campaigns.fetch import run_fetch  # noqa: PLC0415
    from tandem.executive.trials.campaigns.recording import HeldRuns  # noqa: PLC0415
    from tandem.executive.trials.campaigns.recovery import run_hopeless, run_recovery  # noqa: PLC0415

    facts, runs = record.facts, HeldRuns(record, until)
    scenario = checked(facts.scenario)
    if facts.campaign == "fetch":
        run_fetch(scenario, facts.seed, facts.run, runs=runs)
    elif facts.campaign in {"recovery", "hopeless"}:
        run = run_recovery if facts.campaign == "recovery" else run_hopeless
        run(scenario, facts.seed, facts.run, runs=runs)
    else:
        expected = "a run of the campaign fetch, recovery or hopeless"
        raise CommandError(f"{record.path}: expected {expected}, found {facts.campaign!r}")
    typer.echo(f"the run is as recorded up to its end, before {until:.2f} s")
    return ExitCode.OK


def _demo(record: Recording, until: float) -> ExitCode:
    from tandem.executive.cli.running_system import run_demo, run_once  # noqa: PLC0415
    from tandem.executive.config.run_options import RunOptions  # noqa: PLC0415

    facts = record.facts
    with tempfile.TemporaryDirectory(prefix="tandem-again-") as folder:
        faults = Path(folder) / "faults.yaml"
        faults.write_text(facts.faults, encoding="utf-8")
        options = RunOptions(
            bus=replace(RunOptions().bus, site=facts.site, robot=facts.robot),
            scenario=facts.scenario,
            faults=faults if facts.faults else None,
            seed=facts.seed,
            lockstep=True,
            request=facts.request,
            again=record.path,
            again_until=until,
        )
        return run_once(options) if facts.request else run_demo(options)
