"""What ``tandem campaign fetch`` calls right; whole: ``tandem campaign fetch --runs 20 --seed 1``.

A user would have seen: "right" for a fetch whose hand swept a carton 0.53 m aside on its way, for an item in
another slot than the one reported, and for items that stood within 14 cm of an edge only. Right is: in the
slot that is reported, nothing else moved, no furniture touched, at rest at home; from anywhere on a top.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

TANDEM = Path(sys.executable).with_name("tandem")


@pytest.mark.thorough
@pytest.mark.lockstep
def test_a_drawn_fetch_is_right_and_the_report_says_why(tmp_path: Path) -> None:
    """Run 3: item 17 at the north edge of the table, from the other side of the room."""
    report = tmp_path / "campaign.json"
    command = ["campaign", "fetch", "--runs", "1", "--first", "3", "--seed", "1", "--jobs", "1"]
    argv = [str(TANDEM), *command, "--report", str(report)]
    done = subprocess.run(argv, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "random free places were out of reach" in done.stdout
    (run,) = json.loads(report.read_text("utf-8"))["result"]["runs"]
    assert (run["right"], run["state"], run["slot"], run["wrong"]) == (True, "SUCCEEDED", 0, [])
