"""A leaf that thinks, at once: it binds what later leaves need, or fails with a reason."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext


class Decide(Behaviour):
    """SUCCESS with what was decided in words, or FAILURE with the reason.

    Args:
        name: unique in the tree.
        context: keeps the failure.
        decide: returns the decision in words, or the failure.
    """

    def __init__(self, name: str, context: TreeContext, decide: Callable[[], str | Failure]) -> None:
        super().__init__(name)
        self._context, self._decide = context, decide
        self.failure: Failure | None = None

    def update(self) -> Status:
        """Decide."""
        decided = self._decide()
        if isinstance(decided, str):
            self.failure, self.feedback_message = None, decided
            return Status.SUCCESS
        self.failure = decided.model_copy(update={"where": f"{self.name}: {decided.where}".rstrip(": ")})
        self._context.failures.add(self.failure)
        self.feedback_message = f"{decided.kind}: {decided.message}"
        return Status.FAILURE
