"""A leaf that says why a part of the tree fails when nothing is left to try."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext


class GiveUp(Behaviour):
    """FAILURE with the reason.

    Args:
        name: unique in the tree.
        context: keeps the failure.
        reason: makes it from what is known then.
    """

    def __init__(self, name: str, context: TreeContext, reason: Callable[[], Failure]) -> None:
        super().__init__(name)
        self._context, self._reason = context, reason

    def update(self) -> Status:
        """Say why."""
        reason = self._reason()
        self._context.failures.add(reason.model_copy(update={"where": reason.where or self.name}))
        self.feedback_message = f"{reason.kind}: {reason.message}"
        return Status.FAILURE
