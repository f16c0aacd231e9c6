"""A node: everything with state, moved on by one call."""

from __future__ import annotations

from typing import Protocol


class Node(Protocol):
    """Fed by its inboxes, moved on by ``step``; the same node runs in a process and in lockstep."""

    @property
    def name(self) -> str:
        """A stable name, for logs."""
        ...

    def step(self) -> bool:
        """Read the inboxes and do one bounded piece of work (at most 5 ms).

        Returns:
            True when there is more to do at once, False when a message or the next period suffices.
        """
        ...

    def close(self) -> None:
        """Leave: bring what is running to rest, close the inboxes. Closing twice is allowed."""
        ...
