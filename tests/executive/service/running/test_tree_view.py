"""A tree looked at again and again: equal to a fresh snapshot, and the same object while nothing changes."""

from py_trees.behaviours import StatusQueue
from py_trees.common import Status
from py_trees.composites import Selector, Sequence

from tandem.executive.service.running.tree_view import TreeView
from tandem.trees.snapshot import snapshot


def leaf(name: str, *statuses: Status) -> StatusQueue:
    return StatusQueue(name, queue=list(statuses), eventually=None)


def tree() -> Sequence:
    first = Selector("first", memory=False, children=[leaf("a", Status.FAILURE), leaf("b", Status.SUCCESS)])
    second = leaf("c", Status.RUNNING, Status.RUNNING, Status.SUCCESS)
    return Sequence("root", memory=True, children=[first, second])


def test_a_view_equals_a_snapshot_after_each_tick() -> None:
    root = tree()
    view = TreeView(root)
    for _ in range(3):
        assert view.look() == snapshot(root)
        root.tick_once()
    assert view.look() == snapshot(root)


def test_what_has_not_changed_is_the_same_object() -> None:
    root = tree()
    view = TreeView(root)
    root.tick_once()
    seen = view.look()
    root.tick_once()
    assert view.look() is seen
    root.tick_once()
    changed = view.look()
    assert changed is not seen
    assert changed.children[0] is seen.children[0]


def test_a_message_alone_is_a_change() -> None:
    root = tree()
    view = TreeView(root)
    before = view.look()
    root.children[1].feedback_message = "half way"
    assert view.look() == snapshot(root) != before


def test_a_child_that_is_added_or_removed_is_seen() -> None:
    root = tree()
    view = TreeView(root)
    view.look()
    root.add_child(leaf("d", Status.SUCCESS))
    assert view.look() == snapshot(root)
    root.remove_child(root.children[0])
    assert view.look() == snapshot(root)


def test_a_leaf_that_failed_and_was_set_back_shows_how_it_ended() -> None:
    root = tree()
    view = TreeView(root)
    tuple(view.heed(root.tick()))
    root.children[0].stop(Status.INVALID)
    failed, succeeded = view.look().children[0].children
    assert (failed.status, failed.last, failed.shown) == ("INVALID", "FAILURE", "FAILURE")
    assert (succeeded.status, succeeded.shown) == ("INVALID", "SUCCESS")


def test_a_leaf_that_was_set_back_within_its_tick_is_not_missed() -> None:
    root = tree()
    view = TreeView(root)
    for node in view.heed(root.tick()):
        if node.status is Status.FAILURE:
            node.stop(Status.INVALID)
    assert view.look().children[0].children[0].shown == "FAILURE"


def test_a_leaf_that_is_interrupted_shows_no_end() -> None:
    root = Sequence("root", memory=True, children=[leaf("a", Status.FAILURE, Status.RUNNING)])
    view = TreeView(root)
    for _ in range(2):
        tuple(view.heed(root.tick()))
    root.stop(Status.INVALID)
    assert view.look().children[0].shown == "INVALID"
