"""What a kind of task may call its fields."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

import pytest
from py_trees.behaviours import Success
from py_trees.composites import Sequence
from pydantic import create_model

from tandem.executive.ledger.sender import BY_FIELD
from tandem.executive.service.intake.request_parser import ID_FIELD
from tandem.skills.ports.message import Message
from tandem.skills.site import load
from tandem.testing import TreeBench
from tandem.trees.context import TreeContext
from tandem.trees.node_paths import AmbiguousNodesError
from tandem.trees.task import RESERVED, TaskType


@pytest.mark.parametrize("name", [BY_FIELD, ID_FIELD])
def test_a_kind_whose_field_says_who_asks_is_refused(name: str) -> None:
    request = create_model("OddRequest", __base__=Message, **{name: (str, "")})  # type: ignore[call-overload]
    with pytest.raises(TypeError, match=f"OddRequest has a field '{name}'"):
        TaskType("odd", "Odd.", request, lambda _, __: (), lambda _, __: Success("done"))


def test_both_fields_are_reserved() -> None:
    assert {BY_FIELD, ID_FIELD} == RESERVED


def test_a_copy_whose_request_still_has_the_old_name_is_refused() -> None:
    request = create_model("TourRequest", __base__=Message, task=(Literal["tour"], "tour"))
    with pytest.raises(
        TypeError, match=r"task 'count': TourRequest has task: 'tour'; expected task: Literal"
    ):
        TaskType("count", "Count.", request, lambda _, __: (), lambda _, __: Success("done"))


def test_a_request_without_the_tasks_name_is_refused() -> None:
    request = create_model("Nameless", __base__=Message)
    with pytest.raises(TypeError, match=r"task 'count': Nameless has no field task; expected task: Literal"):
        TaskType("count", "Count.", request, lambda _, __: (), lambda _, __: Success("done"))


class Waving(Message):
    """A request."""

    task: Literal["wave"] = "wave"


def waving(**changes: Callable[..., object]) -> TaskType[Waving]:
    """Return a kind of task whose functions return what a stranger's may."""
    made = TaskType("wave", "Wave.", Waving, lambda _, __: (), lambda _, __: Success("done"))
    return replace(made, **changes)  # type: ignore[arg-type]


def test_a_builder_that_returns_no_tree_is_told_so() -> None:
    bench = TreeBench(load("lab"), items={})
    with pytest.raises(TypeError, match="expected a node of py_trees from `build`, found None"):
        bench.run(waving(build=lambda _, __: None), {})


def test_a_check_that_returns_no_problems_is_told_so() -> None:
    site = load("lab")
    for found in (("no",), None, "no"):
        with pytest.raises(TypeError, match="expected a tuple of Problem from `problems` of wave, found"):
            waving(problems=lambda _, __, found=found: found).contradictions(Waving(), site)
    assert waving().contradictions(Waving(), site) == ()


def test_a_tree_whose_nodes_nothing_tells_apart_is_refused_also_by_a_bench() -> None:
    bench = TreeBench(load("lab"), items={})
    twice = [Success("look"), Success("look")]
    with pytest.raises(AmbiguousNodesError, match="two nodes are called 'look' below tour"):
        bench.run(waving(build=lambda _, __: Sequence("tour", memory=True, children=twice)), {})


def test_what_is_done_after_a_cancel_is_checked_too() -> None:
    def build(_: Message, context: TreeContext) -> Success:
        context.wind_down = Success("put/back")
        return Success("done")

    with pytest.raises(AmbiguousNodesError, match="the root, a Success: expected a name without '/'"):
        TreeBench(load("lab"), items={}).run(waving(build=build), {})


def test_one_that_does_not_say_rightly_whom_it_follows_is_told_so() -> None:
    with pytest.raises(TypeError, match="expected a Following or None from `follows` of wave, found 'r2'"):
        waving(follows=lambda _: "r2").following(Waving())
    assert waving().following(Waving()) is None
