"""A running tree as JSON, of which only what changed is written anew: most ticks change one branch."""

from __future__ import annotations

from collections.abc import Iterator
from enum import IntEnum
from json.encoder import encode_basestring
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.tasks import NodeStatus
from tandem.trees.node_paths import BETWEEN
from tandem.trees.snapshot import kind_of


class Change(IntEnum):
    """What is otherwise in a tree than at the last look; the most of it."""

    NONE = 0
    MESSAGE = 1
    """Nothing but what nodes say."""
    STATUS = 2
    """A node's status, how it ended, or which nodes there are."""


_STATUSES: Final = {each: NodeStatus(each.name) for each in Status}
_AS_JSON: Final = encode_basestring
"""As pydantic writes text: a test compares them."""


class SeenNode:
    """A node as it was at the last look; its path, kind and type are so for ever.

    Args:
        behaviour: the node.
        path: its names from the root.
        after: what stands after it in the JSON of the tree: the ends of what is complete with it.
    """

    __slots__ = (
        "_after",
        "_before",
        "behaviour",
        "children",
        "kind",
        "last",
        "message",
        "path",
        "said",
        "seen",
        "status",
        "type",
        "written",
    )

    def __init__(self, behaviour: Behaviour, path: str, after: str) -> None:
        self.behaviour, self.path = behaviour, path
        self.children = list(behaviour.children)
        self.kind, self.type = kind_of(behaviour), type(behaviour).__name__
        names = f'"path":{_AS_JSON(path)},"name":{_AS_JSON(behaviour.name)}'
        self._before = f'{{{names},"kind":"{self.kind}","type":{_AS_JSON(self.type)},"status":"'
        self._after = ',"children":[' if self.children else f',"children":[]}}{after}'
        self.seen: Status | None = None
        self.status = self.last = NodeStatus.INVALID
        self.said = self.message = ""
        self.written = ""
        """Its part of the tree's JSON."""

    def look(self, last: NodeStatus) -> None:
        """Take in how it is now. ``last``: how it ended last."""
        behaviour = self.behaviour
        self.seen, self.said, self.last = behaviour.status, behaviour.feedback_message, last
        self.status, self.message = _STATUSES[self.seen], str(self.said)  # a leaf may say what is no text
        message = _AS_JSON(self.message)
        self.written = f'{self._before}{self.status}","last":"{last}","message":{message}{self._after}'


class TreeView:
    """Looks at the tree below a behaviour, again and again.

    ``written`` returns the JSON of what ``trees.snapshot.snapshot`` would return, with how each node ended
    last. Names and types of nodes don't change; children may be added and removed.
    """

    def __init__(self, root: Behaviour) -> None:
        self._root = root
        self._ended: dict[Behaviour, NodeStatus] = {}
        self._nodes: list[SeenNode] = []
        """Parents first, as they stand in the JSON."""
        self._changed: dict[SeenNode, None] = {}

    def heed(self, ticked: Iterator[Behaviour]) -> Iterator[Behaviour]:
        """Pass on the nodes of a tick, and note how each ends.

        A recovery may set back what has failed within the same tick: it would look as if it had never run.
        """
        for node in ticked:
            if node.status in {Status.SUCCESS, Status.FAILURE}:
                self._ended[node] = _STATUSES[node.status]
            else:
                self._ended.pop(node, None)
            yield node

    def written(self) -> str:
        """Return the tree as it is now, as the JSON of a ``TreeNode``."""
        self.look()
        return "".join([node.written for node in self._nodes])

    def take_changed(self) -> tuple[SeenNode, ...]:
        """Return the nodes that a look found changed since they were taken last."""
        taken, self._changed = tuple(self._changed), {}
        return taken

    def change(self) -> Change:
        """Say what a look would find: in one loop, as it is asked after each tick."""
        ended, never = self._ended.get, NodeStatus.INVALID
        found = Change.NONE if self._nodes else Change.STATUS
        for node in self._nodes:
            behaviour = node.behaviour
            if (
                behaviour.status is not node.seen
                or ended(behaviour, never) is not node.last
                or behaviour.children != node.children
            ):
                return Change.STATUS
            if behaviour.feedback_message != node.said:
                found = Change.MESSAGE
        return found

    def look(self) -> None:
        """Take in how the tree is now."""
        if not self._nodes or any(node.behaviour.children != node.children for node in self._nodes):
            self._nodes, self._changed = list(_laid_out(self._root)), {}
        ended, never = self._ended.get, NodeStatus.INVALID
        for node in self._nodes:
            behaviour = node.behaviour
            last = ended(behaviour, never)
            if (
                behaviour.status is not node.seen
                or last is not node.last
                or behaviour.feedback_message != node.said
            ):
                node.look(last)
                self._changed[node] = None


def _laid_out(root: Behaviour) -> Iterator[SeenNode]:
    """Yield all nodes, parents first, each with what closes in the JSON after it."""
    left = [(root, root.name, "")]
    while left:
        behaviour, path, after = left.pop()
        yield SeenNode(behaviour, path, after)
        follows = f"]}}{after}"
        for child in reversed(behaviour.children):
            left.append((child, f"{path}{BETWEEN}{child.name}", follows))
            follows = ","
