"""The short, seeded form of the campaign; whole: ``tandem campaign fetch --runs 20 --seed 1``."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.lockstep
def test_a_drawn_fetch_is_right(tmp_path: Path) -> None:
    """Run 5: an item on the shelf, turned in the hand on its way. An open finger once kept it."""
    report = tmp_path / "campaign.json"
    command = ["campaign", "fetch", "--runs", "1", "--first", "5", "--seed", "1", "--jobs", "1"]
    argv = ["tandem", *command, "--report", str(report)]
    program = f"import sys; sys.argv = {argv!r}; from executive.cli.main import run; run()"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    campaign = json.loads(report.read_text("utf-8"))["result"]
    assert [(run["right"], run["slot"], run["wrong"]) for run in campaign["runs"]] == [(True, 0, [])]
