"""A running tree as data, made anew only where it has changed: most ticks change one branch of many."""

from __future__ import annotations

from collections.abc import Iterator
from enum import IntEnum
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.tasks import NodeStatus, TreeNode
from tandem.trees.snapshot import kind_of


class Change(IntEnum):
    """What is otherwise in a tree than at the last look; the most of it."""

    NONE = 0
    MESSAGE = 1
    """Nothing but what nodes say."""
    STATUS = 2
    """A node's status, how it ended, or which nodes there are."""


_STATUSES: Final = {each: NodeStatus(each.name) for each in Status}


class TreeView:
    """Looks at the tree below a behaviour, again and again.

    ``look`` returns what ``trees.snapshot.snapshot`` would, with how each node ended last, and the very same
    object as long as nothing has changed. Names and types of nodes don't change; children may be added and
    removed.
    """

    __slots__ = (
        "_behaviour",
        "_behaviours",
        "_children",
        "_ended",
        "_flat",
        "_last",
        "_message",
        "_node",
        "_path",
        "_status",
    )

    def __init__(
        self, behaviour: Behaviour, above: str = "", ended: dict[Behaviour, NodeStatus] | None = None
    ) -> None:
        """``above``: the path of its parent; ``ended``: how nodes ended, as the root's view has heeded it."""
        self._behaviour = behaviour
        self._ended = {} if ended is None else ended
        self._last = NodeStatus.INVALID
        self._path = f"{above}/{behaviour.name}" if above else behaviour.name
        self._behaviours: list[Behaviour] = []
        self._children: list[TreeView] = []
        self._status: Status | None = None
        self._message = ""
        self._node: TreeNode | None = None
        self._flat: tuple[TreeView, ...] = ()
        """All below, as of the last look, in the view that is asked alone. Itself would make a cycle."""

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

    def look(self) -> TreeNode:
        """Return the tree as it is now."""
        if self._node is None or self.change() is not Change.NONE:
            self._look()
            self._flat = tuple(self._below())
        assert self._node is not None, "a look makes it"
        return self._node

    def change(self) -> Change:
        """Say what a look would find: in one loop, as it is asked after each tick."""
        ended = self._ended.get
        never = NodeStatus.INVALID
        found = Change.NONE
        for view in (self, *self._flat):
            seen = view._behaviour  # noqa: SLF001 - one of us
            if (
                view._node is None  # noqa: SLF001
                or seen.status is not view._status  # noqa: SLF001
                or ended(seen, never) is not view._last  # noqa: SLF001
                or seen.children != view._behaviours  # noqa: SLF001
            ):
                return Change.STATUS
            if seen.feedback_message != view._message:  # noqa: SLF001
                found = Change.MESSAGE
        return found

    def _below(self) -> Iterator[TreeView]:
        for child in self._children:
            yield child
            yield from child._below()  # noqa: SLF001

    def _look(self) -> TreeNode:
        seen = self._behaviour
        if seen.children != self._behaviours:
            self._behaviours = list(seen.children)
            self._children = [TreeView(child, self._path, self._ended) for child in self._behaviours]
            self._node = None
        node, last = self._node, self._ended.get(seen, NodeStatus.INVALID)
        changed = (
            node is None
            or seen.status is not self._status
            or last is not self._last
            or seen.feedback_message != self._message
        )
        children: list[TreeNode] = []
        for child in self._children:
            before = child._node  # noqa: SLF001 - one of us
            now = child._look()  # noqa: SLF001
            changed = changed or now is not before
            children.append(now)
        if node is not None and not changed:
            return node
        self._status, self._last, self._message = seen.status, last, seen.feedback_message
        self._node = TreeNode(
            path=self._path,
            name=seen.name,
            kind=kind_of(seen) if node is None else node.kind,
            type=type(seen).__name__,
            status=_STATUSES[self._status],
            last=last,
            message=self._message,
            children=tuple(children),
        )
        return self._node
