"""Breakpoints and forced nodes, in a tree of a few nodes."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Selector, Sequence

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.failure import FailureKind
from tandem.skills.site import load
from tandem.trees.breakpoints import Breakpoints


class Step(Behaviour):
    """Succeeds (or fails) at its second tick, and counts how often it has begun."""

    def __init__(self, name: str, end: Status = Status.SUCCESS) -> None:
        super().__init__(name)
        self.end, self.begun, self.ticked = end, 0, 0

    def initialise(self) -> None:
        self.begun += 1
        self.ticked = 0

    def update(self) -> Status:
        self.ticked += 1
        return self.end if self.ticked == 2 else Status.RUNNING


@pytest.fixture
def steps() -> dict[str, Step]:
    return {name: Step(name) for name in "abc"}


@pytest.fixture
def gates(steps: dict[str, Step]) -> Breakpoints:
    root = Sequence("root", memory=True, children=list(steps.values()))
    return Breakpoints(root, TreeBench(load("lab"), items={}).context)


def tick(gates: Breakpoints, times: int = 20) -> Status:
    for _ in range(times):
        gates.root.tick_once()
        if gates.hit or gates.root.status is not Status.RUNNING:
            break
    return gates.root.status


def test_before_a_node_nothing_of_it_has_begun(gates: Breakpoints, steps: dict[str, Step]) -> None:
    gates.hold(steps["b"], before=True)
    assert tick(gates) is Status.RUNNING
    assert (gates.hit, steps["a"].status, steps["b"].begun) == ("before b", Status.SUCCESS, 0)
    gates.release()
    assert tick(gates) is Status.SUCCESS
    assert [step.begun for step in steps.values()] == [1, 1, 1]


def test_after_a_node_the_next_has_not_begun(gates: Breakpoints, steps: dict[str, Step]) -> None:
    gates.hold(steps["b"], before=False)
    tick(gates)
    assert (gates.hit, steps["b"].begun, steps["c"].begun) == ("after b", 1, 0)
    gates.release()
    assert tick(gates) is Status.SUCCESS
    assert steps["b"].begun == 1


def test_a_node_can_be_held_on_both_sides_each_time(gates: Breakpoints, steps: dict[str, Step]) -> None:
    gates.hold(steps["b"], before=True)
    gates.hold(steps["b"], before=False)
    seen = []
    for _ in range(2):
        for _ in range(3):
            tick(gates)
            seen.append(gates.hit)
            gates.release()
    assert seen == ["before b", "after b", ""] * 2


def test_a_breakpoint_that_is_taken_away_holds_nobody(gates: Breakpoints, steps: dict[str, Step]) -> None:
    gates.hold(steps["b"], before=True)
    gates.hold(steps["b"], before=True, on=False)
    assert tick(gates) is Status.SUCCESS


def test_what_was_stopped_before_a_breakpoint_begins_anew(gates: Breakpoints, steps: dict[str, Step]) -> None:
    gates.hold(steps["b"], before=True)
    tick(gates)
    gates.release()
    gates.root.stop(Status.INVALID)
    tick(gates)
    assert gates.hit == "before b"
    assert steps["b"].begun == 0


@pytest.mark.parametrize(
    ("status", "end"), [(Status.SUCCESS, Status.SUCCESS), (Status.FAILURE, Status.FAILURE)]
)
def test_a_forced_node_ends_without_having_worked(
    gates: Breakpoints, steps: dict[str, Step], status: Status, end: Status
) -> None:
    gates.force(steps["b"], status)
    assert tick(gates) is end
    assert steps["b"].begun == 0
    told = [failure.where for failure in gates.context.failures.all]
    assert told == ([] if status is Status.SUCCESS else ["b"])


def test_a_forced_failure_leads_to_the_other_branch() -> None:
    first, other = Step("first"), Step("other")
    root = Selector("root", memory=True, children=[first, other])
    gates = Breakpoints(root, TreeBench(load("lab"), items={}).context)
    gates.force(first, Status.FAILURE)
    assert tick(gates) is Status.SUCCESS
    assert (first.begun, other.begun) == (0, 1)


def test_a_node_that_works_is_stopped_when_it_is_forced_and_works_again_after(
    gates: Breakpoints, steps: dict[str, Step]
) -> None:
    tick(gates, 1)
    gates.force(steps["a"], Status.SUCCESS)
    tick(gates)
    gates.force(steps["a"], None)
    assert tick(gates) is Status.SUCCESS
    assert steps["a"].begun == 2


def test_a_name_that_is_not_clear_is_told() -> None:
    root = Sequence(
        "root",
        memory=True,
        children=[
            Sequence("left", memory=True, children=[Step("same")]),
            Sequence("right", memory=True, children=[Step("same")]),
        ],
    )
    gates = Breakpoints(root, TreeBench(load("lab"), items={}).context)
    assert gates.find("none") == "no node 'none' in the tree"
    assert "root/left/same, root/right/same" in str(gates.find("same"))
    assert gates.find("root/right/same") is root.children[1].children[0]


def in_a_fetch(prepare: Callable[[TreeBench], None]) -> tuple[TreeBench, Status]:
    from tandem.skills.geometry.poses import from_axes  # noqa: PLC0415
    from tandem.skills.ports.pose import Pose  # noqa: PLC0415

    tag = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))
    bench = TreeBench(load("lab"), items={29: tag})
    bench.start("fetch", {"item": 29})
    prepare(bench)
    status = Status.RUNNING
    for _ in range(3000):
        status = bench.step()
        if status is not Status.RUNNING or bench.gates.hit:
            break
    return bench, status


def test_the_bench_holds_a_fetch_before_it_closes_the_hand() -> None:
    bench, _ = in_a_fetch(lambda bench: bench.hold("close"))
    assert bench.gates.hit == "before close"
    assert bench.path()[-1] == "grasp"


def test_the_bench_forces_a_leaf_of_a_fetch() -> None:
    bench, status = in_a_fetch(lambda bench: bench.force("close", Status.FAILURE))
    assert status is Status.FAILURE
    assert bench.context.failures.all[-1].kind is FailureKind.SKILL_CRASHED or bench.failure() is not None


def test_a_root_is_found_by_its_name_though_a_node_below_has_it_too(steps: dict[str, Step]) -> None:
    root = Sequence("a", memory=True, children=list(steps.values()))
    gates = Breakpoints(root, TreeBench(load("lab"), items={}).context)
    assert (gates.find("a"), gates.find("a/a")) == (root, steps["a"])
