"""Do the same for one after the other, until nothing is left to do."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator


class Each(Decorator):
    """RUNNING until ``done`` holds after a success of its child, at most ``times``; FAILURE when that fails.

    Args:
        name: unique in the tree.
        child: what is done for the one that is next.
        done: whether nothing is left to do.
        times: how many there are at the most.
    """

    def __init__(self, name: str, child: Behaviour, done: Callable[[], bool], times: int) -> None:
        super().__init__(name, child)
        self._is_done, self._times, self._count = done, times, 0

    def initialise(self) -> None:
        """Begin to count."""
        self._count = 0

    def update(self) -> Status:
        """Count successes."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        if status is not Status.SUCCESS:
            return status
        self._count += 1
        return Status.SUCCESS if self._is_done() or self._count >= self._times else Status.RUNNING
