"""The record of a campaign's run names what repeats it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.cli.commands.recorded_campaign import recorded_runs
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.fault_file import FaultFile, load_faults
from tandem.executive.trials.campaigns.recording import UNRECORDED, RecordedRuns
from tandem.sim.faults import CameraDark
from tandem.sim.scenario import load_scenario
from tandem.skills.site import load
from tandem.skills.testing.faulty_bus import BusFaults

RUNS = RecordedRuns(Path("runs"), "recovery", "Demo", seed=4, commit="c0ffee")


def test_campaign_number_seed_and_commit_are_facts() -> None:
    facts = RUNS.facts(load_scenario("Demo"), 7, None)
    assert (facts.campaign, facts.run, facts.seed, facts.scenario) == ("recovery", 7, 4, "Demo")
    assert (facts.lockstep, facts.pictures, facts.commit, facts.faults) == (True, True, "c0ffee", "")


def test_the_faults_are_facts_and_a_file_of_faults_again(tmp_path: Path) -> None:
    drawn = (CameraDark(at=3.0, lasts=2.0),)
    scenario, bus = load_scenario("Demo").with_faults(drawn), BusFaults(drop=0.1)
    path = tmp_path / "faults.yaml"
    path.write_text(RUNS.facts(scenario, 7, bus).faults, "utf-8")
    assert load_faults(path, load("lab")) == FaultFile(faults=drawn, bus=bus)


def test_without_a_folder_nothing_is_recorded() -> None:
    assert recorded_runs("fetch", "Demo", 1, None, pictures=True) is UNRECORDED


def test_a_folder_that_can_not_be_made_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", "utf-8")
    with pytest.raises(CommandError, match=r"--record-to .*file/runs: Not a directory"):
        recorded_runs("fetch", "Demo", 1, tmp_path / "file" / "runs", pictures=True)
