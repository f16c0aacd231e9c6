"""Take note, at each tick, of how what is below goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator


class Watching(Decorator):
    """Passes its child's status on, and calls ``note`` before each of its ticks.

    Args:
        name: unique in the tree.
        child: what goes on.
        note: takes note.
    """

    def __init__(self, name: str, child: Behaviour, note: Callable[[], None]) -> None:
        super().__init__(name, child)
        self._note = note

    def tick(self) -> Iterator[Behaviour]:
        """Take note, then tick the child."""
        self._note()
        yield from super().tick()

    def update(self) -> Status:
        """Pass the child's status on."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        return status
