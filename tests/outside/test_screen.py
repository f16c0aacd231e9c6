"""What reaches the user's screen: our own words, and nothing that libraries print from C.

A user saw ``ven = Mesa/X.org`` between the lines of the demo, and nanobind's lists of "leaked instances" at
its end: all runs in one process there, with its camera and its planners. And where the screen is closed, full
or of no width, a command ends with a sentence and its own exit code.
"""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

from tests.outside._command import TANDEM, Done, environment, running

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("screen")]


def test_a_demo_that_is_interrupted_says_nothing_but_its_own_words(tmp_path: Path) -> None:
    picture = tmp_path / "picture.png"
    with running("demo", "--lockstep", "--seed", "1", "--picture", str(picture), cwd=tmp_path) as demo:
        demo.await_word("look here")  # the camera has drawn
        assert demo.end(signal.SIGINT) == 130
        said = demo.said
    assert "interrupted" in said
    assert "ven = " not in said
    assert "nanobind" not in said
    assert "pybullet build time" not in said


def in_shell(line: str, **more: str) -> Done:
    """Run a line in which ``tandem`` is the command."""
    done = subprocess.run(
        ["/bin/bash", "-o", "pipefail", "-c", line.replace("tandem", TANDEM)],
        env=environment(more),
        capture_output=True,
        text=True,
        check=False,
        timeout=60.0,
        stdin=subprocess.DEVNULL,
    )
    return Done(done.returncode, done.stdout, done.stderr)


@pytest.mark.parametrize("line", ["tandem schema >&-", "tandem --version 2>&-", "tandem --help <&- >&- 2>&-"])
def test_streams_that_are_closed_at_the_start_are_nobodys_fault(line: str) -> None:
    """A user saw a traceback of ours: cron jobs and supervisors start programs so."""
    done = in_shell(line)
    assert (done.code, done.err) == (0, "")


@pytest.mark.parametrize("words", ["schema", "--help", "--version"])
def test_output_that_does_not_fit_on_the_disk_is_told_in_a_sentence(words: str) -> None:
    """A user saw "a bug in tandem", or a traceback and exit code 120."""
    done = in_shell(f"tandem {words} >/dev/full")
    assert (done.code, done.err) == (2, "error: cannot write the output: No space left on device\n")


@pytest.mark.parametrize("line", ["tandem schema --format asyncapi | head -1", "tandem --help | true"])
def test_a_reader_that_has_seen_enough_is_no_failure(line: str) -> None:
    """A user's script ended with exit code 1, that of a failed task."""
    done = in_shell(line)
    assert (done.code, done.err) == (0, "")


@pytest.mark.parametrize("width", ["0", "-5", "abc"])
def test_a_width_in_which_nothing_fits_is_not_taken(width: str) -> None:
    assert "Usage: tandem" in in_shell("tandem --help", COLUMNS=width).out
