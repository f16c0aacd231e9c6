"""A tree is read by what has changed of it, and nothing that is wrong gets in that way."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from web_record import record

from tandem.executive.records.recording import open_recording
from tandem.executive.web.trees import TreeEar
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TREE, NodeStatus, TreeNode, TreeSnapshot
from tandem.skills.wire.memory import MemoryHub


class Heard:
    """A tree that is told and heard, and how often it was read whole."""

    def __init__(self) -> None:
        hub, self.whole = MemoryHub(), 0
        self.bus, end = hub.endpoint(), hub.endpoint()
        self.ear = TreeEar(end, self.decode)
        self.refused = end.ear.refused

    def decode(self, payload: bytes) -> TreeSnapshot:
        self.whole += 1
        return TREE.decode(payload)

    def tell(self, payload: bytes) -> dict[str, Any] | None:
        self.bus.publish(TREE.key, payload)
        news = self.ear.take()
        if news is None:
            return None
        return dict(news.changed) or states(news.head.root)


def states(node: TreeNode) -> dict[str, list[str]]:
    own = {node.path: [str(node.status), str(node.last), node.message]}
    return own | {path: state for child in node.children for path, state in states(child).items()}


def tree(tick: int = 1, task: str = "t1", *names: str, **of_leaf: Any) -> TreeSnapshot:
    leaves = tuple(
        TreeNode(path=f"fetch/{name}", name=name, kind="action", type="Leaf", **of_leaf)
        for name in names or ("go", "pick")
    )
    root = TreeNode(path="fetch", name="fetch", kind="sequence", type="Sequence", children=leaves)
    stamp = RobotTime(boot="b", seconds=float(tick))
    return TreeSnapshot(task=task, kind="fetch", tick=tick, stamp=stamp, root=root, board={"tick": str(tick)})


def plain(snapshot: TreeSnapshot) -> bytes:
    return snapshot.model_dump_json().encode()


def test_what_changed_adds_up_to_what_is_told(tmp_path: Path) -> None:
    path = tmp_path / "box.jsonl.gz"
    record(path)
    told = [each.payload for each in open_recording(path).messages() if each.key == TREE.key]
    heard, known = Heard(), dict[str, Any]()
    for payload in told:
        known |= heard.tell(payload) or {}
        assert known == states(TREE.decode(payload).root)
    assert len(told) > 30
    assert heard.whole < 3
    assert heard.ear.last() == TREE.decode(told[-1])


def test_the_head_is_that_of_the_newest() -> None:
    heard = Heard()
    for tick in (1, 2):
        heard.bus.publish(TREE.key, plain(tree(tick)))
        news = heard.ear.take()
        assert news is not None
        assert (news.head.tick, dict(news.head.board)) == (tick, {"tick": str(tick)})
    assert heard.ear.take() is None


@pytest.mark.parametrize("other", [tree(2, "t2"), tree(2, "t1", "go"), tree(2, "t1", "go", "place")])
def test_a_tree_with_other_nodes_is_read_whole(other: TreeSnapshot) -> None:
    heard = Heard()
    heard.tell(plain(tree()))
    assert heard.tell(plain(other)) == states(other.root)
    assert heard.whole == 2


def changed(change: Callable[[Any], object]) -> bytes:
    document = json.loads(plain(tree(2, status=NodeStatus.RUNNING)))
    change(document)
    return json.dumps(document).encode()


def test_what_a_later_release_says_besides_is_passed_over() -> None:
    heard = Heard()
    later = changed(lambda it: (it.update(mood=1), it["root"]["children"][0].update(mood=1)))
    heard.tell(plain(tree()))
    assert heard.tell(later) == states(TREE.decode(later).root)


@pytest.mark.parametrize(
    "payload",
    [
        b"no json",
        b"[]",
        b"{}",
        b"[" * 10_000,
        changed(lambda it: it.pop("root")),
        changed(lambda it: it.update(root=[])),
        changed(lambda it: it.update(tick="soon")),
        changed(lambda it: it["root"]["children"].append(7)),
        changed(lambda it: it["root"]["children"].__setitem__(0, 7)),
        changed(lambda it: it["root"].update(children=7)),
        changed(lambda it: it["root"]["children"][0].update(status="ODD")),
        changed(lambda it: it["root"]["children"][0].update(message=["<b>"])),
        changed(lambda it: it["root"]["children"][1].pop("path")),
    ],
)
def test_a_tree_that_is_none_is_refused_and_the_last_one_stays(payload: bytes) -> None:
    heard = Heard()
    heard.tell(plain(tree()))
    assert heard.tell(payload) is None
    assert sum(heard.refused.values()) == 1
    assert heard.ear.last() == tree()
    assert heard.tell(plain(tree(3, status=NodeStatus.SUCCESS))) == {
        "fetch/go": ["SUCCESS", "INVALID", ""],
        "fetch/pick": ["SUCCESS", "INVALID", ""],
    }
