"""An item that has a name and no number of its own is told of by its name, wherever people read of it."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import TAG
from tandem.skills.ports.site import SiteItem, number_of
from tandem.skills.site import load
from tandem.trees.inspection import InspectResult

MUG = SiteItem(item=number_of("mug"), name="mug", size=(0.06, 0.06, 0.06))
SITE = load("lab").model_copy(update={"items": (MUG,)})


@pytest.mark.parametrize(
    ("task", "request_", "leaf"),
    [
        ("fetch", {"item": "mug"}, "item not found"),
        ("pick", {"item": "mug"}, "look at table"),
    ],
)
def test_a_failure_tells_the_name(task: str, request_: dict[str, object], leaf: str) -> None:
    bench = TreeBench(SITE, items={})
    assert bench.run(task, request_) is Status.FAILURE
    told = [each.message for each in bench.context.failures.all if each.where and leaf in each.where]
    assert told
    assert all(f"item {MUG.item} (mug)" in message for message in told)


def test_a_leaf_tells_the_name() -> None:
    bench = TreeBench(SITE, items={MUG.item: TAG})
    assert bench.run("fetch", {"item": MUG.item}) is Status.SUCCESS
    reasons = {node.name: node.feedback_message for node in bench.root.iterate()}
    assert reasons["which one is meant?"] == f"the only {MUG.item} (mug)"
    assert reasons["bind arm"].endswith(f"arm for item {MUG.item} (mug)")


def test_an_inspection_tells_the_name() -> None:
    bench = TreeBench(SITE, items={MUG.item: TAG})
    assert bench.run("inspect", {"spots": ["table_south"]}) is Status.SUCCESS
    assert [each.name for each in InspectResult.model_validate(bench.result()).items] == ["mug"]
