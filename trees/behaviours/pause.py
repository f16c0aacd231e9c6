"""Let robot time pass, and do nothing."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.trees.context import TreeContext


class Pause(Behaviour):
    """RUNNING for so many robot seconds, then SUCCESS.

    Args:
        name: unique in the tree.
        context: its clock.
        seconds: robot seconds.
    """

    def __init__(self, name: str, context: TreeContext, seconds: float) -> None:
        super().__init__(name)
        self._context, self.seconds, self._since = context, seconds, 0.0

    def initialise(self) -> None:
        """Note the time."""
        self._since = self._context.seconds

    def update(self) -> Status:
        """Watch the time."""
        self.feedback_message = f"{self.waited:.1f} of {self.seconds:.0f} s"
        return Status.SUCCESS if self.waited >= self.seconds else Status.RUNNING

    @property
    def waited(self) -> float:
        """Robot seconds since it began."""
        return self._context.seconds - self._since
