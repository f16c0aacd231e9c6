"""The same seed gives the same run, to the last message, in any process."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.lockstep

CHILD = Path(__file__).with_name("digest_child.py")
SECONDS = "25"
"""Robot seconds: camera, localisation, survey, drive, planned motions and a grasp."""


def digests(hash_seed: str, seconds: str = SECONDS) -> list[str]:
    """Return one line for each robot second: its number, the messages until then, their hash."""
    environment = os.environ | {"PYTHONHASHSEED": hash_seed, "PYTHONPATH": str(CHILD.parents[2])}
    argv = [sys.executable, str(CHILD), seconds]
    done = subprocess.run(argv, env=environment, capture_output=True, text=True, check=True, timeout=280)
    return [line for line in done.stdout.splitlines() if line.startswith("second ")]


def test_two_fresh_processes_say_the_same_to_the_last_message() -> None:
    one, other = digests("1"), digests("4711")
    assert len(one) == int(SECONDS)
    assert one == other, (
        f"first different: {next(pair for pair in zip(one, other, strict=True) if pair[0] != pair[1])}"
    )
