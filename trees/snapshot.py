"""A tree as data: names, kinds, statuses and messages, for viewers and for logs."""

from __future__ import annotations

from functools import cache
from typing import Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Parallel, Selector, Sequence
from py_trees.decorators import Decorator

from tandem.skills.ports.tasks import NodeStatus, TreeNode
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.meanwhile import Meanwhile
from tandem.trees.behaviours.recovery import Recovery
from tandem.trees.behaviours.side_by_side import SideBySide

Kind = Literal["sequence", "selector", "parallel", "recovery", "decorator", "condition", "action"]

_KINDS: Final[tuple[tuple[type[Behaviour], Kind], ...]] = (
    (Sequence, "sequence"),
    (Selector, "selector"),
    (Parallel, "parallel"),
    (SideBySide, "parallel"),
    (Meanwhile, "parallel"),
    (Recovery, "recovery"),
    (Decorator, "decorator"),
    (Check, "condition"),
)


def kind_of(node: Behaviour) -> Kind:
    """Return what a node is in the field's terms."""
    return _kind_of_class(type(node))


@cache
def _kind_of_class(which: type[Behaviour]) -> Kind:
    # py_trees' classes are abstract ones, for which isinstance is slow.
    return next((kind for cls, kind in _KINDS if issubclass(which, cls)), "action")


def snapshot(root: Behaviour, above: str = "") -> TreeNode:
    """Return the tree below ``root`` as data; a node's path is its names from the root."""
    path = f"{above}/{root.name}" if above else root.name
    return TreeNode(
        path=path,
        name=root.name,
        kind=kind_of(root),
        type=type(root).__name__,
        status=NodeStatus(root.status.name),
        message=root.feedback_message,
        children=tuple(snapshot(child, path) for child in root.children),
    )
