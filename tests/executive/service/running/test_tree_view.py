"""A tree looked at again and again: written as a fresh snapshot is, and only what changes is told."""

import pytest
from py_trees.behaviours import StatusQueue
from py_trees.common import Status
from py_trees.composites import Selector, Sequence

from tandem.executive.service.running.tree_view import Change, TreeView
from tandem.skills.ports.tasks import TreeNode
from tandem.trees.snapshot import snapshot


def leaf(name: str, *statuses: Status) -> StatusQueue:
    return StatusQueue(name, queue=list(statuses), eventually=None)


def tree() -> Sequence:
    first = Selector("first", memory=False, children=[leaf("a", Status.FAILURE), leaf("b", Status.SUCCESS)])
    second = leaf("c", Status.RUNNING, Status.RUNNING, Status.SUCCESS)
    return Sequence("root", memory=True, children=[first, second])


def look(view: TreeView) -> TreeNode:
    return TreeNode.model_validate_json(view.written())


def test_a_view_is_written_as_a_snapshot_after_each_tick() -> None:
    root = tree()
    view = TreeView(root)
    for _ in range(3):
        assert view.written() == snapshot(root).model_dump_json()
        root.tick_once()
    assert view.written() == snapshot(root).model_dump_json()


def test_what_has_changed_is_told_once() -> None:
    root = tree()
    view = TreeView(root)
    view.written()
    assert [node.path for node in view.take_changed()] == [
        "root",
        "root/first",
        "root/first/a",
        "root/first/b",
        "root/c",
    ]
    root.children[1].feedback_message = "half way"
    view.written()
    view.written()
    assert [(node.path, node.message) for node in view.take_changed()] == [("root/c", "half way")]
    assert view.take_changed() == ()


def test_a_message_alone_is_a_change() -> None:
    root = tree()
    view = TreeView(root)
    view.written()
    assert view.change() is Change.NONE
    root.children[1].feedback_message = "half way"
    assert view.change() is Change.MESSAGE
    assert view.written() == snapshot(root).model_dump_json()


@pytest.mark.parametrize("text", ['"quoted" and \\', "two\nlines\tand \x00\x1f\x7f", "größer → 🙂 \u2028"])
def test_any_text_is_written_as_pydantic_writes_it(text: str) -> None:
    root = Sequence(text, memory=True, children=[leaf(text, Status.SUCCESS)])
    root.children[0].feedback_message = text
    assert TreeView(root).written() == snapshot(root).model_dump_json()


def test_a_message_that_is_no_text_is_told_as_text() -> None:
    root = tree()
    root.children[1].feedback_message = 0.5  # type: ignore[assignment]
    view = TreeView(root)
    assert look(view).children[1].message == "0.5"
    assert view.change() is Change.NONE


def test_a_child_that_is_added_or_removed_is_seen() -> None:
    root = tree()
    view = TreeView(root)
    view.written()
    root.add_child(leaf("d", Status.SUCCESS))
    assert view.change() is Change.STATUS
    assert view.written() == snapshot(root).model_dump_json()
    root.remove_child(root.children[0])
    assert view.written() == snapshot(root).model_dump_json()


def test_a_leaf_that_failed_and_was_set_back_shows_how_it_ended() -> None:
    root = tree()
    view = TreeView(root)
    tuple(view.heed(root.tick()))
    root.children[0].stop(Status.INVALID)
    failed, succeeded = look(view).children[0].children
    assert (failed.status, failed.last, failed.shown) == ("INVALID", "FAILURE", "FAILURE")
    assert (succeeded.status, succeeded.shown) == ("INVALID", "SUCCESS")


def test_a_leaf_that_was_set_back_within_its_tick_is_not_missed() -> None:
    root = tree()
    view = TreeView(root)
    for node in view.heed(root.tick()):
        if node.status is Status.FAILURE:
            node.stop(Status.INVALID)
    assert look(view).children[0].children[0].shown == "FAILURE"


def test_a_leaf_that_is_interrupted_shows_no_end() -> None:
    root = Sequence("root", memory=True, children=[leaf("a", Status.FAILURE, Status.RUNNING)])
    view = TreeView(root)
    for _ in range(2):
        tuple(view.heed(root.tick()))
    root.stop(Status.INVALID)
    assert look(view).children[0].shown == "INVALID"
