"""Turns: who comes first goes first, the others wait until it has ended, however it did.

Two-arm thesis, 4.3: the asynchronous pick.
"""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator


class Turn:
    """One thing that one at a time may do: who does it, and who waits, in the order of coming."""

    def __init__(self) -> None:
        self._line: list[str] = []

    def take(self, whose: str) -> bool:
        """Stand in line, if not there yet; say whether it is this one's turn."""
        if whose not in self._line:
            self._line.append(whose)
        return self._line[0] == whose

    def give_back(self, whose: str) -> None:
        """Leave the line, or the turn."""
        if whose in self._line:
            self._line.remove(whose)

    @property
    def holder(self) -> str | None:
        """Whose turn it is."""
        return self._line[0] if self._line else None


class InTurn(Decorator):
    """RUNNING until it is its turn, then passes its child's status on; gives the turn back at the end.

    Args:
        name: unique in the tree.
        turn: shared by all that take turns.
        whose: who this is, in words.
        child: what is done when it is its turn.
    """

    def __init__(self, name: str, turn: Turn, whose: str, child: Behaviour) -> None:
        super().__init__(name, child)
        self._turn, self._whose = turn, whose

    def tick(self) -> Iterator[Behaviour]:
        """Wait for the turn, then tick the child."""
        if self._turn.take(self._whose):
            yield from super().tick()
            return
        self.status = Status.RUNNING
        self.feedback_message = f"waits until the {self._turn.holder} is done"
        yield self

    def update(self) -> Status:
        """Pass the child's status on."""
        self.feedback_message = self.decorated.feedback_message
        status: Status = self.decorated.status
        return status

    def terminate(self, new_status: Status) -> None:  # noqa: ARG002 - however it ended
        """Give the turn back."""
        self._turn.give_back(self._whose)
