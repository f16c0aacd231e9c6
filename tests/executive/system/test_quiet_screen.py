"""What libraries print from C, at any moment and at the very end, and where it goes.

A program of its own for each case: pytest's own streams stay as they are.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import ctypes, gc, sys
from pathlib import Path
from ruckig import Ruckig
from tandem.executive.system.quiet_screen import Screen, end_unheard
mode, log = sys.argv[1], Path(sys.argv[2])
if mode != "plain":
    screen = Screen()
if mode == "log":
    screen.lead_to(log)
if mode == "verbose":
    screen.lead_to(None, verbose=True)
class Plan: pass
plan = Plan()
plan.itself, plan.of = plan, Ruckig(3)  # in a cycle, and frozen: it lives until the end, and nanobind says so
gc.collect()
gc.freeze()
print("ours")
print("ours, too", file=sys.stderr)
ctypes.CDLL(None).printf(b"ven = Mesa\\n")
if mode == "worker":
    end_unheard()
sys.exit(3)
"""


SCREEN, LOG = "screen", "log"


@pytest.mark.parametrize(
    ("mode", "where"), [("plain", SCREEN), ("quiet", ""), (LOG, LOG), ("verbose", SCREEN)]
)
def test_the_words_of_libraries_go_where_they_should(mode: str, where: str, tmp_path: Path) -> None:
    log = tmp_path / "log"
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, mode, str(log)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 3
    assert "ours\n" in done.stdout
    assert "ours, too\n" in done.stderr
    heard = {SCREEN: done.stdout + done.stderr, LOG: log.read_text() if log.exists() else ""}
    for word in ("ven = Mesa", "nanobind: leaked"):
        assert [place for place, said in heard.items() if word in said] == ([where] if where else []), word


def test_a_worker_ends_without_lists() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM.replace('if mode != "plain":', "if False:"), "worker", ""],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 3
    assert "ours\n" in done.stdout
    assert "nanobind" not in done.stdout + done.stderr
