"""``tandem replay --again``: which records it repeats, and with what."""

from __future__ import annotations

from pathlib import Path

import pytest
from synthetic_record import FACTS, motion

from tandem.executive.cli import running_system
from tandem.executive.cli.commands import run_again
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.main import main
from tandem.executive.config.fault_file import FaultFile, load_faults
from tandem.executive.config.run_options import RunOptions
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import Facts, Recording, Span, open_recording
from tandem.executive.trials import provenance
from tandem.executive.trials.campaigns import fetch
from tandem.executive.trials.campaigns.recording import HeldRuns
from tandem.sim.faults import CameraDark
from tandem.sim.scenario import Scenario
from tandem.skills.site import load

FAULTS = FaultFile(faults=(CameraDark(at=3.0),))


def record(folder: Path, **facts: object) -> Path:
    """Write a black box with other facts."""
    path = folder / "run.jsonl.gz"
    write_lines(path, Facts.model_validate({**FACTS.model_dump(), **facts}), Span(0.0, 4.0), [], [*motion()])
    return path


@pytest.mark.parametrize(
    ("facts", "words"),
    [
        ({}, "expected a run in lockstep, found one in real time"),
        (
            {"lockstep": True, "campaign": "parade"},
            "expected a run of the campaign fetch, recovery or hopeless",
        ),
    ],
)
def test_what_can_not_be_repeated_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], facts: dict[str, object], words: str
) -> None:
    assert main(["replay", str(record(tmp_path, **facts)), "--again"]) == 2
    assert words in capsys.readouterr().err


def test_a_run_of_a_campaign_is_drawn_again_and_held_to_its_record(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: list[tuple[int, int, HeldRuns]] = []

    def run(_: Scenario, seed: int, number: int, *, runs: HeldRuns) -> None:
        asked.append((seed, number, runs))

    monkeypatch.setattr(fetch, "run_fetch", run)
    monkeypatch.setattr(provenance, "checkout", lambda: ("beef", ""))
    made: Recording = open_recording(record(tmp_path, lockstep=True, campaign="fetch", run=3))
    assert run_again.run_again(made, 2.5) is ExitCode.OK
    assert asked == [(FACTS.seed, 3, HeldRuns(made, 2.5))]
    assert f"the record is of commit {FACTS.commit}" in capsys.readouterr().out
    made.close()


def test_a_demo_is_repeated_with_its_faults(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[FaultFile] = []

    def run(options: RunOptions) -> ExitCode:
        assert options.faults is not None
        asked.append(load_faults(options.faults, load("lab")))
        return ExitCode.OK

    monkeypatch.setattr(running_system, "run_demo", run)
    faults = FAULTS.model_dump_json(exclude_none=True)
    made = open_recording(record(tmp_path, lockstep=True, faults=faults))
    assert run_again.run_again(made, None) is ExitCode.OK
    assert asked == [FAULTS]
    made.close()
