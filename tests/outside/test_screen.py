"""What reaches the user's screen: our own words, and nothing that libraries print from C.

A user saw ``ven = Mesa/X.org`` between the lines of the demo, and nanobind's lists of "leaked instances" at
its end: all runs in one process there, with its camera and its planners.
"""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.outside._command import running

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
