"""A decorator that says which phase of the task its child is."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.trees.context import TreeContext


class Phase(Decorator):
    """Passes its child's status on; entering and leaving it moves the task's progress.

    Args:
        name: the phase, as clients read it.
        context: keeps the progress.
        child: what is done in this phase.
        begins: the fraction of the task that is done when it begins.
        ends: the fraction that is done when it has succeeded.
    """

    def __init__(
        self, name: str, context: TreeContext, child: Behaviour, *, begins: float, ends: float
    ) -> None:
        super().__init__(name, child)
        self._context, self._begins, self._ends = context, begins, ends

    def initialise(self) -> None:
        """Enter the phase."""
        self._context.enter(self.name, self._begins)

    def update(self) -> Status:
        """Pass the child's status on."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        if status is Status.SUCCESS:
            self._context.enter(self.name, self._ends)
        return status
