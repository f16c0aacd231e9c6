"""No way is free: where occupied space is mapped, the robot looks whether what is in the way still stands."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import fetch_worlds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.occupancy import OccupancySetting
from tandem.skills.site import load
from tandem.skills.testing.mock_skill import Fault

NO_WAY = Fault(failure=Failure(kind=FailureKind.BASE_NO_PATH, message="as the test asked"))
MAPPED = load("lab").model_copy(update={"occupancy": OccupancySetting()})
TURNS = 12


def fetched(leaf: str, times: int, *, mapped: bool = True) -> tuple[TreeBench, Status]:
    """Fetch item 29, with no way for the first ``times`` of that drive."""
    bench = fetch_worlds(MAPPED if mapped else None)["in view"]()
    for n in range(1, times + 1):
        bench.robot.leaf_faults[leaf, n] = NO_WAY
    while (status := bench.step()) is Status.RUNNING:
        pass
    return bench, status


@pytest.mark.parametrize(("leaf", "before"), [("drive to item", 2), ("drive to slot", 2), ("home: drive", 3)])
def test_it_looks_all_around_after_what_is_cheaper(leaf: str, before: int) -> None:
    bench, status = fetched(leaf, before + 1)
    assert status is Status.SUCCESS
    assert bench.robot.calls_of("base/rotate") == TURNS
    tried = [each.recovery for each in bench.context.failures.attempts]
    assert tried[-1].endswith("see what is in the way")
    assert len(tried) == before + 1


@pytest.mark.parametrize(
    ("mapped", "ends", "turns"), [(True, Status.SUCCESS, TURNS), (False, Status.FAILURE, 0)]
)
def test_who_goes_to_a_place_looks_too(ends: Status, turns: int, *, mapped: bool) -> None:
    bench = TreeBench(MAPPED if mapped else load("lab"), items={}, localised=True, step=0.05)
    for n in range(1, 5):
        bench.robot.leaf_faults["go", n] = NO_WAY
    assert bench.run("go_to", {"x": -1.2, "y": 0.5}) is ends
    assert bench.robot.calls_of("base/rotate") == turns


def test_it_looks_once_and_then_says_that_there_is_no_way() -> None:
    bench, status = fetched("drive to slot", 100)
    failure = bench.failure()
    assert (status, failure and failure.kind) == (Status.FAILURE, FailureKind.BASE_NO_PATH)
    assert bench.robot.calls_of("base/rotate") == TURNS


def test_where_nothing_is_mapped_there_is_nothing_to_see() -> None:
    bench, status = fetched("drive to item", 3, mapped=False)
    assert status is Status.FAILURE
    assert bench.robot.calls_of("base/rotate") == 0
