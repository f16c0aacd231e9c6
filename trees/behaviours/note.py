"""A leaf that notes something for later leaves, at once, and never fails."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status


class Note(Behaviour):
    """SUCCESS with what was noted in words.

    Args:
        name: unique in the tree.
        note: changes the board, and returns in words how.
    """

    def __init__(self, name: str, note: Callable[[], str]) -> None:
        super().__init__(name)
        self._note = note

    def update(self) -> Status:
        """Note it."""
        self.feedback_message = self._note()
        return Status.SUCCESS
