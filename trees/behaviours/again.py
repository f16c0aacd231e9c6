"""Do something again while its failure is of a kind that allows it."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext


class Again(Decorator):
    """RUNNING until its child succeeds; FAILURE after ``times`` failures, or at once after another kind.

    Args:
        name: unique in the tree.
        context: keeps the failures.
        child: what is done again.
        times: how often at the most.
        goes_on: whether a failure allows another time.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        child: Behaviour,
        times: int,
        goes_on: Callable[[Failure], bool],
    ) -> None:
        super().__init__(name, child)
        self._context, self._times, self._goes_on = context, times, goes_on
        self._done = 0

    def initialise(self) -> None:
        """Begin to count."""
        self._done = 0

    def update(self) -> Status:
        """Count failures."""
        status: Status = self.decorated.status
        if status is not Status.FAILURE:
            self.feedback_message = self.decorated.feedback_message
            return status
        self._done += 1
        self.feedback_message = f"{self._done} of {self._times}"
        if self._done < self._times and self._goes_on(self._context.failures.last()):
            return Status.RUNNING
        return Status.FAILURE
