"""``sim/reset`` under a whole system: another boot, and everything back where the scenario has it.

A user would have seen every later picture called too old, arms that tell nothing, and a base that won't
drive.
"""

from __future__ import annotations

import pytest

from tandem.sim.controls import RESET, ResetRequest
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tandem.skills.ports.world import WorldState
from tests.acceptance.course import Course, course

pytestmark = pytest.mark.lockstep

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)


def reset(run: Course) -> None:
    answer = RESET.query(run.system.bus, ResetRequest(seed=2))
    run.until(answer.done, within=1.0)


def holds(world: WorldState | None) -> bool:
    return world is not None and bool(world.held)


@pytest.mark.thorough
def test_a_reset_costs_the_fetch_that_runs_at_the_most() -> None:
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as run:
        task = run.ask(29)
        run.until(lambda: holds(run.world()), within=150.0)
        reset(run)  # in the middle of a fetch
        # It may go on from what is true now, or fail: but it ends.
        first = run.caller.follow(task, within=300.0)
        assert first.state in {TaskState.SUCCEEDED, TaskState.FAILED}, run.account()
        assert run.delivered(29) == (first.state is TaskState.SUCCEEDED), run.account()


@pytest.mark.thorough
def test_a_reset_at_rest_undoes_what_was_delivered_and_the_next_fetch_succeeds() -> None:
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as run:
        assert run.fetch(29).state is TaskState.SUCCEEDED, run.account()
        reset(run)
        assert not run.delivered(29)
        assert run.fetch(42).state is TaskState.SUCCEEDED, run.account()
        assert run.delivered(42)
