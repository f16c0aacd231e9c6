"""Who has a resource, at two priorities."""

from __future__ import annotations

import pytest

from tandem.skills.pipeline import Override, Pipeline, take_all
from tandem.skills.ports.failure import Failure, FailureKind

WHY = Failure(kind=FailureKind.BASE_BLOCKED, message="a wall", evidence={"distance_m": 0.2})


def override(reflex: str = "avoid", rank: int = 50) -> Override:
    return Override(reflex, rank, WHY)


def test_one_action_has_it_until_it_gives_it_back() -> None:
    pipeline = Pipeline("base")
    assert pipeline.claim("drive")
    assert not pipeline.claim("rotate")
    refusal = pipeline.busy("rotate")
    assert refusal is not None
    assert (refusal.kind, refusal.message) == (FailureKind.BUSY, "drive has the base")
    pipeline.release("rotate")
    assert pipeline.holder == "drive", "only who has it gives it back"
    pipeline.release("drive")
    assert pipeline.claim("rotate")


def test_a_reflex_ends_the_claim_at_once_and_says_why() -> None:
    pipeline = Pipeline("base")
    pipeline.claim("drive")
    may, mark = pipeline.normal("drive"), pipeline.mark()
    assert may()
    assert pipeline.taken_since(mark, "drive") is None
    assert take_all((pipeline,), override())
    assert not may()
    assert pipeline.high("avoid")()
    ended = pipeline.taken_since(mark, "drive")
    assert ended is not None
    assert (ended.kind, ended.where, ended.causes) == (FailureKind.OVERRIDDEN, "drive", (WHY,))
    assert ended.evidence == {"reflex": "avoid", "distance_m": 0.2}
    assert ended.reason == WHY


def test_a_claim_that_was_overridden_stays_void_after_the_release() -> None:
    pipeline = Pipeline("base")
    pipeline.claim("drive")
    may, mark = pipeline.normal("drive"), pipeline.mark()
    take_all((pipeline,), override())
    pipeline.let_go("avoid")
    assert not may()
    assert pipeline.taken_since(mark, "drive") is not None, "the goal ends though the reflex is gone"
    assert pipeline.claim("drive")
    assert not may(), "a new claim does not revive the old motion"
    assert pipeline.taken_since(pipeline.mark(), "drive") is None


def test_while_a_reflex_has_it_no_goal_begins() -> None:
    pipeline = Pipeline("base")
    take_all((pipeline,), override())
    assert not pipeline.claim("drive")
    refusal = pipeline.busy("drive")
    assert refusal is not None
    assert (refusal.kind, refusal.causes) == (FailureKind.BUSY, (WHY,))


@pytest.mark.parametrize(("second", "has"), [(49, "first"), (50, "first"), (51, "second")])
def test_of_two_reflexes_the_higher_rank_has_its_way(second: int, has: str) -> None:
    pipeline = Pipeline("base")
    assert take_all((pipeline,), override("first", 50))
    assert take_all((pipeline,), override("second", second)) == (has == "second")
    assert [pipeline.high(each)() for each in ("first", "second")] == [has == "first", has == "second"]
    pipeline.let_go("second" if has == "first" else "first")
    assert pipeline.override is not None, "who has lost it can't give it back"


def test_all_resources_are_taken_or_none() -> None:
    left, right = Pipeline("arm_left"), Pipeline("arm_right")
    take_all((right,), override("hold", 90))
    assert not take_all((left, right), override("crossing", 80))
    assert left.override is None
    assert take_all((left, right), override("crossing", 95))
    assert left.override is not None
    assert right.override is not None
    assert {left.override.reflex, right.override.reflex} == {"crossing"}
