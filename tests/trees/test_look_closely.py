"""Why a look straight at the item's place has not seen it."""

from __future__ import annotations

import pytest

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.perception import LookResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.site import load
from tandem.trees.leaves.look_closely import not_seen

NOTHING = LookResult(found=False, sightings=())


@pytest.mark.parametrize(
    ("result", "kind", "words"),
    [
        (NOTHING, FailureKind.ITEM_GONE, "is not where it was seen before"),
        (NOTHING.model_copy(update={"hidden": (29,)}), FailureKind.ITEM_HIDDEN, "something stands before it"),
        (NOTHING.model_copy(update={"hidden": (24,)}), FailureKind.ITEM_GONE, "is not where"),
        (NOTHING.model_copy(update={"head_short": 0.4}), FailureKind.ITEM_HIDDEN, "23 degrees short of it"),
    ],
)
def test_only_what_was_in_view_is_gone(result: LookResult, kind: FailureKind, words: str) -> None:
    failure = not_seen(TreeBench(load("lab"), items={}).context, 29, result)
    assert failure.kind is kind
    assert words in failure.message
    assert failure.evidence.get("head_short_rad", 0.0) == result.head_short
