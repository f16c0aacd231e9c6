"""Whether a run's tree looks otherwise than it was last shown."""

from __future__ import annotations

import math
from typing import Final

from py_trees.behaviour import Behaviour

from tandem.executive.service.running.tree_view import Change, TreeView
from tandem.trees.breakpoints import Breakpoints

WORDS_EVERY: Final = 0.5
"""Seconds between two showings of a tree in which only messages are others. A leaf says at each step of its
skill how far it is, and each showing is the whole tree: ``tandem bench fetch_time`` counts them."""


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
        self._unshown = Change.STATUS
        self._gates_shown, self._shown_at = 0, -math.inf

    def turn_to(self, root: Behaviour) -> None:
        """Show another tree from now on."""
        self.view, self.touched, self._unshown = TreeView(root), True, Change.STATUS

    def written(self) -> str:
        """Return the tree as it is now, as JSON, which does not count as showing it."""
        self._unshown = max(self._unshown, self.view.change())
        return self.view.written()

    def changed(self, gates: Breakpoints, now: float) -> bool:
        """Say whether to show it: a status or a gate is another than when it was shown, or messages are.

        Args:
            gates: where the task pauses, and which nodes are forced.
            now: seconds. Messages alone wait until the last showing is ``WORDS_EVERY`` old.
        """
        gated, self._gates_shown = self._gates_shown != gates.changes, gates.changes
        if not (self.touched or gated):
            return False
        change = self._unshown = max(self._unshown, self.view.change())
        if change is Change.MESSAGE and not gated and now - self._shown_at < WORDS_EVERY:
            return False
        self.touched = False
        if change is Change.NONE and not gated:
            return False
        self.view.look()
        self._unshown, self._shown_at = Change.NONE, now
        return True
