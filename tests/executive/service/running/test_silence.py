"""Hardware that falls silent, comes back, or does not."""

from __future__ import annotations

import pytest
from surroundings import Surroundings

from tandem.executive.service.running.time_limits import LOST_AFTER
from tandem.executive.service.running.tree_run import WAITS
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.tasks import TaskState

WAIT = {"task": "wait", "item": 29}


@pytest.fixture
def here() -> Surroundings:
    """A task under way on hardware that was heard."""
    here = Surroundings()
    here.ask(WAIT)
    here.hardware()
    here.step()
    return here


def test_the_tree_waits_for_silent_hardware_and_says_so(here: Surroundings) -> None:
    here.step(30, seconds=0.05)
    assert here.told()[-1].progress.phase == WAITS
    ticks = here.executive.running.ticks
    here.world(1)
    here.step(30, seconds=0.05)
    assert here.executive.running.ticks == ticks


def test_it_goes_on_when_the_hardware_is_back(here: Surroundings) -> None:
    here.step(100, seconds=0.05)
    here.hardware(2)
    here.step()
    assert here.told()[-1].progress.phase == "waiting"
    here.world(1)
    here.step()
    assert here.told()[-1].state is TaskState.SUCCEEDED


def test_hardware_that_stays_silent_ends_the_task_and_the_next_waits_for_it(here: Surroundings) -> None:
    here.ask(WAIT)
    here.step(round(LOST_AFTER) * 10 + 20, seconds=0.1)
    told = here.told()
    (ended,) = (each for each in told if each.state.terminal)
    assert (ended.task[-1], ended.failure.kind) == ("1", FailureKind.HARDWARE_LOST)
    assert ended.failure.evidence["silent_s"] >= LOST_AFTER
    assert told[-1] is ended or told[-1].state is not TaskState.RUNNING
    here.hardware(2)
    here.step()
    assert here.told()[-1].state is TaskState.RUNNING


def test_hardware_that_was_never_heard_is_not_watched() -> None:
    here = Surroundings()
    here.ask(WAIT)
    here.step(round(LOST_AFTER) + 5, seconds=1.0)
    assert here.told()[-1].state is TaskState.RUNNING
