"""One seeded run of each experiment of two arms, with all physics; success is read from the truth."""

from __future__ import annotations

import pytest

from tandem.executive.trials.experiments.run import run_experiment
from tandem.executive.trials.experiments.settings import LEAST, Kind, Options

pytestmark = pytest.mark.lockstep


@pytest.mark.parametrize(
    "kind", [pytest.param("uncoordinated", marks=pytest.mark.thorough), "crossing", "coordinated"]
)
def test_what_moves_is_picked_and_nothing_touches(kind: Kind) -> None:
    run = run_experiment(Options(kind=kind, seed=1), 0)
    assert (run.left.pick, run.right.pick) == (True, True), run.failure
    assert run.left.apf
    assert run.right.apf
    assert run.touches == ()
    assert len(run.moved) == (1 if kind == "coordinated" else 2), f"each thing is moved by {LEAST} m or more"
