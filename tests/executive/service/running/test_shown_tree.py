"""Of a tree that is shown, statuses come at once, and what leaves say at their work twice a second."""

from __future__ import annotations

from py_trees.behaviours import Running
from py_trees.common import Status
from py_trees.composites import Sequence

from tandem.executive.service.running.shown_tree import WORDS_EVERY, ShownTree
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.tasks import TreeNode
from tandem.skills.site import load
from tandem.trees.breakpoints import Breakpoints


def shown() -> tuple[ShownTree, Running, Breakpoints]:
    """A tree of one leaf that has been shown at second 0."""
    leaf = Running("drive")
    root = Sequence("root", memory=True, children=[leaf])
    tree, gates = ShownTree(root), Breakpoints(root, TreeBench(load("lab"), items={}).context)
    tree.touched = True
    assert tree.changed(gates, 0.0)
    return tree, leaf, gates


def test_a_message_waits_until_the_last_showing_is_old_and_is_not_lost() -> None:
    tree, leaf, gates = shown()
    leaf.feedback_message, tree.touched = "1.2 m left", True
    assert not tree.changed(gates, WORDS_EVERY / 2)
    assert tree.changed(gates, WORDS_EVERY), "though it has not been ticked since"
    assert not tree.changed(gates, 10 * WORDS_EVERY)


def test_a_status_is_shown_at_once() -> None:
    tree, leaf, gates = shown()
    leaf.status, tree.touched = Status.FAILURE, True
    assert tree.changed(gates, WORDS_EVERY / 100)


def test_whoever_asks_for_the_tree_takes_nothing_from_those_who_follow_it() -> None:
    tree, leaf, gates = shown()
    leaf.status, tree.touched = Status.FAILURE, True
    assert TreeNode.model_validate_json(tree.written()).children[0].status == "FAILURE"
    assert tree.changed(gates, WORDS_EVERY / 100)
