"""A path, and a goal's name, are those of one node of a tree."""

from __future__ import annotations

import pytest
from py_trees.behaviour import Behaviour
from py_trees.behaviours import Failure, Success
from py_trees.composites import Selector, Sequence
from py_trees.decorators import Inverter

from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType
from tandem.skills.site import load
from tandem.testing import TreeBench
from tandem.trees.behaviours.act import Act
from tandem.trees.node_paths import AmbiguousNodesError, check_paths, paths


class Wave(Message):
    """A goal."""


WAVE = ActionType("wave", Wave, Wave, Wave, timeout=5.0)


def above(name: str, *children: Behaviour) -> Sequence:
    return Sequence(name, memory=True, children=list(children))


def wave(name: str) -> Behaviour:
    return Act(name, TreeBench(load("lab"), items={}).context, WAVE, Wave)


def the_same(node: Behaviour) -> Behaviour:
    """Return a tree with one node in two places, as decorators let it happen."""
    return above("tour", Inverter("not", node), Inverter("nor", node))


@pytest.mark.parametrize(
    ("root", "why"),
    [
        (
            above("tour", Success("look"), Selector("look", memory=False)),
            "two nodes are called 'look' below tour (Success and Selector); give each a name of its own",
        ),
        (
            above("tour", above("first", Success("look"), Failure("look"))),
            "two nodes are called 'look' below tour/first (Success and Failure); give each a name of its own",
        ),
        (
            above("tour", above("first", wave("greet")), above("second", wave("greet"))),
            "two nodes that send goals are called 'greet': tour/first/greet and tour/second/greet; their",
        ),
        (
            above("tour", Success("left/right")),
            "a Success below tour: expected a name without '/', which stands between the names of a path",
        ),
        (above("", Success("look")), "the root, a Sequence: expected a name"),
        (
            the_same(Success("look")),
            "one node stands in two places: tour/not/look and tour/nor/look; build a",
        ),
    ],
)
def test_nodes_that_nothing_tells_apart_are_refused_with_their_places(root: Behaviour, why: str) -> None:
    with pytest.raises(AmbiguousNodesError) as refused:
        check_paths(root)
    assert str(refused.value).startswith(why)


def test_a_node_may_have_the_name_of_one_elsewhere() -> None:
    root = above("tour", above("first", Success("there")), above("second", Success("there"), wave("tour")))
    check_paths(root)
    assert [path for path, _ in paths(root)] == [
        "tour",
        "tour/first",
        "tour/first/there",
        "tour/second",
        "tour/second/there",
        "tour/second/tour",
    ]
