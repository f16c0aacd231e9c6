"""A large tree made small enough to read: recoveries, guards and whole subtrees folded, and counted.

Which nodes matter is a rule, not a list of names:

1. A recovery is its first child, what is tried; its steps are counted.
2. A guard, a condition beside the work that it may save, is left out.
3. A chain of nodes with one child each is one node: the phase of the task in it, or else the innermost, which
   does the work. It has the status of the outermost, which is what its parent sees.
4. Of what is left, phases and their steps are drawn, as much as fits a page; the rest is folded, and counted.

What runs is never left out. Every function returns a new tree; paths stay those of the whole tree.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from tandem.executive.render.folded import FoldedNode
from tandem.executive.render.layout import Layout, lay_out
from tandem.skills.ports.tasks import NodeStatus, TreeNode

PAGE: Final = (1123.0, 794.0)
"""Width and height of A4, landscape, in pixels of 1/96 inch. Text of 12 pixels is 9 points there."""
PHASE: Final = "Phase"
"""Type of the node that moves a task's progress, ``tandem.trees.behaviours.phase``."""


def whole(root: TreeNode) -> FoldedNode:
    """Return the tree with nothing left out."""
    return _copy(root, tuple(whole(child) for child in root.children))


def without_recoveries(root: FoldedNode) -> FoldedNode:
    """Return the tree with each recovery as what it tries; a step that runs stays."""
    kept = root.children
    if root.kind == "recovery":
        kept = (*kept[:1], *(step for step in kept[1:] if _runs(step)))
    hidden = len(root.children) - len(kept)
    return _copy(root, tuple(without_recoveries(child) for child in kept), recoveries=hidden)


def without_guards(root: FoldedNode) -> FoldedNode:
    """Return the tree without conditions beside work, and with chains below the root as one node."""
    work = [child for child in root.children if child.kind != "condition" or _runs(child)]
    return _copy(root, tuple(_merged(without_guards(child)) for child in (work or root.children)))


def to_depth(root: FoldedNode, depth: int) -> FoldedNode:
    """Return the tree down to ``depth`` levels below its root, and deeper where something runs."""
    if root.children and depth <= 0 and not _runs(root):
        return _folded(root)
    return _copy(root, tuple(to_depth(child, depth - 1) for child in root.children))


def levels_of(root: TreeNode) -> int:
    """Return how many levels the tree has; one for a leaf."""
    return 1 + max((levels_of(child) for child in root.children), default=0)


def outline(root: FoldedNode) -> FoldedNode:
    """Return as much of the tree as fits a page."""
    if fits(lay_out(root)):
        return root
    small = without_guards(without_recoveries(root))
    levels = levels_of(small)
    while levels > 0 and not fits(lay_out(_phases(small, levels))):
        levels -= 1
    return _phases(small, levels)


def fits(layout: Layout) -> bool:
    """Say whether a picture fits the page."""
    return layout.width <= PAGE[0] and layout.height <= PAGE[1]


def find(root: TreeNode, name: str) -> list[TreeNode]:
    """Return the node of this path; without one, the nodes of this name."""
    every = list(root.walk())
    return [each for each in every if each.path == name] or [each for each in every if each.name == name]


HIDES: Final[dict[str, Callable[[FoldedNode], FoldedNode]]] = {
    "recoveries": without_recoveries,
    "guards": without_guards,
}
"""What can be left out, by name."""


def _merged(node: FoldedNode) -> FoldedNode:
    """Return a node whose only child is merged with it."""
    if len(node.children) != 1 or (node.type == PHASE and _has_phase(node)):
        return node
    (inner,) = node.children
    chosen = node if node.type == PHASE else inner
    return chosen.model_copy(
        update={
            "status": node.status,
            "last": node.last,
            "message": inner.message or node.message,
            "children": inner.children,
            "recoveries": node.recoveries + inner.recoveries,
        }
    )


def _phases(root: FoldedNode, levels: int) -> FoldedNode:
    """Return phases and what is above them; of other nodes, so many levels."""
    if _has_phase(root) or (root.type == PHASE and levels > 0):
        inside = levels - 1 if root.type == PHASE else levels
        return _copy(root, tuple(_phases(child, inside) for child in root.children))
    return to_depth(root, levels)


def _has_phase(node: TreeNode) -> bool:
    return any(child.type == PHASE or _has_phase(child) for child in node.children)


def _folded(node: FoldedNode) -> FoldedNode:
    below = [_folded(child) for child in node.children]
    nodes = node.nodes + sum(1 + child.nodes for child in below)
    recoveries = node.recoveries + sum(child.recoveries for child in below)
    return node.model_copy(update={"children": (), "nodes": nodes, "recoveries": recoveries})


def _copy(node: TreeNode, children: tuple[FoldedNode, ...], recoveries: int = 0) -> FoldedNode:
    if isinstance(node, FoldedNode):
        more = {"children": children, "recoveries": node.recoveries + recoveries}
        return node.model_copy(update=more)
    return FoldedNode(**{**dict(node), "children": children})


def _runs(node: TreeNode) -> bool:
    return node.status is NodeStatus.RUNNING
