"""Where a task may be interrupted: one of a higher priority may take over while this node's child works."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.trees.context import TreeContext


class Interruptible(Decorator):
    """Passes its child's status on; while that is RUNNING the task may be interrupted.

    The tree begins again afterwards, so what is inside must be work that its questions find done, or that may
    be done again.

    Args:
        name: unique in the tree.
        context: is told.
        child: what is done meanwhile.
    """

    def __init__(self, name: str, context: TreeContext, child: Behaviour) -> None:
        super().__init__(name, child)
        self._context = context

    def initialise(self) -> None:
        """Open the door."""
        self._context.open_doors[self.name] = None

    def terminate(self, new_status: Status) -> None:  # noqa: ARG002 - whatever it ended with
        """Close it."""
        self._context.open_doors.pop(self.name, None)

    def update(self) -> Status:
        """Pass the child's status on."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        return status
