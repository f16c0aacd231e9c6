"""Each leaf, condition and branch of the fetch succeeds, fails, runs, is interrupted; invariants hold."""

from __future__ import annotations

import pytest

from tandem.executive.trials.exploration.exploring import Coverage, explore
from tandem.executive.trials.exploration.hand_worlds import HAND_WORLDS
from tandem.executive.trials.exploration.inspect_worlds import inspect_worlds
from tandem.executive.trials.exploration.travel_worlds import TRAVEL_WORLDS
from tandem.executive.trials.exploration.worlds import fetch_corners, fetch_worlds

DEPTH = 3


@pytest.fixture(scope="module")
def coverage() -> Coverage:
    return explore(fetch_worlds(), fetch_corners(), depth=DEPTH, tell=lambda _: None)


def test_every_node_has_been_in_every_status_it_can_have(coverage: Coverage) -> None:
    assert coverage.missing() == {}


def test_no_invariant_is_broken(coverage: Coverage) -> None:
    assert coverage.broken == []


def test_inspect_as_well() -> None:
    seen = explore(*inspect_worlds(), depth=1, tell=lambda _: None)
    assert (seen.missing(), seen.broken) == ({}, [])


@pytest.mark.parametrize("task", HAND_WORLDS)
def test_the_tasks_of_two_arms_as_well(task: str) -> None:
    seen = explore(*HAND_WORLDS[task](), depth=1, tell=lambda _: None)
    assert (seen.missing(), seen.broken) == ({}, [])


@pytest.mark.parametrize("task", TRAVEL_WORLDS)
def test_the_tasks_on_wheels_as_well(task: str) -> None:
    seen = explore(*TRAVEL_WORLDS[task](), depth=1, tell=lambda _: None)
    assert (seen.missing(), seen.broken) == ({}, [])
