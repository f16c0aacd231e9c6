"""A node of which something is not drawn, and what a picture says of that."""

from __future__ import annotations

from tandem.skills.ports.message import Count
from tandem.skills.ports.tasks import TreeNode


class FoldedNode(TreeNode):
    """A node as it is drawn; its path is that of the whole tree."""

    children: tuple[FoldedNode, ...] = ()
    recoveries: Count = 0
    """Steps of recoveries that are left out, here and in what is folded below."""
    nodes: Count = 0
    """Other nodes that are folded below."""

    @property
    def note(self) -> str:
        """What is left out, in words; empty when nothing is."""
        counts = ((self.nodes, "node", "nodes"), (self.recoveries, "recovery", "recoveries"))
        return ", ".join(f"+{count} {one if count == 1 else many}" for count, one, many in counts if count)


def note_of(node: TreeNode) -> str:
    """Return what is left out of a node, in words; empty when nothing is."""
    return node.note if isinstance(node, FoldedNode) else ""
