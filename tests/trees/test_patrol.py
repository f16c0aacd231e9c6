"""Patrol: corners in order, round after round; what was visited survives a restart."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.base import GoGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.site import load
from tandem.skills.testing.mock_base import FOR_EVER, MockReflex
from tandem.trees.rounds import KEPT, NAME, RoundsNotes
from tandem.trees.tasks.patrol import TASK, PatrolRequest, PatrolResult

SITE = load("lab")
CORNERS = [{"x": -1.0, "y": 0.5}, {"x": -1.0, "y": -0.5}, {"x": 0.0, "y": -0.5}]


def bench(reflex: MockReflex | None = None) -> TreeBench:
    made = TreeBench(SITE, items={}, localised=True, step=0.05)
    made.robot.wheels.reflex = reflex or MockReflex()
    return made


def result(run: TreeBench) -> PatrolResult:
    return PatrolResult.model_validate(run.result())


def test_corners_are_visited_in_order_again_and_again() -> None:
    run = bench()
    assert run.run("patrol", {"corners": CORNERS, "rounds": 2}) is Status.SUCCESS
    told = result(run)
    assert [(each.round, each.corner) for each in told.visits] == [
        (lap, n) for lap in (1, 2) for n in range(3)
    ]
    assert told.visited == 6
    times = [each.at for each in told.visits]
    assert times == sorted(times)
    goals = [goal for _, goal in run.robot.calls if isinstance(goal, GoGoal)]
    assert [{"x": goal.x, "y": goal.y} for goal in goals] == CORNERS * 2


def test_reflexes_are_given_way_to_and_counted() -> None:
    run = bench(MockReflex(times=5))
    assert run.run("patrol", {"corners": CORNERS}) is Status.SUCCESS
    assert (result(run).overridden, result(run).replans, result(run).visited) == (5, 5, 3)


def test_one_that_is_starved_tells_what_it_has_visited() -> None:
    run = bench()
    run.start("patrol", {"corners": CORNERS})
    while run.step() is Status.RUNNING:
        if result(run).visited == 1:
            run.robot.wheels.reflex = MockReflex(times=FOR_EVER)
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, result(run).visited) == (FailureKind.OVERRIDDEN, 1)


def test_after_a_restart_it_goes_on_with_the_corner_that_is_next() -> None:
    run = bench()
    run.start("patrol", {"corners": CORNERS})
    run.context.notes.keep(NAME, RoundsNotes(visited=2))
    while run.step() is Status.RUNNING:
        pass
    assert [each.corner for each in result(run).visits] == [2]


def test_the_result_of_many_rounds_stays_small() -> None:
    run = bench()
    assert run.run("patrol", {"corners": CORNERS, "rounds": 40}, steps=20000) is Status.SUCCESS
    assert (result(run).visited, len(result(run).visits)) == (120, KEPT)


@pytest.mark.parametrize(("y", "wrong"), [(0.0, ()), (99.0, ("corners.1.y",))])
def test_a_corner_outside_the_site_is_refused(y: float, wrong: tuple[str, ...]) -> None:
    asked = PatrolRequest.model_validate({"corners": [{"x": 0.0, "y": 0.0}, {"x": 0.0, "y": y}]})
    assert tuple(each.path for each in TASK.problems(asked, SITE)) == wrong
