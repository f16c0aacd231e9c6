"""The running task's tree, read by what has changed.

A snapshot of a fetch has hundreds of nodes, and two that follow each other differ in
two or so. So of the second one only what differs becomes messages: a node that is the same as before has
been checked before.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Final, cast

from pydantic import Field, JsonValue
from pydantic_core import from_json

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.message import Message, RobotTime, read_leniently
from tandem.skills.ports.tasks import TREE, TreeNode, TreeSnapshot

Plain = dict[str, JsonValue]
State = list[JsonValue]
"""Of a node: its status, how it ended last, its message."""
STATES: Final = ("status", "last", "message")
CHILDREN: Final = "children"
_LEAF: Final = TreeNode(path="", name="", kind="action", type="").model_dump(mode="json")


class TreeNews(Message):
    """What a snapshot says."""

    head: TreeSnapshot
    """The snapshot. Its root has no children, unless it was read whole."""
    changed: dict[str, State] = Field(default_factory=dict)
    """Nodes that are otherwise than in the one before, by path."""
    whole: bool = False
    """Whether it was read whole: it has other nodes than the one before, or is the first."""

    @property
    def stamp(self) -> RobotTime | None:
        """The robot's time."""
        return self.head.stamp


class TreeEar:
    """Hears the tree. A snapshot that is none is refused as a whole, and what was known before stays.

    Args:
        bus: where it is told.
        decode: reads a whole one.
    """

    def __init__(self, bus: Bus, decode: Callable[[bytes], TreeSnapshot] = TREE.decode) -> None:
        self._decode = decode
        self._heard = Heard(bus, TREE.key, self._read, depth=1)
        self._plain: Plain | None = None
        self._payload = b""

    def take(self) -> TreeNews | None:
        """Return what the newest snapshot says; None when none has come since."""
        return next((news for _, news, _ in reversed(self._heard.take())), None)

    def last(self) -> TreeSnapshot | None:
        """Return the newest snapshot whole."""
        return self._decode(self._payload) if self._payload else None

    def forget(self) -> None:
        """Have the next snapshot read whole: somebody knows of another tree than the last one heard."""
        self._plain = None

    def close(self) -> None:
        """Stop hearing."""
        self._heard.close()

    def _read(self, payload: bytes) -> TreeNews:
        plain = from_json(payload, allow_inf_nan=False)
        try:
            news = self._changes(plain)
        except (TypeError, AttributeError, KeyError) as error:
            raise ValueError("no object where one belongs") from error
        if news is None:
            news = TreeNews(head=self._decode(payload), whole=True)
        self._plain, self._payload = plain, payload
        return news

    def _changes(self, plain: Plain) -> TreeNews | None:
        """Return what differs from the last one; None when the nodes are others."""
        if self._plain is None or plain["task"] != self._plain["task"]:
            return None
        changed = dict[str, State]()
        for node in _other_nodes(self._plain["root"], plain["root"]):
            if node is None:
                return None
            read = read_leniently(TreeNode, json.dumps({**node, CHILDREN: []}).encode())
            changed[read.path] = [str(read.status), str(read.last), read.message]
        head = read_leniently(TreeSnapshot, json.dumps({**plain, "root": _LEAF}).encode())
        return TreeNews(head=head, changed=changed)


def _other_nodes(before: JsonValue, now: JsonValue) -> Iterator[Plain | None]:
    """Yield the nodes whose own state differs; None where anything else of them does."""
    stack = [(before, now)]
    while stack:
        old, new = (cast("Plain", each) for each in stack.pop())
        if old == new:
            continue
        rest = (old.keys() | new.keys()).difference(STATES, (CHILDREN,))
        was, has = (cast("list[JsonValue]", each.get(CHILDREN, [])) for each in (old, new))
        if len(was) != len(has) or any(old.get(part) != new.get(part) for part in rest):
            yield None
            return
        if any(old.get(part) != new.get(part) for part in STATES):
            yield new
        stack.extend(zip(was, has, strict=True))
