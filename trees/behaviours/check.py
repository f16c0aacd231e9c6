"""A condition: asks a question of what is known, at each tick, and moves nothing."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status


class Check(Behaviour):
    """SUCCESS when the question is answered with yes, FAILURE otherwise.

    Args:
        name: unique in the tree, and reads as a statement ("item held").
        holds: the question.
    """

    def __init__(self, name: str, holds: Callable[[], bool]) -> None:
        super().__init__(name)
        self._holds = holds

    def update(self) -> Status:
        """Ask."""
        yes = self._holds()
        self.feedback_message = "yes" if yes else "no"
        return Status.SUCCESS if yes else Status.FAILURE
