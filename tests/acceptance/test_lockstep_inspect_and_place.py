"""Inspect and place with physics: what is told is so in truth."""

from __future__ import annotations

import math

import pytest

from tandem.sim.scenario import load_scenario
from tandem.sim.truth import Truth
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tandem.trees.inspection import InspectResult
from tandem.trees.tasks.place import PlaceResult
from tests.acceptance.course import Course, course

pytestmark = pytest.mark.lockstep

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)
OFF = 0.03
"""Metres between a pose that is told and the true one: half of what a grasp allows on either side."""


def ask(run: Course, **request: object) -> str:
    answer = run.caller.request(request)  # type: ignore[arg-type]
    assert answer.accepted, answer.problems
    return answer.task


def where(truth: Truth, item: int) -> tuple[float, float, float]:
    return truth.item(item).pose.position


def test_inspect_tells_where_the_items_are() -> None:
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as run:
        spots = ["table_west", "shelf"]
        status = run.caller.follow(ask(run, task="inspect", spots=spots), within=400.0)
        assert status.state is TaskState.SUCCEEDED, run.account()
        told, truth = InspectResult.model_validate(status.result), run.truth()
    assert list(told.spots) == spots
    assert {29, 42} <= {each.item for each in told.items}
    off = {each.item: math.dist(each.pose.position, where(truth, each.item)) for each in told.items}
    assert max(off.values()) < OFF, off


@pytest.mark.thorough
def test_what_a_cancelled_fetch_leaves_in_the_hand_is_placed() -> None:
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE)) as run:
        fetch = run.ask(29)
        run.until(lambda: (world := run.world()) is not None and bool(world.held), within=150.0)
        assert run.cancel(fetch).accepted
        assert run.caller.follow(fetch, within=5.0).state is TaskState.CANCELED
        status = run.caller.follow(ask(run, task="place", slot=1), within=200.0)
        assert status.state is TaskState.SUCCEEDED, run.account()
        assert PlaceResult.model_validate(status.result) == PlaceResult(item=29, depot="depot", slot=1)
        assert run.delivered(29)
