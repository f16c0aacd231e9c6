"""Whether a run's tree looks otherwise than it was last shown."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from tandem.executive.service.running.tree_view import TreeView
from tandem.skills.ports.tasks import TreeNode
from tandem.trees.breakpoints import Breakpoints


class ShownTree:
    """A view of the tree, and what of it was shown.

    Args:
        root: the tree.
    """

    def __init__(self, root: Behaviour) -> None:
        self.view = TreeView(root)
        """The tree as data."""
        self.touched = False
        """Whether it may have changed since: it does only when it is ticked or stopped."""
        self._shown: TreeNode | None = None
        self._gates_shown = 0

    def turn_to(self, root: Behaviour) -> None:
        """Show another tree from now on."""
        self.view, self._shown, self.touched = TreeView(root), None, True

    def changed(self, gates: Breakpoints) -> bool:
        """Say whether a status, a message or a gate is another than at the last call."""
        gated, self._gates_shown = self._gates_shown != gates.changes, gates.changes
        if not (self.touched or gated):
            return False
        self.touched = False
        now = self.view.look()
        if now is self._shown and not gated:
            return False
        self._shown = now
        return True
