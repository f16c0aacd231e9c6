"""Inspect: every spot is looked around from, and what was seen is told, also when it fails or begins anew."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.inspect_worlds import inspect_site
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import DOUBLE, ITEM, TAG
from tandem.skills.ports.actions.perception import LookGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.site import load
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.inspection import NAME, InspectNotes, InspectResult
from tandem.trees.leaves.rotate import ALL_AROUND
from tandem.trees.tasks.inspect import TASK, InspectRequest

SITE = inspect_site()
FIRST, SECOND = (spot.name for spot in SITE.spots)


def bench() -> TreeBench:
    return TreeBench(SITE, items={ITEM: TAG, 42: DOUBLE})


def result(run: TreeBench) -> InspectResult:
    return InspectResult.model_validate(run.result())


def blocked() -> Fault:
    return Fault(failure=Failure(kind=FailureKind.BASE_BLOCKED, message="a box"))


def test_it_looks_all_around_at_every_spot_and_goes_home() -> None:
    run = bench()
    assert run.run("inspect", {}) is Status.SUCCESS
    names = [name for name, _ in run.robot.calls]
    assert names.count("perception/look") == ALL_AROUND * len(SITE.spots)
    assert names.count("base/rotate") == (ALL_AROUND - 1) * len(SITE.spots)
    assert run.robot.base == SITE.home


def test_it_tells_which_items_are_where_and_from_where_they_were_seen() -> None:
    run = bench()
    run.run("inspect", {})
    told = result(run)
    assert (told.spots, told.missed) == ((FIRST, SECOND), ())
    assert [(each.item, each.stands, each.spots) for each in told.items] == [
        (ITEM, True, (FIRST, SECOND)),
        (42, True, (FIRST, SECOND)),
    ]
    # A cube of 60 mm, whose tag faces south: its middle is half an edge north of the tag.
    assert told.items[0].pose.position == pytest.approx((0.9, 0.13, 0.74))


def test_spots_may_be_named_in_an_order() -> None:
    run = bench()
    assert run.run("inspect", {"spots": [SECOND, FIRST]}) is Status.SUCCESS
    assert result(run).spots == (SECOND, FIRST)


def test_a_spot_without_a_way_is_left_out_and_the_task_fails_at_its_end() -> None:
    run = bench()
    for attempt in (1, 2, 3):
        run.robot.leaf_faults["drive to spot", attempt] = blocked()
    assert run.run("inspect", {}) is Status.FAILURE
    told, failure = result(run), run.failure()
    assert failure is not None
    assert (failure.kind, failure.evidence["missed"]) == (FailureKind.BASE_BLOCKED, FIRST)
    assert [(each.spot, each.kind) for each in told.missed] == [(FIRST, FailureKind.BASE_BLOCKED)]
    assert told.spots == (SECOND,)
    assert run.robot.base == SITE.home


def test_a_silent_camera_ends_it_and_what_was_seen_is_told() -> None:
    run = bench()
    silent = Fault(failure=Failure(kind=FailureKind.CAMERA_SILENT, message="no picture"))
    run.robot.leaf_faults.update({("look on", n): silent for n in range(3, 20)})
    assert run.run("inspect", {}) is Status.FAILURE
    told = result(run)
    assert (told.spots, [each.item for each in told.items]) == ((), [ITEM, 42])


def test_after_a_restart_it_goes_on_with_the_spots_that_are_left() -> None:
    run = bench()
    run.start("inspect", {})
    run.context.notes.keep(NAME, InspectNotes(done=(FIRST,), seen={FIRST: (ITEM,)}))
    while run.step() is Status.RUNNING:
        pass
    assert result(run).spots == (FIRST, SECOND)
    assert [name for name, _ in run.robot.calls].count("perception/look") == ALL_AROUND


@pytest.mark.parametrize(
    ("spots", "wrong"),
    [(None, ()), ((FIRST,), ()), (("moon",), ("spots.0",)), ((FIRST, SECOND, FIRST), ("spots.2",))],
)
def test_spots_are_checked_against_the_site(spots: tuple[str, ...] | None, wrong: tuple[str, ...]) -> None:
    found = TASK.problems(InspectRequest(spots=spots), SITE)
    assert tuple(problem.path for problem in found) == wrong


def test_a_site_without_spots_has_nothing_to_inspect() -> None:
    (problem,) = TASK.problems(InspectRequest(), load("bimanual").model_copy(update={"spots": ()}))
    assert problem.expected == "a site with search spots"


def test_it_looks_as_far_down_as_the_robot_says() -> None:
    run = bench()
    run.robot.description = run.robot.description.model_copy(update={"search_tilts": (-0.2, -0.6)})
    run.run("inspect", {})
    looks = {goal.tilts for _, goal in run.robot.calls if isinstance(goal, LookGoal)}
    assert looks == {(-0.2, -0.6)}
